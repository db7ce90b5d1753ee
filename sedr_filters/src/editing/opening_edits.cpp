// SPDX-License-Identifier: BSD-3-Clause
#include "../base/number_text.h"

#include <pcl/sedr_filters/plan_editor.h>
#include <pcl/sedr_filters/plan_measures.h>

namespace pcl::sedr {
namespace {

/** @brief Changes the opening of a room whose middle is nearest to a place, at most a
 * metre from it. Returns why there is none; empty if there is. */
template <typename Change>
std::string
changeNearest(Floorplan& plan,
              std::uint32_t room,
              const Eigen::Vector2d& place,
              const Change& change)
{
  double least = 1; // metres
  auto nearest = plan.openings.end();
  for (auto o = plan.openings.begin(); o != plan.openings.end(); ++o) {
    const double distance = ((o->start + o->end) / 2 - place).norm();
    if ((o->rooms[0] == room || o->rooms[1] == room) && distance <= least) {
      nearest = o;
      least = distance;
    }
  }
  if (nearest == plan.openings.end())
    return "room " + std::to_string(room) + " has no opening within 1 m of (" +
           numberText(place.x()) + ", " + numberText(place.y()) + ")";
  change(nearest);
  return {};
}

} // namespace

bool
PlanEditor::setOpening(std::uint32_t room,
                       const Eigen::Vector2d& place,
                       OpeningKind kind)
{
  return apply(room, [&](Floorplan& plan, PlanRoom&) -> std::string {
    if (kind == OpeningKind::Unknown)
      return "an opening is a door, a window or a passage";
    return changeNearest(plan, room, place, [&plan, kind](auto opening) {
      if (kind != OpeningKind::Door) {
        opening->hinge = OpeningHinge::Unknown;
        opening->swing = 0;
        opening->state = OpeningState::Unknown;
      }
      opening->number = opening->kind == kind ? opening->number : 0;
      opening->kind = kind;
      opening->confidence = 1;
      numberOpenings(plan);
    });
  });
}

bool
PlanEditor::closeOpening(std::uint32_t room, const Eigen::Vector2d& place)
{
  return apply(room, [&](Floorplan& plan, PlanRoom&) {
    return changeNearest(plan, room, place,
                         [&plan](auto opening) { plan.openings.erase(opening); });
  });
}

} // namespace pcl::sedr
