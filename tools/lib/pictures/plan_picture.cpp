// SPDX-License-Identifier: BSD-3-Clause
#include "plan_picture.h"

#include "map_cells.h"
#include "plan_layers.h"

namespace pcl::sedr::tools {

Picture
drawPlan(const Floorplan& plan, const std::vector<FittedBoundary>& boundaries)
{
  constexpr double margin = 0.3;
  constexpr Colour unsupported = colours::recovered;
  Places seen;
  Places assumed;
  Places corners;
  for (const FittedBoundary& boundary : boundaries)
    for (const auto& sample : boundary.samples)
      (sample.isSupported() ? seen : assumed).push_back(sample.position);
  std::size_t arcs = 0;
  for (const PlanRoom& room : plan.rooms)
    for (const PlanElement& element : room.boundary.elements) {
      arcs += element.isArc() ? 1 : 0;
      corners.push_back(element.start);
    }
  Panel boundary("boundary: " + counted(seen.size() + assumed.size(), "point"));
  addPlan(plan, 1, boundary);
  boundary.addPoints(std::move(assumed), unsupported, 3.5);
  boundary.addPoints(std::move(seen), colours::wall, 3.5);
  Panel fitted("fitted: " + counted(corners.size() - arcs, "segment") + " and " +
               counted(arcs, "arc"));
  addPlan(plan, 2.5, fitted);
  fitted.addPoints(std::move(corners), colours::ink, 6);
  addRoomNumbers(plan, fitted);
  for (Panel* panel : {&boundary, &fitted})
    panel->setView(viewOf(plan, margin));
  Picture picture("Floor plan of " + counted(plan.rooms.size(), "room"));
  picture.addMaps({boundary, fitted});
  picture.addLegend("boundary point on a wall", colours::wall);
  picture.addLegend("edge of the ceiling, no wall seen", unsupported);
  addPlanLegend(plan, picture);
  return picture;
}

} // namespace pcl::sedr::tools
