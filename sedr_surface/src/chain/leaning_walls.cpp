// SPDX-License-Identifier: BSD-3-Clause
#include "chain_run.h"

#include "sedr_filters/src/grids/place_table.h"
#include "sedr_filters/src/plan/plan_surfaces.h"

#include <algorithm>
#include <cmath>

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

class WallTiles {
public:
  explicit WallTiles(const VerticalSurface& wall)
      : wall_(wall)
      , columns_(static_cast<std::size_t>(wall.element->length() / tile) + 1)
  {
    for (std::size_t c = 0; c < columns_; ++c) {
      const double s = (static_cast<double>(c) + 0.5) * tile;
      spans_.push_back(wall.spanAt(std::min(s, wall.element->length())));
      low_ = c == 0 ? spans_[c].low : std::min(low_, spans_[c].low);
      high_ = c == 0 ? spans_[c].high : std::max(high_, spans_[c].high);
    }
    tiles_.resize(columns_ *
                  (static_cast<std::size_t>(std::max(high_ - low_, 0.0) / tile) + 1));
    for (std::size_t i = 0; i < tiles_.size(); ++i)
      tiles_[i].z = low_ + (static_cast<double>(i / columns_) + 0.5) * tile;
  }

  void add(const Eigen::Vector3d& p)
  {
    const double s = wall_.element->project(p.head<2>());
    const auto column = static_cast<std::size_t>(s / tile);
    const VerticalSpan& span = spans_[column];
    if (s <= 0 || s >= wall_.element->length() || p.z() < span.low + off_wall ||
        p.z() > span.high - off_wall)
      return;
    const Eigen::Vector2d off = p.head<2>() - wall_.element->pointAt(s);
    const double offset = off.dot(wall_.normalAt(s).head<2>());
    if (std::abs(offset) <= reach)
      tiles_[static_cast<std::size_t>((p.z() - low_) / tile) * columns_ + column]
          .offsets.push_back(static_cast<float>(offset));
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
      if (seen.offsets.empty())
        continue;
      const double offset = lean * (seen.z - z);
      const double on_wall = seen.fit(0);
      const double more = seen.fit(offset) - on_wall;
      held.wall += on_wall;
      (more > 0 ? held.more : held.lost) += std::abs(more);
      held.off += more > 0 && std::abs(offset) > off_wall ? 1 : 0;
    }
    return held;
  }

  const VerticalSurface& wall_;
  std::size_t columns_;
  std::vector<VerticalSpan> spans_; ///< of each column
  double low_ = 0;
  double high_ = 0;
  std::vector<Tile> tiles_; ///< row by row
};

} // namespace

std::vector<PlanWarning>
leaningWalls(const PointView& points, const Floorplan& plan)
{
  std::vector<std::vector<VerticalSurface>> surfaces;
  std::vector<WallTiles> walls;
  std::vector<std::pair<std::uint32_t, std::size_t>> numbers; // of room and wall
  PlaceTable near(0.5);
  for (const PlanRoom& room : plan.rooms) {
    surfaces.push_back(verticalSurfaces(room));
    for (const VerticalSurface& surface : surfaces.back()) {
      if (surface.label != StructureLabel::Wall)
        continue;
      near.addAlong(*surface.element, reach, static_cast<std::uint32_t>(walls.size()));
      walls.emplace_back(surface);
      numbers.emplace_back(
          room.id,
          static_cast<std::size_t>(surface.element - room.boundary.elements.data()));
    }
  }
  near.finish();
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points.isFinite(i)) {
      const Eigen::Vector3d p = points[i].cast<double>();
      for (const std::uint32_t wall : near.at(p.head<2>()))
        walls[wall].add(p);
    }
  std::vector<PlanWarning> warnings;
  for (std::size_t w = 0; w < walls.size(); ++w)
    if (PlanWarning warning = walls[w].doubt(); warning.kind == WarningKind::WallOff) {
      warning.room = numbers[w].first;
      warning.wall = numbers[w].second + 1;
      warnings.push_back(std::move(warning));
    }
  return warnings;
}

} // namespace pcl::sedr
