// SPDX-License-Identifier: BSD-3-Clause
#include "cell_mask.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

namespace {

/** @brief Returns the largest integer up to `most` whose square is at most `square`; -1
 * if `square` is below 0. */
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

/** @brief Returns for each cell the number of rows up to the nearest set (or unset)
 * cell of its column, at most `most`. `beside` is the value of the row above the box.
 */
std::vector<std::int32_t>
distancesAbove(const CellMask& mask,
               bool is_set,
               std::int32_t beside,
               std::int32_t most)
{
  const auto width = static_cast<std::size_t>(mask.width());
  std::vector<std::int32_t> distances(mask.values().size());
  std::vector<std::int32_t> row(width, beside);
  for (std::size_t i = 0; i < distances.size(); i += width) {
    const std::uint8_t* const values = mask.values().data() + i;
    std::int32_t* const nearest = row.data();
    for (std::size_t x = 0; x < width; ++x)
      nearest[x] = (values[x] != 0) == is_set ? 0 : std::min(nearest[x] + 1, most);
    std::copy(row.begin(), row.end(),
              distances.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return distances;
}

/** @brief Marks the cells within a radius of the set cells, or of the unset cells,
 * which include all cells outside the box.
 *
 * A set cell covers an interval of each row, shorter in rows farther away. A cell is
 * covered if an interval centred to its left or right reaches it. O(cells). */
CellMask
nearThose(const CellMask& mask, bool is_set, double radius)
{
  const double square = radius * radius;
  const std::int32_t far = rootOf(square, std::max(mask.width(), mask.height()));
  std::vector<std::int32_t> half; // half interval at this row distance; -1: none
  for (std::int32_t d = 0; d <= far; ++d)
    half.push_back(rootOf(square - static_cast<double>(d) * d, mask.width()));
  half.push_back(-1);
  const std::int32_t beside = is_set ? far + 1 : 0;
  const std::vector<std::int32_t> above = distancesAbove(mask, is_set, beside, far + 1);
  CellMask result(mask.box());
  const std::ptrdiff_t width = mask.width();
  std::vector<std::int32_t> nearest(static_cast<std::size_t>(width), beside);
  for (std::ptrdiff_t y = mask.height(); y-- > 0;) {
    std::int32_t* const row = nearest.data();
    for (std::ptrdiff_t x = 0; x < width; ++x)
      row[x] = std::min(above[static_cast<std::size_t>(y * width + x)], row[x] + 1);
    std::uint8_t* const covered = result.values().data() + y * width;
    const std::int32_t* const reach = half.data();
    std::int32_t ahead = reach[beside] - 1; // number of cells still covered
    std::int32_t behind = ahead;
    for (std::ptrdiff_t x = 0, back = width - 1; x < width; ++x, --back) {
      ahead = std::max(ahead, reach[row[x]]);
      behind = std::max(behind, reach[row[back]]);
      covered[x] |= ahead-- >= 0 ? 1 : 0;
      covered[back] |= behind-- >= 0 ? 1 : 0;
    }
  }
  return result;
}

} // namespace

CellMask
dilated(const CellMask& mask, double radius)
{
  return nearThose(mask, true, radius);
}

CellMask
eroded(const CellMask& mask, double radius)
{
  return inverted(nearThose(mask, false, radius));
}

} // namespace pcl::sedr
