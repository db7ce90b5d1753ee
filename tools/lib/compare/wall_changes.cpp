// SPDX-License-Identifier: BSD-3-Clause
#include "element_changes.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::sedr::tools {

namespace {

const double alike = std::cos(M_PI / 9);     // between directions of the same surface
const double parallel = std::cos(M_PI / 18); // before and after a move

/** @brief A part of a wall that the other plan does not have. */
struct Face {
  const PlanElement* wall = nullptr;
  std::uint32_t room = 0;
  std::size_t number = 0; ///< of the wall in its room, from 0
  std::size_t walls = 0;  ///< number of walls in that room
  double from = 0;        ///< along the wall, metres
  double to = 0;
  RoomHeights heights; ///< of its room

  double length() const { return to - from; }
  double middle() const { return (from + to) / 2; }
  Eigen::Vector2d place() const { return wall->pointAt(middle()); }
  Eigen::Vector2d normal() const { return wall->normalAt(middle()); }

  /** @brief Returns whether nearly all of the wall is missing, as is required for a
   * move. */
  bool isWhole() const { return length() > 0.7 * wall->length(); }

  std::string name() const
  {
    return "room_" + std::to_string(room) + "_wall_" + std::to_string(number + 1);
  }
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
  const PlanElement& wall = *face.wall;
  const auto count = static_cast<std::size_t>(std::max(1.0, wall.length() / step));
  const double width = wall.length() / static_cast<double>(count);
  std::size_t first = 0;
  for (std::size_t k = 0; k <= count; ++k) {
    const double s = (static_cast<double>(k) + 0.5) * width;
    if (k < count && !hasWallAt(others, wall.pointAt(s), wall.normalAt(s), tolerance))
      continue;
    if (static_cast<double>(k - first) * width > face.length()) {
      face.from = static_cast<double>(first) * width;
      face.to = static_cast<double>(k) * width;
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
             const std::vector<std::uint32_t>& ignored)
{
  std::vector<Face> faces;
  for (const auto& room : plan.rooms) {
    if (std::count(ignored.begin(), ignored.end(), room.id) > 0)
      continue;
    const RoomHeights heights = heightsOf(room);
    const auto others = roomsAt(other, heights);
    const auto& walls = room.boundary.elements;
    for (std::size_t k = 0; k < walls.size(); ++k) {
      Face face{&walls[k], room.id, k, walls.size(), 0, 0, heights};
      findMissing(others, settings.tolerance, face);
      if (face.length() >= settings.minimum_length)
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
    return std::minmax({way.dot(f.wall->pointAt(f.from)), way.dot(f.place()),
                        way.dot(f.wall->pointAt(f.to))});
  };
  const auto [a_low, a_high] = extentOf(a);
  const auto [b_low, b_high] = extentOf(b);
  return std::min(a_high, b_high) - std::max(a_low, b_low) >
         std::min(a_high - a_low, b_high - b_low) / 2;
}

/** @brief Returns the distance from `a` to `b` along the normal if `b` may be the moved
 * `a`; else infinite, e.g. on another storey. */
double
moveOf(const Face& a, const Face& b)
{
  const bool is_alike = a.isWhole() && b.isWhole() &&
                        a.wall->isArc() == b.wall->isArc() &&
                        shareHeights(a.heights, b.heights) &&
                        a.normal().dot(b.normal()) >= parallel && overlap(a, b);
  return is_alike ? a.normal().dot(b.place() - a.place())
                  : std::numeric_limits<double>::infinity();
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

using Move = std::pair<Face, Face>;

/** @brief Adds moves; equal moves of both faces of a partition are merged. */
void
addMoves(std::vector<Move> moves, double tolerance, std::vector<Change>& changes)
{
  const auto way = [](const Move& move) { return moveOf(move.first, move.second); };
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
    Change change;
    change.what = together.size() > 1 ? "partition" : "wall";
    change.is_length = true;
    for (const Move& move : together) {
      change.before.push_back(move.first.name());
      change.after.push_back(move.second.name());
      change.outlines.push_back({{*move.second.wall}});
      change.size = std::max(change.size, move.first.length());
      change.shift.head<2>() +=
          way(move) * move.first.normal() / static_cast<double>(together.size());
    }
    changes.push_back(change);
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
    Change change;
    change.kind = kind;
    change.is_length = true;
    change.what = is_partition ? "partition" : group.size() == 1 ? "wall" : "walls";
    for (const auto& face : group) {
      change.names().push_back(face.name());
      change.outlines.push_back({{*face.wall}});
      change.size = is_partition ? std::max(change.size, face.length())
                                 : change.size + face.length();
    }
    changes.push_back(change);
  }
}

} // namespace

std::vector<Change>
wallChanges(const Floorplan& before,
            const Floorplan& after,
            const CompareSettings& settings,
            const RoomChanges& rooms)
{
  auto gone = missingFaces(before, after, settings, rooms.before);
  auto come = missingFaces(after, before, settings, rooms.after);
  const auto distance = [](const Face& a, const Face& b) {
    return std::abs(moveOf(a, b));
  };
  std::vector<Change> changes;
  addMoves(takePairs(gone, come, settings.farthest, distance), settings.tolerance,
           changes);
  dropHidden(gone, after);
  dropHidden(come, before);
  addSingles(gone, ChangeKind::Vanished, changes);
  addSingles(come, ChangeKind::Appeared, changes);
  return changes;
}

} // namespace pcl::sedr::tools
