// SPDX-License-Identifier: BSD-3-Clause
#include "floor_reflections.h"

#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/base/plane_fit.h"

#include <algorithm>

namespace pcl::sedr {

namespace {

/** @brief Returns the footprint of a level in cells that bridge its hidden parts. */
CellSet
footprintOf(const Level& level, const CellGrid& grid, const Priors& priors)
{
  const CellGrid wide(priors.patch);
  std::vector<CellKey> keys;
  for (std::size_t i = 0; i < level.cells.size(); ++i) {
    const Eigen::Vector2d c = grid.centre(level.cells[i]);
    const Cell cell = wide.at(c.x(), c.y());
    for (int k = 0; k < 9; ++k)
      keys.push_back(keyOf({cell.x + k % 3 - 1, cell.y + k / 3 - 1}));
  }
  return CellSet(std::move(keys));
}

/** @brief Returns whether ceilings are a room's height above half of a level's cells.
 */
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
               const std::vector<Candidate>& all,
               const Priors& priors)
{
  const auto min_points = static_cast<std::size_t>(5 * priors.min_points);
  std::size_t below = 0; // counted up to `min_points`
  for (auto c = all.begin(); c != all.end() && below < min_points; ++c)
    below += distanceAbove(level.slab, c->position()) < -priors.run_gap ? 1 : 0;
  return below >= min_points;
}

/** @brief Returns the points below a level and within its footprint. */
std::vector<Candidate>
belowFootprint(const Level& level,
               const CellSet& footprint,
               const std::vector<Candidate>& some,
               const Priors& priors)
{
  const CellGrid wide(priors.patch);
  std::vector<Candidate> below;
  for (const Candidate& c : some)
    if (distanceAbove(level.slab, c.position()) <= -priors.run_gap &&
        footprint.contains(wide.at(c.x, c.y)))
      below.push_back(c);
  return below;
}

/** @brief Tests whether there is a point near a position. */
class NearPoints {
public:
  explicit NearPoints(const LevelColumns& columns)
      : columns_(columns)
      , reach_(1.5 * columns.grid().size())
  {}

  /** @brief Returns whether a point below a level has a mirror image above it. */
  bool holdImage(const Candidate& c, const Level& level) const
  {
    const double above = distanceAbove(level.slab, c.position());
    return holdNear(c.position().cast<double>() -
                    2 * above * level.slab.plane.head<3>());
  }

private:
  bool holdNear(const Eigen::Vector3d& place) const
  {
    if (!columns_.grid().holds(place.x(), place.y()))
      return false;
    const Cell cell = columns_.grid().at(place.x(), place.y());
    for (int k = 0; k < 9; ++k)
      if (holdNear({cell.x + k % 3 - 1, cell.y + k / 3 - 1}, place.z()))
        return true;
    return false;
  }

  bool holdNear(Cell cell, double z) const
  {
    const std::size_t at = columns_.cells().find(cell);
    if (at == CellSet::npos)
      return false;
    const Candidate* last = columns_.all().data() + columns_.last(at);
    const Candidate* low = std::lower_bound(
        columns_.all().data() + columns_.first(at), last, z - reach_,
        [](const Candidate& c, double height) { return c.z < height; });
    return low != last && low->z <= z + reach_;
  }

  const LevelColumns& columns_;
  double reach_;
};

/** @brief Returns whether few of some hundred points below a level have a mirror image.
 */
bool
hardlyMirrors(const Level& level,
              const CellSet& footprint,
              const LevelColumns& columns,
              const NearPoints& near_points,
              const Priors& priors)
{
  constexpr std::size_t looked_at = 5000;
  constexpr std::size_t enough = 200; // sampled points below the level
  std::vector<Candidate> some;
  const std::vector<Candidate>& all = columns.withoutWalls();
  for (std::size_t k = 0; k < all.size(); k += all.size() / looked_at + 1)
    some.push_back(all[k]);
  const std::vector<Candidate> below = belowFootprint(level, footprint, some, priors);
  const auto images =
      std::count_if(below.begin(), below.end(), [&](const Candidate& c) {
        return near_points.holdImage(c, level);
      });
  return below.size() >= enough &&
         static_cast<double>(images) <
             priors.share_half * static_cast<double>(below.size());
}

/** @brief Returns whether enough points below a level have a mirror image. The first
 * few hundred usually decide against it. */
bool
mirrors(const Level& level,
        const std::vector<Candidate>& below,
        const NearPoints& near_points,
        const Priors& priors)
{
  if (static_cast<double>(below.size()) < 5 * priors.min_points)
    return false;
  std::size_t left = below.size();
  for (const Candidate& c : below) {
    left -= near_points.holdImage(c, level) ? 0 : 1;
    if (static_cast<double>(left) / static_cast<double>(below.size()) <
        priors.share_most)
      return false;
  }
  return true;
}

/** @brief Returns the reflections in a level, none if it does not mirror. */
std::vector<int>
reflectionsIn(const LevelColumns& columns,
              const std::vector<Level>& levels,
              std::size_t at,
              const LevelParameters& parameters)
{
  const Level& floor = levels[at];
  const Priors& priors = parameters.priors;
  if (floor.kind == LevelKind::Ceiling || !isBelowCeilings(levels, at, parameters) ||
      !hasPointsBelow(floor, columns.all(), priors))
    return {};
  const NearPoints near_points(columns);
  const CellSet footprint = footprintOf(floor, columns.grid(), priors);
  if (hardlyMirrors(floor, footprint, columns, near_points, priors) ||
      !mirrors(floor, belowFootprint(floor, footprint, columns.withoutWalls(), priors),
               near_points, priors))
    return {};
  std::vector<int> found;
  for (const Candidate& c : belowFootprint(floor, footprint, columns.all(), priors))
    if (near_points.holdImage(c, floor))
      found.push_back(c.index);
  return found;
}

} // namespace

std::vector<int>
findReflections(const LevelColumns& columns,
                const std::vector<Level>& levels,
                const LevelParameters& parameters)
{
  std::vector<std::vector<int>> parts(levels.size());
  parallelBlocks(levels.size(), 1, columns.threads(), [&](std::size_t l, std::size_t) {
    parts[l] = reflectionsIn(columns, levels, l, parameters);
  });
  std::vector<int> found;
  for (const std::vector<int>& part : parts)
    found.insert(found.end(), part.begin(), part.end());
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

} // namespace pcl::sedr
