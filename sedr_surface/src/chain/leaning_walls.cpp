// SPDX-License-Identifier: BSD-3-Clause
#include "chain_run.h"

#include "sedr_filters/src/plan/room_lookup.h"
#include "sedr_segmentation/src/openings/wall_map.h"
#include "sedr_segmentation/src/openings/wall_sides.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace pcl::sedr {

namespace {

// Metres.
constexpr double tile = 0.1;      ///< a wall is divided into tiles of this size
constexpr double reach = 0.5;     ///< how far before and behind a wall is looked
constexpr double on_plane = 0.03; ///< distance of points on a plane
constexpr double off_wall = 0.05;
constexpr double min_area = 0.25; ///< square metres
constexpr double min_more = 0.1;  ///< share that a leaning plane must hold in addition
constexpr double max_lost = 0.1;  ///< share of the wall that it may lose
constexpr int leans = 26;         ///< tried to each side, in hundredths of the height

/** @brief What was seen in a tile of a wall: a height and offsets into the room. */
struct Tile {
  double z = 0;
  std::vector<float> offsets;

  /** @brief Returns how well an offset fits what was seen: 1 on it, 0 from `on_plane`
   * on. */
  double fit(double offset) const
  {
    double best = 0;
    for (const float seen : offsets) {
      const double miss = (seen - offset) / on_plane;
      best = std::max(best, 1 - miss * miss);
    }
    return best;
  }
};

/** @brief What was seen of a side of a wall. */
class WallTiles {
public:
  /** @param points beside it, without those of floor and ceiling */
  WallTiles(const WallSide& side, const std::vector<SidePoint>& points)
      : low_(side.floor)
      , high_(side.ceiling)
  {
    std::map<std::pair<int, int>, Tile> tiles;
    for (const SidePoint& p : points) {
      const auto row = static_cast<int>((p.height - low_) / tile);
      Tile& seen = tiles[{row, static_cast<int>(p.along / tile)}];
      seen.z = low_ + (row + 0.5) * tile;
      seen.offsets.push_back(p.offset);
    }
    for (auto& [place, seen] : tiles)
      tiles_.push_back(std::move(seen));
  }

  /** @brief Returns the warning about a plane that holds what the wall holds and
   * clearly more, of kind Stage if there is none. A plane through a wall and what
   * stands before it loses much of the wall. */
  PlanWarning doubt() const
  {
    Held most;
    double lean = 0;
    for (int k = -leans; k <= leans; ++k)
      for (double z = low_; z <= high_; z += tile)
        if (const Held now = held(0.01 * k, z);
            now.more - now.lost > most.more - most.lost &&
            now.lost < max_lost * now.wall) {
          most = now;
          lean = 0.01 * k;
        }
    PlanWarning warning;
    if (most.off * tile * tile < min_area || most.more < min_more * most.wall)
      return warning;
    warning.kind = WarningKind::WallOff;
    warning.values = {most.off * tile * tile, std::atan(lean) * 180 / M_PI};
    return warning;
  }

private:
  /** @brief Tiles, weighted by how well a plane fits them. */
  struct Held {
    double wall = 0; ///< held by the wall
    double more = 0; ///< held by a leaning plane, and less by the wall
    double lost = 0; ///< held by the wall, and less by the plane
    double off = 0;  ///< held by the plane far off the wall; a number
  };

  /** @brief Compares the wall with a plane that leans by `lean` into the room and meets
   * it at the height `z`. */
  Held held(double lean, double z) const
  {
    Held held;
    for (const Tile& seen : tiles_) {
      const double offset = lean * (seen.z - z);
      const double on_wall = seen.fit(0);
      const double more = seen.fit(offset) - on_wall;
      held.wall += on_wall;
      (more > 0 ? held.more : held.lost) += std::abs(more);
      held.off += more > 0 && std::abs(offset) > off_wall ? 1 : 0;
    }
    return held;
  }

  double low_;
  double high_;
  std::vector<Tile> tiles_; ///< in which something was seen
};

} // namespace

std::vector<PlanWarning>
leaningWalls(const PointView& points, const Floorplan& plan)
{
  const std::vector<WallSide> sides = wallSides(plan, {});
  std::vector<std::vector<SidePoint>> beside =
      pointsBeside(sides, points, nullptr, reach, reach);
  std::vector<PlanWarning> warnings;
  for (std::size_t k = 0; k < sides.size(); ++k) {
    if (sides[k].elements.empty())
      continue; // of a column
    const PlanRoom& room = plan.rooms[sides[k].room];
    const RoomLookup model(room);
    const auto isOfSlab = [&](const SidePoint& p) {
      const Eigen::Vector2d place = sides[k].line.pointAt(p.along);
      return p.height < model.floorAt(place) + off_wall ||
             p.height > model.ceilingAt(place) - off_wall;
    };
    beside[k].erase(std::remove_if(beside[k].begin(), beside[k].end(), isOfSlab),
                    beside[k].end());
    PlanWarning warning = WallTiles(sides[k], beside[k]).doubt();
    if (warning.kind != WarningKind::WallOff)
      continue;
    warning.room = room.id;
    warning.wall = sides[k].elements.front() + 1;
    warnings.push_back(std::move(warning));
  }
  return warnings;
}

} // namespace pcl::sedr
