// SPDX-License-Identifier: BSD-3-Clause
#include "level_candidates.h"

#include <pcl/sedr_segmentation/floor_reflections.h>

#include <pcl/sedr_filters/plane_fit.h>

#include <algorithm>

namespace pcl {
namespace sedr {

namespace {

/** @brief What is nearer below a floor than this is its own noise, metres. */
constexpr double least_depth = 0.15;

/** @brief Fewer points below a floor are strays and make no difference. */
constexpr std::size_t least_points = 50;

constexpr double least_share = 0.8; ///< of what is below that has its like above

/** @brief Square cells, metres, in which a floor goes on below what hides it. */
constexpr double wide_cell = 0.5;

/** @brief Where a level is, in cells wide enough to bridge what hides parts of it. */
CellSet
footprintOf(const Level& level, const CellGrid& grid)
{
  const CellGrid wide(wide_cell);
  std::vector<CellKey> keys;
  for (std::size_t i = 0; i < level.cells.size(); ++i) {
    const Eigen::Vector2d c = grid.centre(level.cells[i]);
    const Cell cell = wide.at(c.x(), c.y());
    for (int k = 0; k < 9; ++k)
      keys.push_back(keyOf({cell.x + k % 3 - 1, cell.y + k / 3 - 1}));
  }
  return CellSet(std::move(keys));
}

/** @brief Whether a room may stand on a level: ceilings are a room's height above half
 * of its cells. */
bool
isBelowCeilings(const std::vector<Level>& levels,
                std::size_t floor,
                const LevelParameters& parameters)
{
  CellSet covered;
  for (const Level& level : levels)
    if (level.kind == LevelKind::Ceiling &&
        level.height - levels[floor].height >= parameters.minimum_room_height)
      covered = unite(covered, intersect(levels[floor].cells, level.cells));
  return 2 * covered.size() >= levels[floor].cells.size();
}

bool
hasPointsBelow(const Level& level,
               const PointView& points,
               const std::vector<int>& indices)
{
  std::size_t below = 0;
  for (const int i : indices)
    below +=
        distanceAbove(level.slab, points[static_cast<std::size_t>(i)]) < -least_depth
            ? 1
            : 0;
  return below >= least_points;
}

/** @brief Tells whether there is a point near a place. */
class Columns {
public:
  Columns(const std::vector<Candidate>& columns, const CellSet& cells, double size)
      : columns_(columns)
      , cells_(cells)
      , grid_(size)
      , reach_(1.5 * size)
  {}

  bool hasNear(const Eigen::Vector3d& place) const
  {
    const Cell cell = grid_.at(place.x(), place.y());
    for (int k = 0; k < 9; ++k)
      if (hasNear({cell.x + k % 3 - 1, cell.y + k / 3 - 1}, place.z()))
        return true;
    return false;
  }

private:
  bool hasNear(Cell cell, double z) const
  {
    const std::size_t at = cells_.find(cell);
    if (at == CellSet::npos)
      return false;
    const auto low =
        std::lower_bound(columns_.begin(), columns_.end(), z - reach_,
                         [&](const Candidate& c, double height) {
                           return c.cell != at ? c.cell < at : c.z < height;
                         });
    return low != columns_.end() && low->cell == at && low->z <= z + reach_;
  }

  const std::vector<Candidate>& columns_;
  const CellSet& cells_;
  CellGrid grid_;
  double reach_;
};

/** @brief Those of some points below a level, over its footprint, that have their like
 * above it. */
struct Reflected {
  std::vector<int> points;
  std::size_t below = 0; ///< with their like above or not

  double share() const
  {
    return below == 0 ? 0
                      : static_cast<double>(points.size()) / static_cast<double>(below);
  }
};

Reflected
reflectedIn(const Level& level,
            const CellSet& footprint,
            const std::vector<Candidate>& some,
            const Columns& columns)
{
  const CellGrid wide(wide_cell);
  Reflected reflected;
  for (const Candidate& c : some) {
    const double above = distanceAbove(level.slab, c.position());
    if (above > -least_depth || !footprint.contains(wide.at(c.x, c.y)))
      continue;
    ++reflected.below;
    const Eigen::Vector3d image =
        c.position().cast<double>() - 2 * above * level.slab.plane.head<3>();
    if (columns.hasNear(image))
      reflected.points.push_back(c.index);
  }
  return reflected;
}

} // namespace

std::vector<int>
findReflections(const PointView& points,
                const std::vector<int>& indices,
                const std::vector<Level>& levels,
                const LevelParameters& parameters)
{
  std::vector<const Level*> floors;
  for (std::size_t l = 0; l < levels.size(); ++l)
    if (levels[l].kind != LevelKind::Ceiling &&
        isBelowCeilings(levels, l, parameters) &&
        hasPointsBelow(levels[l], points, indices))
      floors.push_back(&levels[l]);
  if (floors.empty())
    return {};
  const CellGrid grid(parameters.cell_size);
  const CellSet cells(grid, points, indices);
  const std::vector<Candidate> columns = sortIntoColumns(points, indices, grid, cells);
  const std::vector<Candidate> free =
      withoutWalls(columns, cells, parameters.tolerance);
  const Columns table(columns, cells, grid.size());
  std::vector<int> found;
  for (const Level* floor : floors) {
    const CellSet footprint = footprintOf(*floor, grid);
    const Reflected seen = reflectedIn(*floor, footprint, free, table);
    if (seen.below < least_points || seen.share() < least_share)
      continue;
    const Reflected all = reflectedIn(*floor, footprint, columns, table);
    found.insert(found.end(), all.points.begin(), all.points.end());
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

} // namespace sedr
} // namespace pcl
