// SPDX-License-Identifier: BSD-3-Clause
#include "element_changes.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::sedr::tools {

namespace {

/** @brief An opening of a plan, and the name that changes use. */
struct NamedOpening {
  std::string name;
  const PlanOpening* opening = nullptr;

  Eigen::Vector3d middle() const
  {
    const Eigen::Vector2d place = (opening->start + opening->end) / 2;
    return {place.x(), place.y(), (opening->bottom + opening->top) / 2};
  }
};

std::vector<NamedOpening>
openingsOf(const Floorplan& plan)
{
  std::vector<NamedOpening> openings;
  for (std::size_t k = 0; k < plan.openings.size(); ++k)
    openings.push_back({"opening_" + std::to_string(k + 1), &plan.openings[k]});
  return openings;
}

/** @brief Returns the distance of the middles of two openings; infinite if they do not
 * share a part of a wall. */
double
middlesApart(const NamedOpening& a, const NamedOpening& b)
{
  constexpr double max_sine = 0.26;  // between their walls: 15 degrees
  constexpr double max_across = 0.5; // between the middles of these walls, metres
  const PlanOpening& o = *a.opening;
  const Eigen::Vector2d way = (o.end - o.start).normalized();
  const Eigen::Vector2d other = (b.opening->end - b.opening->start).normalized();
  const Eigen::Vector3d off = b.middle() - a.middle();
  const bool share =
      std::abs(way.x() * other.y() - way.y() * other.x()) < max_sine &&
      std::abs(way.x() * off.y() - way.y() * off.x()) < max_across &&
      2 * std::abs(off.head<2>().dot(way)) < o.width() + b.opening->width() &&
      2 * std::abs(off.z()) < o.height() + b.opening->height();
  return share ? off.norm() : std::numeric_limits<double>::infinity();
}

/** @brief Returns whether a plan has a wall where an opening is. */
bool
hasWallAt(const Floorplan& plan, const NamedOpening& opening)
{
  constexpr double near = 0.5; // of the middle of the wall, metres
  const Eigen::Vector3d middle = opening.middle();
  return std::any_of(plan.rooms.begin(), plan.rooms.end(), [&](const PlanRoom& room) {
    const RoomHeights heights = heightsOf(room);
    return heights.low < middle.z() && middle.z() < heights.high &&
           room.boundary.distance(middle.head<2>()) < near;
  });
}

} // namespace

std::vector<Change>
openingChanges(const Floorplan& before,
               const Floorplan& after,
               const CompareSettings& settings)
{
  std::vector<Change> changes;
  if (before.openings.empty() || after.openings.empty())
    return changes; // nobody looked for them in one of the plans
  std::vector<NamedOpening> gone = openingsOf(before);
  std::vector<NamedOpening> come = openingsOf(after);
  takePairs(gone, come, settings.farthest, middlesApart);
  const auto addSingles = [&](const std::vector<NamedOpening>& openings,
                              const Floorplan& other, ChangeKind kind) {
    for (const NamedOpening& single : openings)
      if (single.opening->kind != OpeningKind::Unknown && hasWallAt(other, single)) {
        changes.push_back({kind,
                           nameOf(single.opening->kind),
                           {},
                           {},
                           single.opening->width() * single.opening->height()});
        changes.back().names() = {single.name};
      }
  };
  addSingles(gone, after, ChangeKind::Vanished);
  addSingles(come, before, ChangeKind::Appeared);
  return changes;
}

} // namespace pcl::sedr::tools
