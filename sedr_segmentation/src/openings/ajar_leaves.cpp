// SPDX-License-Identifier: BSD-3-Clause
#include "ajar_leaves.h"

#include "sedr_filters/src/base/quantiles.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief How far from the face the points of each column are; NaN where they are not
 * at one distance, as on a vertical surface. */
std::vector<double>
distancesOf(const std::vector<SidePoint>& points,
            const WallSide& side,
            double cell,
            const OpeningSizes& sizes)
{
  std::vector<std::vector<double>> offsets(
      static_cast<std::size_t>(std::ceil(side.line.length() / cell)));
  for (const SidePoint& p : points)
    if (p.along >= 0 && p.offset > -opening_numbers.on_face &&
        p.height > side.floor + 2 * sizes.leaf_margin &&
        p.height < side.floor + sizes.min_head)
      if (const auto c = static_cast<std::size_t>(p.along / cell); c < offsets.size())
        offsets[c].push_back(p.offset);
  std::vector<double> distances;
  for (std::vector<double>& column : offsets) {
    distances.push_back(std::numeric_limits<double>::quiet_NaN());
    if (static_cast<double>(column.size()) < opening_numbers.cell_points)
      continue;
    const double middle = middleValue(column);
    const auto on = std::count_if(column.begin(), column.end(), [&](double offset) {
      return std::abs(offset - middle) < 2 * sizes.leaf_strip;
    });
    if (2 * on > static_cast<std::ptrdiff_t>(column.size()))
      distances.back() = middle;
  }
  return distances;
}

/** @brief A leaf, seen from above. */
struct LeafLine {
  double hinge = 0; ///< along the wall
  double end = 0;   ///< along the wall, of its free edge
  double slope = 0; ///< off the face for each metre along, towards the free edge

  double distanceAt(double along) const { return slope * std::abs(along - hinge); }

  /** @brief Checks whether a point is on it.
   * @param strip half of the depth of its points */
  bool holds(const SidePoint& p, double strip) const
  {
    return p.along > std::min(hinge, end) && p.along < std::max(hinge, end) &&
           p.offset > -strip && std::abs(p.offset - distanceAt(p.along)) < strip;
  }
};

/** @brief Returns the line through the distances of some columns, by least squares. */
LeafLine
leafThrough(const std::vector<double>& distances,
            std::size_t first,
            std::size_t last,
            double cell)
{
  const auto n = static_cast<double>(last - first);
  const double middle = cell * (static_cast<double>(first) + n / 2);
  double distance = 0;
  double squares = 0;
  double products = 0;
  for (std::size_t c = first; c < last; ++c) {
    const double s = cell * (static_cast<double>(c) + 0.5) - middle;
    distance += distances[c] / n;
    squares += s * s;
    products += s * distances[c];
  }
  const double slope = products / squares;
  return {middle - distance / slope,
          cell * static_cast<double>(slope > 0 ? last : first), std::abs(slope)};
}

/** @brief Checks whether the face was seen in most of the columns beside a leaf's
 * hinge, as far as the wall goes. */
bool
isFaceBeside(const std::vector<double>& distances,
             const LeafLine& leaf,
             double cell,
             const OpeningSizes& sizes)
{
  const double away = leaf.hinge < leaf.end ? -1 : 1;
  int seen = 0;
  int all = 0;
  for (double way = cell / 2; way < 2 * sizes.leaf_margin; way += cell) {
    const double along = leaf.hinge + away * way;
    if (along < 0 || along >= cell * static_cast<double>(distances.size()))
      break;
    ++all;
    seen += std::abs(distances[static_cast<std::size_t>(along / cell)]) <
                    opening_numbers.on_face
                ? 1
                : 0;
  }
  return 2 * seen >= all;
}

/** @brief Returns the leaves among runs of columns off the face. */
std::vector<LeafLine>
leavesAmong(const std::vector<double>& distances,
            double cell,
            const OpeningSizes& sizes)
{
  const auto isOff = [&](std::size_t c) {
    return c < distances.size() && distances[c] > sizes.leaf_strip; // NaN is not
  };
  std::vector<LeafLine> leaves;
  for (std::size_t first = 0; first < distances.size(); ++first) {
    std::size_t last = first;
    while (isOff(last))
      ++last;
    // The outermost columns may hold an edge, so two more are needed between them.
    if (last - first > 3) {
      LeafLine leaf = leafThrough(distances, first + 1, last - 1, cell);
      const bool is_first = leaf.hinge < leaf.end;
      leaf.end = cell * static_cast<double>(is_first ? last : first);
      const double start = cell * static_cast<double>(is_first ? first : last);
      const double way = std::abs(leaf.end - leaf.hinge);
      const double width = std::hypot(1, leaf.slope) * way;
      bool is_even = true;
      for (std::size_t c = first + 1; c + 1 < last; ++c)
        is_even =
            is_even && std::abs(leaf.distanceAt(cell * (static_cast<double>(c) + 0.5)) -
                                distances[c]) < sizes.leaf_strip;
      if (is_even && width > sizes.min_double / 2 && width < sizes.max_leaf &&
          leaf.slope * way > sizes.beside && std::atan(leaf.slope) < sizes.max_ajar &&
          std::abs(leaf.hinge - start) < 2 * sizes.leaf_margin &&
          isFaceBeside(distances, leaf, cell, sizes))
        leaves.push_back(leaf);
    }
    first = last;
  }
  return leaves;
}

} // namespace

std::vector<SidePoint>
takeAjarLeaves(std::vector<SidePoint>& points,
               const WallSide& side,
               double cell,
               const OpeningSizes& sizes)
{
  std::vector<SidePoint> taken;
  if (!side.may_have_openings || side.line.isArc())
    return taken;
  for (const LeafLine& leaf :
       leavesAmong(distancesOf(points, side, cell, sizes), cell, sizes)) {
    const auto first =
        std::stable_partition(points.begin(), points.end(), [&](const SidePoint& p) {
          return p.height < side.floor + opening_numbers.slab_band ||
                 p.height > side.ceiling - opening_numbers.slab_band ||
                 !leaf.holds(p, sizes.leaf_strip);
        });
    std::vector<Weighted> heights;
    std::transform(first, points.end(), std::back_inserter(heights),
                   [](const SidePoint& p) { return Weighted(p.height, 1); });
    // A tenth of a door is above what is lower.
    if (weightedQuantile(std::move(heights), 0.9) <
        side.floor + sizes.min_head - sizes.leaf_margin)
      continue;
    taken.insert(taken.end(), first, points.end());
    points.erase(first, points.end());
  }
  return taken;
}

} // namespace pcl::sedr
