// SPDX-License-Identifier: BSD-3-Clause
#include "plan_picture.h"

#include "map_cells.h"
#include "plan_layers.h"

namespace pcl::sedr::tools {

namespace {

constexpr Colour unsupported = colours::recovered;

Panel
boundaryPanel(const Floorplan& plan, const std::vector<FittedBoundary>& boundaries)
{
  std::vector<Eigen::Vector2d> seen;
  std::vector<Eigen::Vector2d> assumed;
  for (const auto& boundary : boundaries)
    for (const auto& sample : boundary.samples)
      (sample.isSupported() ? seen : assumed).push_back(sample.position);
  Panel panel("boundary: " + counted(seen.size() + assumed.size(), "point"));
  addPlan(plan, 1, panel);
  panel.addPoints(std::move(assumed), unsupported, 3.5);
  panel.addPoints(std::move(seen), colours::wall, 3.5);
  return panel;
}

Panel
planPanel(const Floorplan& plan)
{
  std::size_t segments = 0;
  std::size_t arcs = 0;
  for (const auto& room : plan.rooms)
    for (const auto& element : room.boundary.elements)
      ++(element.isArc() ? arcs : segments);
  Panel panel("fitted: " + counted(segments, "segment") + " and " +
              counted(arcs, "arc"));
  addPlan(plan, 2.5, panel);
  addCorners(plan, panel);
  addRoomNumbers(plan, true, panel);
  return panel;
}

} // namespace

Picture
drawPlan(const Floorplan& plan, const std::vector<FittedBoundary>& boundaries)
{
  constexpr double margin = 0.3;
  std::vector<Panel> maps{boundaryPanel(plan, boundaries), planPanel(plan)};
  for (auto& map : maps)
    map.setView(viewOf(plan, margin));
  Picture picture("Floor plan of " + counted(plan.rooms.size(), "room"));
  picture.addMaps(maps);
  picture.addLegend("boundary point on a wall", colours::wall);
  picture.addLegend("edge of the ceiling, no wall seen", unsupported);
  addPlanLegend(plan, picture);
  return picture;
}

} // namespace pcl::sedr::tools
