// SPDX-License-Identifier: BSD-3-Clause
#include "seen_surfaces.h"

#include <algorithm>
#include <set>

namespace pcl::sedr {

namespace {

/** @brief Steps of vertical surfaces, those at both ends left out, which show what is
 * below and above as well. */
struct SeenSteps {
  double seen = 0;
  double all = 0;

  void add(const VerticalSpan& span, std::uint64_t of_tile)
  {
    // Four fifths of a step are as good as a whole one.
    const double whole = (span.high - span.low) / off_wall - 2 + 0.2;
    const auto steps = static_cast<unsigned>(std::clamp(whole, 0.0, 64.0));
    all += steps;
    seen += steps == 0 ? 0 : __builtin_popcountll(of_tile << (64 - steps));
  }

  double share() const { return all > 0 ? seen / all : 0; }
};

/** @brief Returns the area of a part of the ceiling of a room; -1: the main ceiling. */
double
areaOf(const PlanRoom& room, int part)
{
  double area = part < 0 ? -room.area() : 0;
  for (std::size_t d = 0; d < room.details.size(); ++d)
    if (part < 0 || part == static_cast<int>(d)) {
      area += room.details[d].boundary.area();
      for (const PlanLoop& hole : room.details[d].holes)
        area += hole.area(); // clockwise
    }
  return std::abs(area);
}

} // namespace

void
SeenSurfaces::tellHanging(std::size_t room, std::vector<PlanWarning>& warnings) const
{
  constexpr double most = 0.6; // of a side, where that of the best wall is 1
  struct LowerPart {
    double seen = 0; // of its best side, as others may be hidden
    double drop = 0; // to the other side of the first riser
    Eigen::Vector2d at = Eigen::Vector2d::Zero();
  };
  const RoomLookup& lookup = rooms_[room];
  const PlanRoom& plan = lookup.room();
  std::map<int, LowerPart> lower; // by detail; -1: the main ceiling
  std::set<int> at_walls;         // what hangs keeps clear of them
  double best_wall = 0;
  for (const Vertical& vertical : verticals_) {
    const VerticalSurface& surface = vertical.surface;
    const bool is_wall = surface.kind == VerticalKind::Wall;
    if (surface.room != &plan ||
        (!is_wall && surface.kind != VerticalKind::CeilingRiser))
      continue;
    struct Side {
      SeenSteps steps;
      double drop = 0;
      std::size_t tiles = 0;
    };
    std::map<int, Side> sides; // of the parts of the ceiling at a wall, below a riser
    for (std::size_t k = 0; k < vertical.spans.size(); ++k) {
      const VerticalSpan& span = vertical.spans[k];
      if (span.high <= span.low)
        continue;
      const double s = (static_cast<double>(k) + 0.5) * wall_tile;
      const double into = is_wall || !span.faces_left ? off_wall : -off_wall;
      Side& side = sides[lookup.detailAt(surface.element->pointAt(s) +
                                         into * surface.element->normalAt(s))];
      side.steps.add(span, vertical.seen[k]);
      side.drop += span.high - span.low;
      ++side.tiles;
    }
    for (const auto& [part, side] : sides) {
      const auto tiles = static_cast<double>(side.tiles);
      if (is_wall)
        at_walls.insert(part);
      if (tiles * wall_tile < min_strip || side.steps.all == 0)
        continue;
      if (is_wall)
        best_wall = std::max(best_wall, side.steps.share());
      // Walls come first. A low side of a sparse scan may lie between two rows of
      // points.
      if (is_wall || side.steps.all * best_wall < most * tiles)
        continue;
      const PlanElement& edge = *surface.element;
      const auto found = lower.try_emplace(
          part, LowerPart{0, side.drop / tiles, edge.pointAt(edge.length() / 2)});
      double& seen = found.first->second.seen;
      seen = std::max(seen, side.steps.share());
    }
  }
  PlanWarning told{WarningKind::Hanging, {0, 0, 0}, plan.id};
  double largest = 0;
  for (const auto& [part, found] : lower) {
    if (at_walls.count(part) > 0 || found.seen >= most * best_wall)
      continue;
    const double area = areaOf(plan, part);
    told.values[0] += area;
    told.values[2] = std::max(told.values[2], 100 * found.seen);
    if (area > largest) {
      largest = area;
      told.values[1] = found.drop;
      told.at = found.at;
    }
  }
  if (largest > 0)
    warnings.push_back(told);
}

} // namespace pcl::sedr
