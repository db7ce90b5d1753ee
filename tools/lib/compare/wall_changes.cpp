// SPDX-License-Identifier: BSD-3-Clause
#include "element_changes.h"

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
  constexpr double thickest = 0.6; // metres
  const double thickness = -a.normal().dot(b.place() - a.place());
  return a.room != b.room && shareHeights(a.heights, b.heights) &&
         a.normal().dot(b.normal()) <= -parallel && overlap(a, b) && thickness > 0 &&
         thickness < thickest;
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

/** @brief Returns the change of faces that are one partition, a wall, or neighbours. */
Change
changeOf(const std::vector<Face>& faces, ChangeKind kind, bool is_partition)
{
  Change change{kind, is_partition        ? "partition"
                      : faces.size() == 1 ? "wall"
                                          : "walls"};
  change.is_length = true;
  for (const Face& face : faces) {
    (kind == ChangeKind::Appeared ? change.after : change.before).push_back(face.name);
    change.outlines.push_back(face.outline);
    change.size =
        is_partition ? std::max(change.size, face.size) : change.size + face.size;
  }
  return change;
}

using Move = std::pair<Face, Face>;

/** @brief Adds moves; equal moves of both faces of a partition are merged. */
void
addMoves(std::vector<Move> moves, double tolerance, std::vector<Change>& changes)
{
  const auto way = [](const Move& move) { return distance(move.first, move.second); };
  while (!moves.empty()) {
    std::vector<Move> together{moves.front()};
    moves.erase(moves.begin());
    const auto other = std::find_if(moves.begin(), moves.end(), [&](const Move& move) {
      return arePartition(together[0].first, move.first) &&
             std::abs(way(together[0]) + way(move)) < 2 * tolerance;
    });
    if (other != moves.end()) {
      together.push_back(*other);
      moves.erase(other);
    }
    std::vector<Face> faces;
    for (const Move& move : together)
      faces.push_back(move.first);
    changes.push_back(changeOf(faces, ChangeKind::Moved, together.size() > 1));
    changes.back().outlines.clear();
    for (const Move& move : together) {
      changes.back().after.push_back(move.second.name);
      changes.back().outlines.push_back(move.second.outline);
      changes.back().shift.head<2>() +=
          way(move) * move.first.normal() / static_cast<double>(together.size());
    }
  }
}

/** @brief Adds faces without a partner: those that are neighbours or one partition are
 * one change. */
void
addSingles(std::vector<Face> faces, ChangeKind kind, std::vector<Change>& changes)
{
  while (!faces.empty()) {
    std::vector<Face> group{faces.front()};
    faces.erase(faces.begin());
    bool is_partition = false;
    for (std::size_t k = 0; k < group.size(); ++k)
      for (std::size_t i = 0; i < faces.size();) {
        const bool opposite = arePartition(group[k], faces[i]);
        if (!opposite && !areNeighbours(group[k], faces[i])) {
          ++i;
          continue;
        }
        is_partition = is_partition || opposite;
        group.push_back(faces[i]);
        faces.erase(faces.begin() + static_cast<std::ptrdiff_t>(i));
      }
    changes.push_back(changeOf(group, kind, is_partition));
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
  std::vector<Change> changes;
  addMoves(
      takePairs(gone, come, settings.farthest,
                [](const Face& a, const Face& b) { return std::abs(distance(a, b)); }),
      settings.tolerance, changes);
  dropHidden(gone, after);
  dropHidden(come, before);
  addSingles(gone, ChangeKind::Vanished, changes);
  addSingles(come, ChangeKind::Appeared, changes);
  return changes;
}

} // namespace pcl::sedr::tools
