// SPDX-License-Identifier: BSD-3-Clause
// Doorways of earlier versions.
#include "../plan/plan_geometry.h"
#include "floorplan_format.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace pcl::sedr {

using Json = nlohmann::ordered_json;

namespace {

/** @brief Fits an opening between the faces of its rooms: finds its walls, its depth
 * and the middle of the wall, and puts its first room to its left. With one face it is
 * as deep behind its ends as towards the face. */
void
fitBetweenFaces(const Floorplan& plan, PlanOpening& opening)
{
  const PlanElement* faces[2] = {};
  for (std::size_t k = 0; k < 2; ++k)
    if (const PlanRoom* const room = findRoom(plan, opening.rooms[k]))
      if (const auto wall = wallBeside(*room, opening)) {
        opening.walls.push_back({room->id, *wall});
        faces[k] = &room->boundary.elements[*wall];
      }
  if (opening.walls.empty())
    return;
  const std::size_t k = faces[0] ? 0 : 1;
  const PlanElement& near = *faces[k];
  const PlanElement* const far = faces[1 - k];
  const auto onto = [](const PlanElement& face, const Eigen::Vector2d& p) {
    return face.pointAt(face.project(p));
  };
  const Eigen::Vector2d middle = (opening.start + opening.end) / 2;
  const Eigen::Vector2d inwards = near.normalAt(near.project(middle));
  PlanOpening fitted = opening;
  for (Eigen::Vector2d* const end : {&fitted.start, &fitted.end}) {
    const Eigen::Vector2d here = onto(near, far ? onto(*far, *end) : *end);
    const Eigen::Vector2d there = far ? onto(*far, here) : 2 * *end - here;
    *end = (here + there) / 2;
    fitted.depth += (here - there).norm() / 2;
  }
  if (fitted.width() > 0)
    opening = fitted;
  const Eigen::Vector2d way = opening.end - opening.start;
  const bool is_left = way.x() * inwards.y() - way.y() * inwards.x() > 0;
  if (is_left != (k == 0))
    std::swap(opening.start, opening.end);
}

} // namespace

void
addDoorways(const Json& json, Floorplan& plan)
{
  const std::vector<PlanOpening> openings = plan.openings;
  for (const Json& entry : json) {
    PlanOpening doorway;
    PartFields fields(entry);
    fields.rooms(doorway.rooms, "a doorway");
    fields.needed("bottom", doorway.bottom);
    fields.needed("top", doorway.top);
    fields.needed("start", doorway.start);
    fields.needed("end", doorway.end);
    const Eigen::Vector2d middle = (doorway.start + doorway.end) / 2;
    if (!(doorway.width() > 0) || doorway.height() == 0 ||
        std::any_of(openings.begin(), openings.end(), [&](const PlanOpening& opening) {
          return isAt(opening, middle, doorway.bottom, doorway.top);
        }))
      continue;
    fitBetweenFaces(plan, doorway);
    plan.openings.push_back(doorway);
  }
}

} // namespace pcl::sedr
