// SPDX-License-Identifier: BSD-3-Clause
#include "plan_layers.h"

#include "map_cells.h"
#include "scale.h"

#include <algorithm>

namespace pcl {
namespace sedr {
namespace tools {

namespace {

Box
boxOf(const PlanLoop& loop)
{
  Box box;
  for (const auto& corner : loop.polygon(0.01))
    box.extend(corner);
  return box;
}

/** @brief A place deep inside a room. */
Eigen::Vector2d
middleOf(const PlanRoom& room)
{
  constexpr double parts = 60;
  const Box box = boxOf(room.boundary);
  const CellGrid grid(std::max(0.01, box.size().maxCoeff() / parts));
  const Cell low = grid.at(box.low.x(), box.low.y());
  const Cell high = grid.at(box.high.x(), box.high.y());
  std::vector<CellKey> inside;
  for (std::int32_t y = low.y; y <= high.y; ++y)
    for (std::int32_t x = low.x; x <= high.x; ++x)
      if (room.contains(grid.centre({x, y})))
        inside.push_back(keyOf({x, y}));
  return inside.empty() ? Eigen::Vector2d((box.low + box.high) / 2)
                        : labelPlace(CellSet(std::move(inside)), grid.size());
}

} // namespace

void
addPlan(const Floorplan& plan, double pixels, Panel& panel)
{
  for (const auto& room : plan.rooms) {
    for (const auto& detail : room.details) {
      panel.addLoop(detail.boundary, colours::detail, colours::detail, pixels);
      for (const auto& hole : detail.holes)
        panel.addLoop(hole, colours::detail, colours::detail, pixels);
    }
    for (const auto& column : room.columns)
      panel.addLoop(column, colours::column, colours::column, pixels);
    panel.addLoop(room.boundary, colours::ink, colours::arc, pixels);
  }
}

void
addCorners(const Floorplan& plan, Panel& panel)
{
  std::vector<Eigen::Vector2d> corners;
  for (const auto& room : plan.rooms)
    for (const auto& element : room.boundary.elements)
      corners.push_back(element.start);
  panel.addPoints(std::move(corners), colours::ink, 7);
}

void
addRoomNumbers(const Floorplan& plan, bool with_area, Panel& panel)
{
  for (const auto& room : plan.rooms) {
    std::string name = std::to_string(room.id);
    if (with_area)
      name += ": " + fixedText(room.area(), 1) + " m2";
    panel.addLabel(middleOf(room), name);
  }
}

void
addPlanLegend(Picture& picture)
{
  picture.addLegend("segment", colours::ink);
  picture.addLegend("arc", colours::arc);
  picture.addLegend("column", colours::column);
  picture.addLegend("detail of the ceiling", colours::detail);
}

Box
viewOf(const Floorplan& plan, double margin)
{
  Box view;
  for (const auto& room : plan.rooms)
    view.extend(boxOf(room.boundary));
  return view.isEmpty() ? view : view.grown(margin);
}

} // namespace tools
} // namespace sedr
} // namespace pcl
