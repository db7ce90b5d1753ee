// SPDX-License-Identifier: BSD-3-Clause
#include "stage_pictures.h"

#include "sedr_filters/src/base/number_text.h"
#include "sedr_filters/src/plan/plan_bounds.h"
#include "sedr_surface/src/drawing/text_spot.h"

#include <array>
#include <iterator>

namespace pcl::sedr::tools {
namespace {

/** @brief Adds walls, columns and details of all rooms. */
void
addPlan(const Floorplan& plan, double pixels, Panel& panel)
{
  for (const PlanRoom& room : plan.rooms) {
    for (const auto& [details, colour] :
         {std::pair(&room.floor_details, colours::floor),
          std::pair(&room.details, colours::detail)})
      for (const PlanDetail& detail : *details) {
        panel.addLoop(detail.boundary, colour, colour, pixels);
        for (const PlanLoop& hole : detail.holes)
          panel.addLoop(hole, colour, colour, pixels);
      }
    for (const PlanNiche& niche : room.niches)
      panel.addLoop(niche.boundary, colours::wall, colours::wall, pixels);
    for (const PlanLoop& column : room.columns)
      panel.addLoop(column, colours::column, colours::column, pixels);
    panel.addLoop(room.boundary, colours::ink, colours::arc, pixels);
  }
}

/** @brief Returns the extent of all rooms with some space around. */
Box
viewOf(const Floorplan& plan)
{
  Box view;
  for (const PlanRoom& room : plan.rooms)
    view.extend(boundsOf(room.boundary));
  return grown(view, 0.4);
}

} // namespace

Picture
drawPlan(const Floorplan& plan, const std::vector<FittedBoundary>& boundaries)
{
  constexpr Colour unsupported = colours::recovered;
  std::array<Places, 2> samples; // without and with a wall
  for (const FittedBoundary& boundary : boundaries)
    for (const auto& sample : boundary.samples)
      samples[sample.isSupported() ? 1 : 0].push_back(sample.position);
  Panel boundary("boundary: " +
                 counted(samples[0].size() + samples[1].size(), "point"));
  addPlan(plan, 1, boundary);
  boundary.addPoints(samples[0], unsupported);
  boundary.addPoints(samples[1], colours::wall);
  Panel fitted;
  addPlan(plan, 2.5, fitted);
  Places corners;
  std::size_t arcs = 0;
  for (const PlanRoom& room : plan.rooms) {
    for (const PlanElement& element : room.boundary.elements) {
      arcs += element.isArc() ? 1 : 0;
      corners.push_back(element.start);
    }
    fitted.addLabel(textSpotIn(room.boundary, room.columns).place,
                    std::to_string(room.id) + ": " + decimalText(room.area(), 1) +
                        " m²");
  }
  fitted.addPoints(corners, colours::ink, 0.08);
  fitted.title = "fitted: " + counted(corners.size() - arcs, "segment") + " and " +
                 counted(arcs, "arc");
  Picture picture("Floor plan of " + counted(plan.rooms.size(), "room"));
  picture.addMaps({boundary, fitted}, viewOf(plan));
  picture.addLegend("boundary point on a wall", colours::wall);
  picture.addLegend("edge of the ceiling, no wall seen", unsupported);
  picture.addLegend("segment", colours::ink);
  picture.addLegend("arc", colours::arc);
  picture.addLegend("column", colours::column);
  picture.addLegend("detail of the ceiling", colours::detail);
  picture.addLegend("step of the floor", colours::floor);
  return picture;
}

} // namespace pcl::sedr::tools
