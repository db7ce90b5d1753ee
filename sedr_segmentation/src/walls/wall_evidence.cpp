// SPDX-License-Identifier: BSD-3-Clause
#include "wall_evidence.h"

#include "sedr_filters/src/base/exactness.h"
#include "sedr_filters/src/base/parallel_for.h"

#include <algorithm>
#include <cstdint>

namespace pcl::sedr {

namespace {

/** @brief Whether a point is part of something vertical: its column is occupied without
 * a gap over at least 20 cm there. */
bool
isVertical(const ColumnTable& columns,
           const CellGrid& grid,
           const Eigen::Vector3f& p,
           const Priors& priors)
{
  const double gap = priors.run_gap;
  const double min_length = 2 * priors.evidence_cell;
  const Cell cell = grid.at(p.x(), p.y());
  const ColumnTable::Entry* const begin = columns.begin(cell);
  const ColumnTable::Entry* const end = columns.end(cell);
  const auto isAfterGap = [&](const ColumnTable::Entry* e) {
    return e == begin || e->z - (e - 1)->z > gap;
  };
  const ColumnTable::Entry* low = std::lower_bound(
      begin, end, p.z(), [](const ColumnTable::Entry& e, float z) { return e.z < z; });
  if (low == end || (low->z > p.z() && isAfterGap(low)))
    return false;
  const ColumnTable::Entry* high = low + 1;
  while (!isAfterGap(low))
    --low;
  while (high != end && !isAfterGap(high))
    ++high;
  return (high - 1)->z - low->z >= min_length;
}

/** @brief Adds those of the indices that are asked for, in their order; asked on
 * several threads. */
template <typename Asked>
void
appendThose(const std::vector<int>& indices,
            Asked asked,
            unsigned threads,
            std::vector<int>& those)
{
  std::vector<std::uint8_t> is_asked(indices.size());
  parallelFor(indices.size(), points_a_block, threads,
              [&](std::size_t k) { is_asked[k] = asked(indices[k]) ? 1 : 0; });
  those.reserve(those.size() + static_cast<std::size_t>(
                                   std::count(is_asked.begin(), is_asked.end(), 1)));
  for (std::size_t k = 0; k < indices.size(); ++k)
    if (is_asked[k])
      those.push_back(indices[k]);
}

} // namespace

std::vector<VerticalPlace>
verticalPlaces(const PointView& points,
               const std::vector<int>& indices,
               const PlanRoom& room,
               const ColumnTable& columns,
               const CellGrid& grid,
               unsigned threads,
               const Priors& priors)
{
  const auto placeOf = [&](int i) -> Eigen::Vector2d {
    return points[static_cast<std::size_t>(i)].head<2>().cast<double>();
  };
  const auto isWall = [&](int i) {
    const Eigen::Vector3f p = points[static_cast<std::size_t>(i)];
    const double top = room.ceiling.heightAt(placeOf(i));
    const double middle = (room.floor.heightAt(placeOf(i)) + top) / 2;
    return p.z() > middle && p.z() < top - priors.wall_band &&
           isVertical(columns, grid, p, priors);
  };
  std::vector<int> on_walls;
  appendThose(indices, isWall, threads, on_walls);
  std::vector<VerticalPlace> upper;
  upper.reserve(on_walls.size());
  for (const int i : on_walls) {
    const Eigen::Vector2d place = placeOf(i);
    const float z = points[static_cast<std::size_t>(i)].z();
    upper.push_back({place, room.ceiling.heightAt(place) - z});
  }
  return upper;
}

PlanPoints
inPlan(const std::vector<VerticalPlace>& places)
{
  std::vector<Eigen::Vector2d> points;
  points.reserve(places.size());
  for (const VerticalPlace& vertical : places)
    points.push_back(vertical.place);
  return {std::move(points), 0.1};
}

std::vector<int>
wallEvidence(const PointView& points,
             const RoomEvidence& evidence,
             const CellMask& room,
             const CellGrid& grid,
             double tolerance,
             unsigned threads)
{
  const CellMask edge = subtract(dilated(room, 1), eroded(room, 1));
  std::vector<int> walls = evidence.walls;
  const auto place = [&](int i) -> Eigen::Vector2d {
    return points[static_cast<std::size_t>(i)].head<2>().cast<double>();
  };
  const auto own = static_cast<std::ptrdiff_t>(walls.size());
  appendThose(
      evidence.around,
      [&](int i) { return edge.at(grid.at(place(i).x(), place(i).y())); }, threads,
      walls);
  const auto sortPart = [](auto begin, auto end) {
    if (!std::is_sorted(begin, end)) // as indices mostly are
      std::sort(begin, end);
  };
  sortPart(walls.begin(), walls.begin() + own);
  sortPart(walls.begin() + own, walls.end());
  std::inplace_merge(walls.begin(), walls.begin() + own, walls.end());
  walls.erase(std::unique(walls.begin(), walls.end()), walls.end());
  const auto isOfOthers = [&](int i) {
    return std::any_of(
        evidence.faces_of_others.begin(), evidence.faces_of_others.end(),
        [&](const PlanElement& e) { return e.distance(place(i)) < tolerance; });
  };
  walls.erase(std::remove_if(walls.begin(), walls.end(), isOfOthers), walls.end());
  return walls;
}

std::vector<int>
besides(const CellMask& furniture,
        const PointView& points,
        const std::vector<int>& indices,
        const CellGrid& grid,
        unsigned threads)
{
  const auto isBeside = [&](int i) {
    const Eigen::Vector3f p = points[static_cast<std::size_t>(i)];
    return !grid.holds(p.x(), p.y()) || !furniture.at(grid.at(p.x(), p.y()));
  };
  std::vector<int> rest;
  appendThose(indices, isBeside, threads, rest);
  return rest;
}

} // namespace pcl::sedr
