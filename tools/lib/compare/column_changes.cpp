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

/** @brief Sets area and centre of a column from its outline. */
void
measure(const PlanLoop& loop, Column& column)
{
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
}

std::vector<Column>
columnsOf(const Floorplan& plan)
{
  std::vector<Column> columns;
  for (const auto& room : plan.rooms)
    for (std::size_t k = 0; k < room.columns.size(); ++k) {
      Column column;
      column.name =
          "room_" + std::to_string(room.id) + "_column_" + std::to_string(k + 1);
      column.heights = heightsOf(room);
      measure(room.columns[k], column);
      columns.push_back(column);
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

/** @brief Adds the columns of a list that lie in a room of the other plan. */
void
addSingles(const std::vector<Column>& columns,
           const Floorplan& other,
           ChangeKind kind,
           std::vector<Change>& changes)
{
  for (const auto& column : columns) {
    const auto rooms = roomsAt(other, column.heights);
    if (std::none_of(rooms.begin(), rooms.end(), [&](const PlanRoom* room) {
          return room->contains(column.centre);
        }))
      continue;
    changes.push_back({kind, "column", {}, {}, column.area});
    changes.back().names() = {column.name};
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
  for (const auto& [a, b] : takePairs(gone, come, settings.farthest, distanceOf))
    if (distanceOf(a, b) > settings.tolerance) {
      changes.push_back({ChangeKind::Moved, "column", {a.name}, {b.name}, a.area});
      changes.back().shift.head<2>() = b.centre - a.centre;
    }
  addSingles(gone, after, ChangeKind::Vanished, changes);
  addSingles(come, before, ChangeKind::Appeared, changes);
  return changes;
}

} // namespace pcl::sedr::tools
