// SPDX-License-Identifier: BSD-3-Clause
#include "air_bounds.h"

#include "storey_lines.h"

#include <algorithm>
#include <utility>

namespace pcl::sedr {

namespace {

bool
isWithin(const PlanCells::Polygon& polygon, const Eigen::Vector2d& p)
{
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& next = polygon[(i + 1) % polygon.size()];
    if (leftOf(next - polygon[i]).dot(p - polygon[i]) < 0)
      return false;
  }
  return true;
}

/** @brief Marks the seen cells of a room that lie in cells at the edge. */
CellMask
unboundedAir(const CellMask& seen, const CellGrid& grid, const PlanCells& arrangement)
{
  CellMask unbounded(seen.box());
  for (std::size_t c = 0; c < arrangement.polygons().size(); ++c) {
    if (!arrangement.isAtEdge(c))
      continue;
    const PlanCells::Polygon& polygon = arrangement.polygons()[c];
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector2d& p : polygon)
      box.extend(p);
    const CellBox part = overlapOf(seen.box(), {grid.at(box.min().x(), box.min().y()),
                                                grid.at(box.max().x(), box.max().y())});
    for (int y = part.low.y; y <= part.high.y; ++y)
      for (int x = part.low.x; x <= part.high.x; ++x)
        if (seen.at({x, y}) && isWithin(polygon, grid.centre({x, y})))
          unbounded.set({x, y}, 1);
  }
  return unbounded;
}

/** @brief Returns the ends of what lies evenly along an axis, but for its rim. */
std::pair<double, double>
endsOf(std::vector<double> offsets)
{
  constexpr double rim = 0.02; // share of them at each end
  std::sort(offsets.begin(), offsets.end());
  const auto at = [&](double share) {
    return offsets[static_cast<std::size_t>(share *
                                            static_cast<double>(offsets.size() - 1))];
  };
  const double low = at(rim);
  const double high = at(1 - rim);
  const double beyond = (high - low) * rim / (1 - 2 * rim);
  return {low - beyond, high + beyond};
}

} // namespace

std::vector<StoreyLine>
airBounds(const StoreyEvidence& evidence,
          const std::vector<StoreyLine>& lines,
          const PlanCells& arrangement)
{
  constexpr double least = 1; // square metres of air
  std::vector<StoreyLine> bounds;
  const auto straight =
      std::find_if(lines.begin(), lines.end(), [](const StoreyLine& line) {
        return line.is_main && !line.curve.isCircle();
      });
  const Eigen::Vector2d along = straight == lines.end()
                                    ? Eigen::Vector2d::UnitX().eval()
                                    : straight->curve.direction;
  const CellGrid& grid = evidence.grid;
  for (const std::size_t r : evidence.storey.rooms) {
    const CellMask air = unboundedAir(evidence.cells[r].seen, grid, arrangement);
    const MaskRegions regions = labelRegions(air, false);
    std::vector<std::vector<Eigen::Vector2d>> places(regions.sizes.size());
    for (std::size_t i = 0; i < air.values().size(); ++i)
      if (regions.label[i] >= 0)
        places[static_cast<std::size_t>(regions.label[i])].push_back(
            grid.centre(air.cellAt(i)));
    for (const std::vector<Eigen::Vector2d>& part : places) {
      if (static_cast<double>(part.size()) * grid.size() * grid.size() < least)
        continue;
      std::pair<double, double> ends[2];
      const Eigen::Vector2d axes[] = {along, leftOf(along)};
      for (const int axis : {0, 1}) {
        std::vector<double> offsets;
        for (const Eigen::Vector2d& p : part)
          offsets.push_back(axes[axis].dot(p));
        ends[axis] = endsOf(std::move(offsets));
      }
      for (const int axis : {0, 1})
        for (const double end : {ends[axis].first, ends[axis].second}) {
          const auto& [from, to] = ends[1 - axis];
          bounds.push_back(endLine(end * axes[axis] + (from + to) / 2 * axes[1 - axis],
                                   axes[1 - axis], (to - from) / 2 + evidence.max_wall,
                                   (to - from) / 2, evidence.near));
        }
    }
  }
  return bounds;
}

} // namespace pcl::sedr
