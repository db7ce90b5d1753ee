// SPDX-License-Identifier: BSD-3-Clause
#include "detail_risers.h"

#include "../profiles/ceiling_gap.h"
#include "../profiles/cell_count.h"
#include "sedr_filters/src/base/plane_fit.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

namespace pcl::sedr {

namespace {

constexpr Cell sides[] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};

/** @brief Minimum and maximum slab height around a cell; no step with only one slab. */
struct StepBeside {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  bool isStep(const Priors& priors) const
  {
    return high - low >= priors.min_ceiling_step;
  }
};

/** @brief Returns the step within two cells of a cell of a map. */
StepBeside
stepBeside(const HeightMap& map, const CellGrid& grid, Cell cell)
{
  StepBeside step;
  std::int32_t last = -1;
  for (int dy = -2; dy <= 2; ++dy)
    for (int dx = -2; dx <= 2; ++dx) {
      const Cell near{cell.x + dx, cell.y + dy};
      const std::int32_t label =
          map.room.at(near) ? map.label[map.room.indexOf(near)] : -1;
      if (label < 0 || label == last)
        continue;
      last = label;
      const double height = map.slabOf(label).heightAt(grid.centre(cell));
      step.low = std::min(step.low, height);
      step.high = std::max(step.high, height);
    }
  return step;
}

/** @brief Returns the steps within two cells of all cells of a map, row by row. */
std::vector<StepBeside>
stepsBeside(const HeightMap& map, const CellGrid& grid)
{
  std::vector<StepBeside> steps;
  steps.reserve(map.label.size());
  for (std::size_t i = 0; i < map.label.size(); ++i)
    steps.push_back(stepBeside(map, grid, map.room.cellAt(i)));
  return steps;
}

/** @brief Returns whether the surface at a point extends beyond the riser between two
 * heights, like a shelf in front of it. */
bool
goesOn(const ColumnTable& columns,
       Cell cell,
       double z,
       double low,
       double high,
       bool is_floor,
       const Priors& priors)
{
  constexpr double gap = 0.12;
  const double beyond = priors.run_gap;
  const std::vector<ColumnRun> runs = columns.runs(cell, gap);
  return std::any_of(runs.begin(), runs.end(), [&](const ColumnRun& run) {
    return run.low <= z && z <= run.high &&
           (is_floor ? run.high > high + beyond : run.low < low - beyond);
  });
}

/** @brief Returns whether a point is at the height of any slab of the floor, such as a
 * barely visible tread in front of a platform. */
bool
isOnFloor(const HeightMap& map, const Eigen::Vector3f& p, double margin)
{
  return std::abs(distanceAbove(map.main, p)) <= margin ||
         std::any_of(map.details.begin(), map.details.end(), [&](const PlanSlab& slab) {
           return std::abs(distanceAbove(slab, p)) <= margin;
         });
}

/** @brief Returns whether a point is at the height of a nearby slab. Distant slabs do
 * not matter: the coffers of a ceiling may have many heights. */
bool
isOnSlabAround(const HeightMap& map, Cell cell, const Eigen::Vector3f& p, double margin)
{
  const auto reach = static_cast<int>(map.priors.riser_cells) + 1;
  for (int dy = -reach; dy <= reach; ++dy)
    for (int dx = -reach; dx <= reach; ++dx) {
      const Cell near{cell.x + dx, cell.y + dy};
      const std::int32_t label =
          map.room.at(near) ? map.label[map.room.indexOf(near)] : -1;
      if (label >= 0 && std::abs(distanceAbove(map.slabOf(label), p)) <= margin)
        return true;
    }
  return false;
}

/** @brief Returns whether the riser at a ceiling step reaches the higher side; a duct
 * ends below. True if the step is too low to decide. */
bool
reachesCeiling(const ColumnTable& columns,
               Cell cell,
               double low,
               double high,
               const PlanSlab& higher,
               const Priors& priors)
{
  const double min_body = priors.wall_band; // minimum riser below the gap
  const CeilingGap gap = gapBelow(higher);
  return high - gap.low < low + min_body ||
         columns.share(cell, high - gap.low, high - gap.high, 1, 2) >= 1;
}

/** @brief Returns whether risers close at least half of the edge between a detail and
 * its neighbours, apart from where a lower ceiling hides the higher one and its riser.
 * A shelf below a soffit has no riser, and that of a duct ends below the ceiling;
 * neither is a detail. The riser of a recess is seen only from inside it; walls seen
 * above the main ceiling close a recess too, but not a missing tile or a reflection. */
bool
hasRisers(const HeightMap& map,
          const ColumnTable& columns,
          const CellGrid& grid,
          bool is_floor,
          std::int32_t label)
{
  std::size_t edges = 0;
  std::size_t closed = 0;
  for (std::size_t i = 0; i < map.label.size(); ++i) {
    if (map.label[i] != label)
      continue;
    const Cell cell = map.room.cellAt(i);
    for (const Cell d : sides) {
      const Cell to{cell.x + d.x, cell.y + d.y};
      const bool is_wall = !map.room.at(to);
      const std::int32_t other = is_wall ? 0 : map.label[map.room.indexOf(to)];
      if (other < 0 || other == label)
        continue;
      const Eigen::Vector2d p = grid.centre(cell);
      const double a = map.slabOf(label).heightAt(p);
      const double b = map.slabOf(other).heightAt(p);
      if (is_wall && (is_floor || a < b))
        continue;
      const double low = std::min(a, b) + 0.02;
      const double high = std::max(a, b) - 0.02;
      // At most four bins, each at least a voxel high.
      const int bins = std::min(4, cellsFor(high - low, 1.2 * grid.size()));
      const PlanSlab& higher = map.slabOf(a > b ? label : other);
      const bool is_closed =
          high - low < map.priors.min_floor_step ||
          (columns.share(cell, low, high, bins, 2) >= map.priors.share_half &&
           (is_floor || reachesCeiling(columns, cell, std::min(a, b), std::max(a, b),
                                       higher, map.priors)));
      const bool is_hidden =
          !is_floor && !is_wall && a < b && map.isShadow(map.room.indexOf(to));
      edges += is_closed || !(is_wall || is_hidden) ? 1 : 0;
      closed += is_closed ? 1 : 0;
    }
  }
  return 2 * closed >= edges;
}

/** @brief Appends where the lower part of a ceiling ends before what it hides, a place
 * for each cell and direction: its riser is not seen from below it. */
void
appendHiddenRisers(const PointView& points,
                   const std::vector<int>& indices,
                   const HeightMap& map,
                   const CellGrid& grid,
                   std::vector<Eigen::Vector2d>& risers)
{
  // A voxel that an edge cuts is half full, and its mean halfway from there.
  const double to_edge = grid.size() / 4;
  std::map<std::pair<std::size_t, std::size_t>, Eigen::Vector2d> ends;
  for (const int i : indices) {
    const auto at = static_cast<std::size_t>(i);
    const Eigen::Vector2d p = points[at].head<2>().cast<double>();
    if (!points.isFinite(at) || !grid.holds(points[at].x(), points[at].y()))
      continue;
    const Cell cell = grid.at(p.x(), p.y());
    const std::size_t own = map.room.indexOf(cell);
    if (!map.room.at(cell) || map.seen[own] < 0 || map.seen[own] != map.label[own])
      continue;
    for (std::size_t d = 0; d < std::size(sides); ++d) {
      const Cell step = sides[d];
      const Cell to{cell.x + step.x, cell.y + step.y};
      if (!map.room.at(to) || !map.isShadow(map.room.indexOf(to)) ||
          map.slabOf(map.label[map.room.indexOf(to)]).heightAt(p) <=
              map.slabOf(map.label[own]).heightAt(p))
        continue;
      const Eigen::Vector2d ahead(step.x, step.y);
      const auto end = ends.emplace(std::pair(own, d), p).first;
      if (ahead.dot(p - end->second) > 0)
        end->second = p;
    }
  }
  for (const auto& [from, p] : ends) {
    const Cell step = sides[from.second];
    risers.push_back(p + to_edge * Eigen::Vector2d(step.x, step.y));
  }
}

} // namespace

std::vector<Eigen::Vector2d>
riserPoints(const PointView& points,
            const SlabEvidence& evidence,
            const HeightMap& map,
            const ColumnTable& columns,
            const RoomFitParameters& parameters)
{
  const CellGrid grid(parameters.cell_size);
  const std::vector<StepBeside> steps = stepsBeside(map, grid);
  std::vector<Eigen::Vector2d> risers;
  CellMask at_steps(map.room.box());
  for (std::size_t c = 0; c < steps.size(); ++c)
    at_steps.values()[c] = steps[c].isStep(map.priors) ? 1 : 0;
  for (const int i : columns.indicesIn(at_steps)) {
    const Eigen::Vector3f p = points[static_cast<std::size_t>(i)];
    const Cell cell = grid.at(p.x(), p.y());
    const auto& [low, high] = steps[map.room.indexOf(cell)];
    const double margin = std::min(parameters.slab_tolerance, (high - low) / 4);
    if (p.z() > low + margin && p.z() < high - margin &&
        !(evidence.is_floor ? isOnFloor(map, p, margin)
                            : isOnSlabAround(map, cell, p, margin)) &&
        !goesOn(columns, cell, p.z(), low, high, evidence.is_floor, map.priors))
      risers.push_back(p.head<2>().cast<double>());
  }
  if (!evidence.is_floor)
    appendHiddenRisers(points, evidence.indices, map, grid, risers);
  return risers;
}

void
fillHiddenParts(HeightMap& map, const ColumnTable& columns, const CellGrid& grid)
{
  CellMask rest = map.room;
  for (std::size_t i = 0; i < map.label.size(); ++i)
    if (map.label[i] > 0)
      rest.values()[i] = 0;
  const MaskRegions parts = labelRegions(rest, false);
  const auto largest =
      std::max_element(parts.sizes.begin(), parts.sizes.end()) - parts.sizes.begin();
  map.details.push_back(map.main);
  const auto tried = static_cast<std::int32_t>(map.details.size());
  const auto relabel = [&](std::int32_t part, std::int32_t label) {
    for (std::size_t i = 0; i < map.label.size(); ++i)
      if (parts.label[i] == part)
        map.label[i] = label;
  };
  for (std::size_t r = 0; r < parts.sizes.size(); ++r) {
    const auto part = static_cast<std::int32_t>(r);
    if (part == largest)
      continue;
    relabel(part, tried);
    relabel(part, hasRisers(map, columns, grid, true, tried) ? 0 : -1);
  }
  map.details.pop_back();
  fillHeights(map);
}

void
dropUnsupported(HeightMap& map,
                const ColumnTable& columns,
                const CellGrid& grid,
                bool is_floor)
{
  for (std::size_t k = map.details.size(); k >= 1; --k) {
    const auto label = static_cast<std::int32_t>(k);
    if (hasRisers(map, columns, grid, is_floor, label))
      continue;
    for (auto& l : map.label)
      l = l == label ? -1 : l;
    fillHeights(map);
  }
}

} // namespace pcl::sedr
