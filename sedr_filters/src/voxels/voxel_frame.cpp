// SPDX-License-Identifier: BSD-3-Clause
#include "voxel_frame.h"

/** @brief Compiles a function twice, also for processors with AVX2; the loader chooses
 * one at program start. Only the loader of glibc can, and too early for a thread
 * sanitizer. All products are by powers of two and exact, so both give the same result.
 */
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) &&                 \
    defined(__GLIBC__) && !defined(__SANITIZE_THREAD__)
#define SEDR_FOR_WIDE_VECTORS_TOO __attribute__((target_clones("avx2", "default")))
#else
#define SEDR_FOR_WIDE_VECTORS_TOO
#endif

namespace pcl::sedr {

SEDR_FOR_WIDE_VECTORS_TOO void
VoxelFrame::find(std::size_t axis,
                 const float* values,
                 std::size_t n,
                 std::int32_t* codes,
                 std::uint64_t* steps) const
{
  const float inverse = inverse_leaf_[static_cast<Eigen::Index>(axis)];
  const std::uint32_t limit = bitsOf(static_cast<float>(near_limit));
  std::uint32_t far = 0;
  for (std::size_t i = 0; i < n; ++i) { // without branches, so that it vectorises
    const float scaled = values[i] * inverse;
    const std::uint32_t is_far = bitsOf(std::abs(scaled)) >= limit ? 1 : 0;
    far |= is_far;
    const float held = floatOf(bitsOf(scaled) & (is_far - 1));
    const auto cell = static_cast<std::int32_t>(held);
    codes[i] = cell - (held < static_cast<float>(cell) ? 1 : 0);
  }
  for (std::size_t i = 0; i < n; ++i)
    steps[i] = nearSteps(values[i], axis);
  if (far == 0)
    return;
  for (std::size_t i = 0; i < n; ++i) {
    codes[i] = codeOf(values[i] * inverse);
    steps[i] = this->steps(values[i], axis, codes[i]);
  }
}

} // namespace pcl::sedr
