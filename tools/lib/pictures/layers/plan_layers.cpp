// SPDX-License-Identifier: BSD-3-Clause
#include "plan_layers.h"

#include "map_cells.h"
#include "scale.h"

#include <algorithm>

namespace pcl::sedr::tools {

namespace {

Box
boxOf(const PlanLoop& loop)
{
  Box box;
  for (const auto& corner : loop.polygon(0.01))
    box.extend(corner);
  return box;
}

/** @brief Returns the loops that bound a room in plan. */
std::vector<const PlanLoop*>
outlinesOf(const PlanRoom& room)
{
  std::vector<const PlanLoop*> loops{&room.boundary};
  for (const auto& niche : room.niches)
    loops.push_back(&niche.boundary);
  return loops;
}

/** @brief Returns a place deep inside a room. */
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
  const auto addDetails = [&](const std::vector<PlanDetail>& details, Colour colour) {
    for (const auto& detail : details) {
      panel.addLoop(detail.boundary, colour, colour, pixels);
      for (const auto& hole : detail.holes)
        panel.addLoop(hole, colour, colour, pixels);
    }
  };
  for (const auto& room : plan.rooms) {
    addDetails(room.floor_details, colours::floor);
    addDetails(room.details, colours::detail);
    for (const auto& niche : room.niches)
      panel.addLoop(niche.boundary, colours::wall, colours::wall, pixels);
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
  for (const auto& room : plan.rooms)
    for (const auto* loop : outlinesOf(room))
      view.extend(boxOf(*loop));
  return view.isEmpty() ? view : view.grown(margin);
}

} // namespace pcl::sedr::tools
