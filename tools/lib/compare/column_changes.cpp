// SPDX-License-Identifier: BSD-3-Clause
#include "element_changes.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::sedr::tools {

namespace {

struct Column {
  std::string name;
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double area = 0;     ///< square metres
  RoomHeights heights; ///< of its room
};

Column
columnOf(const PlanLoop& loop, const std::string& name)
{
  Column column;
  column.name = name;
  const auto corners = loop.polygon(0.001);
  double sum = 0;
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Eigen::Vector2d a = corners[k] - corners[0];
    const Eigen::Vector2d b = corners[(k + 1) % corners.size()] - corners[0];
    const double twice = a.x() * b.y() - a.y() * b.x();
    sum += twice;
    moment += twice * (a + b) / 3;
  }
  column.area = std::abs(sum) / 2;
  if (std::abs(sum) > 0)
    column.centre = corners[0] + moment / sum;
  return column;
}

std::vector<Column>
columnsOf(const Floorplan& plan)
{
  std::vector<Column> columns;
  for (const auto& room : plan.rooms)
    for (std::size_t k = 0; k < room.columns.size(); ++k) {
      columns.push_back(columnOf(room.columns[k], "room_" + std::to_string(room.id) +
                                                      "_column_" +
                                                      std::to_string(k + 1)));
      columns.back().heights = heightsOf(room);
    }
  return columns;
}

/** @brief Returns the distance of two columns, if they may be the same one. */
double
distanceOf(const Column& a, const Column& b)
{
  constexpr double max_ratio = 2; // of areas; hidden sides are inferred
  const bool is_alike = a.area < max_ratio * b.area && b.area < max_ratio * a.area &&
                        shareHeights(a.heights, b.heights);
  return is_alike ? (a.centre - b.centre).norm()
                  : std::numeric_limits<double>::infinity();
}

bool
isInARoom(const Floorplan& plan, const Column& column)
{
  const auto rooms = roomsAt(plan, column.heights);
  return std::any_of(rooms.begin(), rooms.end(), [&](const PlanRoom* room) {
    return room->contains(column.centre);
  });
}

/** @brief Adds the columns of a list that lie in a room of the other plan. */
void
addAll(const std::vector<Column>& columns,
       const Floorplan& other,
       ChangeKind kind,
       std::vector<Change>& changes)
{
  for (const auto& column : columns) {
    if (!isInARoom(other, column))
      continue;
    Change change;
    change.kind = kind;
    change.what = "column";
    (kind == ChangeKind::Appeared ? change.after : change.before)
        .push_back(column.name);
    change.size = column.area;
    changes.push_back(change);
  }
}

} // namespace

std::vector<Change>
columnChanges(const Floorplan& before,
              const Floorplan& after,
              const CompareSettings& settings)
{
  std::vector<Change> changes;
  auto gone = columnsOf(before);
  auto come = columnsOf(after);
  while (true) {
    double least = settings.farthest;
    auto a_best = gone.end();
    auto b_best = come.end();
    for (auto a = gone.begin(); a != gone.end(); ++a)
      for (auto b = come.begin(); b != come.end(); ++b)
        if (distanceOf(*a, *b) < least) {
          least = distanceOf(*a, *b);
          a_best = a;
          b_best = b;
        }
    if (a_best == gone.end())
      break;
    if (least > settings.tolerance) {
      Change change;
      change.what = "column";
      change.before = {a_best->name};
      change.after = {b_best->name};
      change.shift.head<2>() = b_best->centre - a_best->centre;
      change.size = a_best->area;
      changes.push_back(change);
    }
    gone.erase(a_best);
    come.erase(b_best);
  }
  addAll(gone, after, ChangeKind::Vanished, changes);
  addAll(come, before, ChangeKind::Appeared, changes);
  return changes;
}

} // namespace pcl::sedr::tools
