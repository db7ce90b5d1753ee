// SPDX-License-Identifier: BSD-3-Clause
#include "element_changes.h"

#include <pcl/sedr_filters/priors.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace pcl::sedr::tools {

namespace {

const double alike = std::cos(M_PI / 9);     // between directions of the same surface
const double parallel = std::cos(M_PI / 18); // before and after a move

/** @brief A part of a wall that the other plan does not have; its size is its length.
 */
struct Face : Element {
  std::uint32_t room = 0;
  std::size_t number = 0; ///< of the wall in its room, from 0
  std::size_t walls = 0;  ///< number of walls in that room
  double from = 0;        ///< along the wall, metres
  double to = 0;
  double way = 0;           ///< that it moved along its normal, metres
  std::string after{};      ///< its name then
  PlanLoop after_outline{}; ///< likewise

  const PlanElement& wall() const { return outline.elements[0]; }
  Eigen::Vector2d place() const { return wall().pointAt((from + to) / 2); }
  Eigen::Vector2d normal() const { return wall().normalAt((from + to) / 2); }

  /** @brief Returns whether nearly all of the wall is missing, as is required for a
   * move. */
  bool isWhole() const { return size > 0.7 * wall().length(); }
};

/** @brief Returns whether any of the rooms has a wall with the same orientation at a
 * place. */
bool
hasWallAt(const std::vector<const PlanRoom*>& rooms,
          const Eigen::Vector2d& place,
          const Eigen::Vector2d& normal,
          double tolerance)
{
  for (const PlanRoom* room : rooms)
    for (const auto& wall : room->boundary.elements) {
      const double s = wall.project(place);
      if ((wall.pointAt(s) - place).norm() <= tolerance &&
          wall.normalAt(s).dot(normal) > alike)
        return true;
    }
  return false;
}

/** @brief Sets the longest piece of a face's wall that rooms of another plan do not
 * have; empty if they have all of it. */
void
findMissing(const std::vector<const PlanRoom*>& others, double tolerance, Face& face)
{
  constexpr double step = 0.05; // metres, along a wall
  const PlanElement& wall = face.wall();
  const auto count = static_cast<std::size_t>(std::max(1.0, wall.length() / step));
  const double width = wall.length() / static_cast<double>(count);
  std::size_t first = 0;
  for (std::size_t k = 0; k <= count; ++k) {
    const double s = (static_cast<double>(k) + 0.5) * width;
    if (k < count && !hasWallAt(others, wall.pointAt(s), wall.normalAt(s), tolerance))
      continue;
    if (static_cast<double>(k - first) * width > face.size) {
      face.from = static_cast<double>(first) * width;
      face.to = static_cast<double>(k) * width;
      face.size = face.to - face.from;
    }
    first = k + 1;
  }
}

/** @brief Returns the longest missing piece of each wall, if long enough to count. It
 * is compared with walls of the other plan at the heights of its room. */
std::vector<Face>
missingFaces(const Floorplan& plan,
             const Floorplan& other,
             const CompareSettings& settings,
             const std::set<std::string>& ignored)
{
  std::vector<Face> faces;
  for (const auto& room : plan.rooms) {
    const std::string name = "room_" + std::to_string(room.id);
    if (ignored.count(name) > 0)
      continue;
    const RoomHeights heights = heightsOf(room);
    const auto others = roomsAt(other, heights);
    const auto& walls = room.boundary.elements;
    for (std::size_t k = 0; k < walls.size(); ++k) {
      Face face;
      face.name = name + "_wall_" + std::to_string(k + 1);
      face.outline = {{walls[k]}};
      face.heights = heights;
      face.room = room.id;
      face.number = k;
      face.walls = walls.size();
      findMissing(others, settings.tolerance, face);
      if (face.size >= settings.minimum_length)
        faces.push_back(face);
    }
  }
  return faces;
}

/** @brief Returns whether two faces are side by side over half of the shorter one. */
bool
overlap(const Face& a, const Face& b)
{
  const Eigen::Vector2d way(a.normal().y(), -a.normal().x());
  const auto extentOf = [&](const Face& f) {
    return std::minmax({way.dot(f.wall().pointAt(f.from)), way.dot(f.place()),
                        way.dot(f.wall().pointAt(f.to))});
  };
  const auto [a_low, a_high] = extentOf(a);
  const auto [b_low, b_high] = extentOf(b);
  return std::min(a_high, b_high) - std::max(a_low, b_low) >
         std::min(a_high - a_low, b_high - b_low) / 2;
}

/** @brief Returns the distance from `a` to `b` along the normal if `b` may be the moved
 * `a`; else infinite, e.g. on another storey. */
double
distance(const Face& a, const Face& b)
{
  const bool is_alike = a.isWhole() && b.isWhole() &&
                        a.wall().isArc() == b.wall().isArc() &&
                        shareHeights(a.heights, b.heights) &&
                        a.normal().dot(b.normal()) >= parallel && overlap(a, b);
  return is_alike ? a.normal().dot(b.place() - a.place()) : never;
}

/** @brief Returns whether two faces belong to one partition: opposite each other within
 * its maximum thickness, at the same heights. */
bool
arePartition(const Face& a, const Face& b)
{
  const double thickness = -a.normal().dot(b.place() - a.place());
  return a.room != b.room && shareHeights(a.heights, b.heights) &&
         a.normal().dot(b.normal()) <= -parallel && overlap(a, b) && thickness > 0 &&
         thickness < Priors().max_wall;
}

/** @brief Returns whether two walls are consecutive in the outline of one room. */
bool
areNeighbours(const Face& a, const Face& b)
{
  const std::size_t apart =
      a.number > b.number ? a.number - b.number : b.number - a.number;
  return a.room == b.room && (apart == 1 || apart + 1 == a.walls);
}

/** @brief Removes pieces of walls with no room of the other plan in front of them. An
 * element that appeared or vanished there hides them and is reported itself. */
void
dropHidden(std::vector<Face>& faces, const Floorplan& other)
{
  constexpr double before = 0.1; // metres
  const auto is_hidden = [&](const Face& face) {
    const Eigen::Vector2d place = face.place() + before * face.normal();
    const auto rooms = roomsAt(other, face.heights);
    return !face.isWhole() &&
           std::none_of(rooms.begin(), rooms.end(),
                        [&](const PlanRoom* room) { return room->contains(place); });
  };
  faces.erase(std::remove_if(faces.begin(), faces.end(), is_hidden), faces.end());
}

/** @brief Adds a change for each group of faces that belong together: a partition that
 * changed on both sides by the same, or neighbours that appeared or vanished. */
void
addChanges(std::vector<Face> faces,
           ChangeKind kind,
           double tolerance,
           std::vector<Change>& changes)
{
  while (!faces.empty()) {
    std::vector<Face> group{faces.front()};
    faces.erase(faces.begin());
    bool is_partition = false;
    for (std::size_t k = 0; k < group.size(); ++k)
      for (std::size_t i = 0; i < faces.size();) {
        const bool is_opposite = arePartition(group[k], faces[i]) &&
                                 std::abs(group[k].way + faces[i].way) < 2 * tolerance;
        if (!is_opposite &&
            (kind == ChangeKind::Moved || !areNeighbours(group[k], faces[i]))) {
          ++i;
          continue;
        }
        is_partition = is_partition || is_opposite;
        group.push_back(faces[i]);
        faces.erase(faces.begin() + static_cast<std::ptrdiff_t>(i));
      }
    Change change{kind, is_partition        ? "partition"
                        : group.size() == 1 ? "wall"
                                            : "walls"};
    change.is_length = true;
    for (const Face& face : group) {
      const bool is_moved = kind == ChangeKind::Moved;
      (kind == ChangeKind::Appeared ? change.after : change.before)
          .push_back(face.name);
      if (is_moved)
        change.after.push_back(face.after);
      change.outlines.push_back(is_moved ? face.after_outline : face.outline);
      change.size =
          is_partition ? std::max(change.size, face.size) : change.size + face.size;
      change.shift.head<2>() +=
          face.way * face.normal() / static_cast<double>(group.size());
    }
    changes.push_back(change);
  }
}

} // namespace

std::vector<Change>
wallChanges(const Floorplan& before,
            const Floorplan& after,
            const CompareSettings& settings,
            const std::vector<Change>& rooms)
{
  std::set<std::string> ignored[2]; // rooms of the plan before, and after
  for (const Change& room : rooms) {
    ignored[0].insert(room.before.begin(), room.before.end());
    ignored[1].insert(room.after.begin(), room.after.end());
  }
  auto gone = missingFaces(before, after, settings, ignored[0]);
  auto come = missingFaces(after, before, settings, ignored[1]);
  std::vector<Face> moved;
  for (auto& [a, b] : takePairs(gone, come, settings.farthest, [](auto&a, auto&b) {
         return std::abs(distance(a, b));
       })) {
    moved.push_back(a);
    moved.back().way = distance(a, b);
    moved.back().after = b.name;
    moved.back().after_outline = b.outline;
  }
  dropHidden(gone, after);
  dropHidden(come, before);
  std::vector<Change> changes;
  addChanges(moved, ChangeKind::Moved, settings.tolerance, changes);
  addChanges(gone, ChangeKind::Vanished, settings.tolerance, changes);
  addChanges(come, ChangeKind::Appeared, settings.tolerance, changes);
  return changes;
}

} // namespace pcl::sedr::tools
