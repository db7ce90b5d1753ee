// SPDX-License-Identifier: BSD-3-Clause
#include "cell_mask.h"

#include <algorithm>
#include <limits>

namespace pcl::sedr {

namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

/** @brief Lower envelope of the parabolas (x - i)^2 + f[i], sampled at the integers.
 * This is one pass of the distance transform along a row or column of n values,
 * `stride` apart. */
class ParabolaPass {
public:
  explicit ParabolaPass(std::size_t n)
      : values_(n)
      , apex_(n)
      , from_(n + 1)
  {}

  void run(float* f, std::size_t n, std::size_t stride)
  {
    std::size_t k = 0;
    bool has_any = false;
    for (std::size_t q = 0; q < n; ++q) {
      values_[q] = f[q * stride];
      if (values_[q] == infinite)
        continue;
      if (!has_any) {
        has_any = true;
        apex_[0] = q;
        from_[0] = -infinite;
        from_[1] = infinite;
        continue;
      }
      float crossing = crossingOf(q, apex_[k]);
      while (crossing <= from_[k])
        crossing = crossingOf(q, apex_[--k]);
      apex_[++k] = q;
      from_[k] = crossing;
      from_[k + 1] = infinite;
    }
    if (!has_any)
      return;
    k = 0;
    for (std::size_t q = 0; q < n; ++q) {
      while (from_[k + 1] < static_cast<float>(q))
        ++k;
      const float d = static_cast<float>(q) - static_cast<float>(apex_[k]);
      f[q * stride] = d * d + values_[apex_[k]];
    }
  }

private:
  float crossingOf(std::size_t q, std::size_t p) const
  {
    const double fq = values_[q] + static_cast<double>(q) * static_cast<double>(q);
    const double fp = values_[p] + static_cast<double>(p) * static_cast<double>(p);
    return static_cast<float>(
        (fq - fp) / (2.0 * (static_cast<double>(q) - static_cast<double>(p))));
  }

  std::vector<float> values_;
  std::vector<std::size_t> apex_;
  std::vector<float> from_;
};

} // namespace

std::vector<float>
squaredDistances(const CellMask& mask)
{
  const auto width = static_cast<std::size_t>(mask.width());
  const auto height = static_cast<std::size_t>(mask.height());
  std::vector<float> distances(mask.values().size());
  for (std::size_t i = 0; i < distances.size(); ++i)
    distances[i] = mask.values()[i] ? 0.f : infinite;
  ParabolaPass pass(std::max(width, height));
  for (std::size_t x = 0; x < width; ++x)
    pass.run(distances.data() + x, height, width);
  for (std::size_t y = 0; y < height; ++y)
    pass.run(distances.data() + y * width, width, 1);
  return distances;
}

CellMask
dilated(const CellMask& mask, double radius)
{
  const std::vector<float> distances = squaredDistances(mask);
  CellMask result(mask.box());
  for (std::size_t i = 0; i < distances.size(); ++i)
    result.values()[i] = distances[i] <= radius * radius ? 1 : 0;
  return result;
}

CellMask
eroded(const CellMask& mask, double radius)
{
  if (mask.values().empty())
    return mask;
  // The cells around the box count as not set.
  const CellMask outside =
      dilated(inverted(cropped(mask, grown(mask.box(), 1))), radius);
  return inverted(cropped(outside, mask.box()));
}

} // namespace pcl::sedr
