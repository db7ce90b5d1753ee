// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../../plan_loops.h"

#include <pcl/sedr_filters/floorplan_io.h>
#include <pcl/sedr_filters/plan_editor.h>

#include <gtest/gtest.h>

#include <string>

namespace sedr_test {

using namespace pcl::sedr;

/** Rooms 1, 2 ... of 2.5 m. */
inline Floorplan
planOf(const std::vector<PlanLoop>& outlines)
{
  Floorplan plan;
  for (const PlanLoop& outline : outlines)
    plan.rooms.push_back(
        roomOf(outline, 2.5, static_cast<std::uint32_t>(plan.rooms.size() + 1)));
  return plan;
}

/** Rooms of 4 m x 3 m and 2 m x 3 m with a wall of 20 cm and a door between them. */
inline Floorplan
twoRooms()
{
  Floorplan plan = planOf({rectangle(0, 0, 4, 3), rectangle(4.2, 0, 6.2, 3)});
  plan.openings = {
      {OpeningKind::Door, {1, 2}, {{1, 1}, {2, 3}}, {4.1, 1}, {4.1, 2}, 0, 2, 0, 0.2}};
  plan.storeys = {{1, "ground", 0, 2.5, {1, 2}}};
  return plan;
}

/** The two rooms and room 3 above the first, from z 2.8 to 5.3. */
inline Floorplan
twoStoreys()
{
  Floorplan plan = twoRooms();
  plan.rooms.push_back(roomOf(rectangle(0, 0, 4, 3), 5.3, 3));
  plan.rooms[2].floor = slabAt(2.8);
  plan.storeys.push_back({2, "first", 2.8, 5.3, {3}});
  return plan;
}

/** A flight along the x axis, 1 m wide from `y` downwards. */
inline PlanFlight
flightOf(double y, const std::vector<double>& risers, double rise)
{
  PlanFlight flight;
  for (const double x : risers)
    flight.risers.push_back({Eigen::Vector2d(x, y), {x, y - 1}});
  flight.rise = rise;
  return flight;
}

/** Why an edit was refused. */
inline std::string
refusal(bool is_done, const PlanEditor& editor)
{
  return is_done ? "it was not" : editor.getErrorMessage();
}

/** Whether an edit was done and left a plan that can be read again. */
inline testing::AssertionResult
done(bool is_done, const PlanEditor& editor)
{
  std::string problem = editor.getErrorMessage();
  if (is_done)
    floorplanFromJson(floorplanToJson(editor.getFloorplan()), problem);
  for (const PlanRoom& room : editor.getFloorplan().rooms)
    problem += outlineProblem(room.boundary);
  return is_done && problem.empty() ? testing::AssertionSuccess()
                                    : testing::AssertionFailure() << problem;
}

} // namespace sedr_test
