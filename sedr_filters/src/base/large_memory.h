// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace pcl::sedr {

/** @brief Size of a large page, bytes. */
constexpr std::size_t large_page = std::size_t{1} << 21;

/** @brief Announces that all of this memory will soon be written for the first time.
 * The system may then use large pages, which saves most of the time. Only a hint. */
void expectLarge(void* begin, std::size_t bytes);

/** @brief Makes the system provide fresh memory on up to `threads` threads (0 = all),
 * by large pages if it can. Writing to it later does not wait for the system. Sets some
 * of its bytes to zero. */
void takeLarge(void* begin, std::size_t bytes, unsigned threads);

/** @brief Clears a vector, and reserves and touches the memory for `size` values of a
 * plain type, before it is filled. O(bytes); `threads` 0 = all. */
template <typename Values>
void
reserveLarge(Values& values, std::size_t size, unsigned threads)
{
  values.clear();
  values.reserve(size);
  takeLarge(values.data(), size * sizeof(typename Values::value_type), threads);
}

} // namespace pcl::sedr
