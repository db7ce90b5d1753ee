// SPDX-License-Identifier: BSD-3-Clause
#include "plan_layers.h"

#include "scale.h"
#include "sedr_filters/src/plan/plan_bounds.h"
#include "sedr_surface/src/drawing/text_spot.h"

#include <algorithm>

namespace pcl::sedr::tools {

void
addPlan(const Floorplan& plan, double pixels, Panel& panel)
{
  const auto addDetails = [&](const std::vector<PlanDetail>& details, Colour colour) {
    for (const PlanDetail& detail : details) {
      panel.addLoop(detail.boundary, colour, colour, pixels);
      for (const PlanLoop& hole : detail.holes)
        panel.addLoop(hole, colour, colour, pixels);
    }
  };
  for (const PlanRoom& room : plan.rooms) {
    addDetails(room.floor_details, colours::floor);
    addDetails(room.details, colours::detail);
    for (const PlanNiche& niche : room.niches)
      panel.addLoop(niche.boundary, colours::wall, colours::wall, pixels);
    for (const PlanLoop& column : room.columns)
      panel.addLoop(column, colours::column, colours::column, pixels);
    panel.addLoop(room.boundary, colours::ink, colours::arc, pixels);
  }
}

void
addRoomNumbers(const Floorplan& plan, Panel& panel)
{
  for (const PlanRoom& room : plan.rooms)
    panel.addLabel(textSpotIn(room.boundary, room.columns).place,
                   std::to_string(room.id) + ": " + fixedText(room.area(), 1) + " m²");
}

void
addPlanLegend(const Floorplan& plan, Picture& picture)
{
  const auto addIf = [&](const char* meaning, Colour colour, auto hasIt) {
    if (std::any_of(plan.rooms.begin(), plan.rooms.end(), hasIt))
      picture.addLegend(meaning, colour);
  };
  picture.addLegend("segment", colours::ink);
  addIf("arc", colours::arc, [](const PlanRoom& room) {
    return std::any_of(room.boundary.elements.begin(), room.boundary.elements.end(),
                       [](const PlanElement& element) { return element.isArc(); });
  });
  addIf("column", colours::column,
        [](const PlanRoom& room) { return !room.columns.empty(); });
  addIf("detail of the ceiling", colours::detail,
        [](const PlanRoom& room) { return !room.details.empty(); });
  addIf("step of the floor", colours::floor,
        [](const PlanRoom& room) { return !room.floor_details.empty(); });
  addIf("niche", colours::wall,
        [](const PlanRoom& room) { return !room.niches.empty(); });
}

Box
viewOf(const Floorplan& plan, double margin)
{
  Box view;
  for (const PlanRoom& room : plan.rooms) {
    view.extend(boundsOf(room.boundary));
    for (const PlanNiche& niche : room.niches)
      view.extend(boundsOf(niche.boundary));
  }
  return grown(view, margin);
}

} // namespace pcl::sedr::tools
