// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/cell_mask.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace pcl {
namespace sedr {

namespace {

/** @brief The largest whole number up to `most` whose square is at most `square`; -1 if
 * that is below 0. */
std::int32_t
rootOf(double square, std::int32_t most)
{
  std::int32_t root = most;
  if (square < 0)
    return -1;
  if (square < static_cast<double>(most) * most)
    root = static_cast<std::int32_t>(std::sqrt(square)) + 1;
  while (static_cast<double>(root) * root > square)
    --root;
  return root;
}

/** @brief For each cell, how far the nearest set one of its column is, up to `most`. */
std::vector<std::int32_t>
distancesInColumns(const CellMask& mask, std::int32_t most)
{
  const auto width = static_cast<std::size_t>(mask.width());
  const auto height = static_cast<std::size_t>(mask.height());
  const std::uint8_t* values = mask.values().data();
  std::vector<std::int32_t> distances(width * height);
  for (std::size_t i = 0; i < width * height; ++i)
    distances[i] = values[i] ? 0 : most;
  for (std::size_t i = width; i < width * height; ++i)
    distances[i] = std::min(distances[i], distances[i - width] + 1);
  for (std::size_t i = width * height; i-- > width;)
    distances[i - width] = std::min(distances[i - width], distances[i] + 1);
  return distances;
}

} // namespace

/** @brief Every cell covers a stretch of each row, the shorter the farther the row: a
 * cell is covered where a stretch that starts before it reaches it, or one that ends
 * behind it. O(cells). */
CellMask
dilated(const CellMask& mask, double radius)
{
  const double square = radius * radius;
  const std::int32_t far = rootOf(square, std::max(mask.width(), mask.height()));
  std::vector<std::int32_t> half; // of the stretch in a row so far away; -1 is none
  for (std::int32_t d = 0; d <= far; ++d)
    half.push_back(rootOf(square - static_cast<double>(d) * d, mask.width()));
  half.push_back(-1);
  const std::vector<std::int32_t> distances = distancesInColumns(mask, far + 1);
  CellMask result(mask.box());
  const std::int32_t width = mask.width();
  for (std::int32_t y = 0; y < mask.height(); ++y) {
    const std::int32_t* row = distances.data() + std::ptrdiff_t{y} * width;
    std::uint8_t* covered = result.values().data() + std::ptrdiff_t{y} * width;
    const auto reachOf = [&](std::int32_t x) {
      return half[static_cast<std::size_t>(row[x])];
    };
    std::int32_t left = -1; // cells that are still covered
    for (std::int32_t x = 0; x < width; ++x, --left) {
      left = std::max(left, reachOf(x));
      covered[x] = left >= 0 ? 1 : 0;
    }
    left = -1;
    for (std::int32_t x = width; x-- > 0; --left) {
      left = std::max(left, reachOf(x));
      covered[x] |= left >= 0 ? 1 : 0;
    }
  }
  return result;
}

CellMask
eroded(const CellMask& mask, double radius)
{
  // A rim of cells that are not set stands for what lies outside.
  const CellMask outside = inverted(cropped(mask, grown(mask.box(), 1)));
  return inverted(cropped(dilated(outside, radius), mask.box()));
}

} // namespace sedr
} // namespace pcl
