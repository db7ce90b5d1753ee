// SPDX-License-Identifier: BSD-3-Clause
#include "compare/wall_changes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace sedr {
namespace tools {

namespace {

constexpr double step = 0.05;                // between samples of a wall, metres
constexpr double thickest = 0.6;             // of a partition, metres
const double alike = std::cos(M_PI / 9);     // of directions of one surface
const double parallel = std::cos(M_PI / 18); // of a wall that has moved

/** @brief The part of a wall that the other plan does not have. */
struct Face {
  const PlanElement* wall = nullptr;
  std::uint32_t room = 0;
  std::size_t number = 0; ///< of the wall in its room, from 0
  std::size_t walls = 0;  ///< of that room
  double from = 0;        ///< along the wall, metres
  double to = 0;

  std::string name() const
  {
    return "room_" + std::to_string(room) + "_wall_" + std::to_string(number + 1);
  }

  double length() const { return to - from; }

  /** @brief Whether nearly all of the wall is missing: only then it may have moved. */
  bool isWhole() const { return length() > 0.7 * wall->length(); }

  double middle() const { return (from + to) / 2; }
  Eigen::Vector2d place() const { return wall->pointAt(middle()); }
  Eigen::Vector2d normal() const { return wall->normalAt(middle()); }

  Eigen::Vector2d direction() const
  {
    const Eigen::Vector2d n = normal();
    return {n.y(), -n.x()};
  }
};

bool
isKept(std::uint32_t room, const std::vector<std::uint32_t>& ignored)
{
  return std::find(ignored.begin(), ignored.end(), room) == ignored.end();
}

/** @brief Whether a plan has a wall at a place that faces the same way. */
bool
hasWallAt(const Floorplan& plan,
          const Eigen::Vector2d& place,
          const Eigen::Vector2d& normal,
          double tolerance)
{
  for (const auto& room : plan.rooms)
    for (const auto& wall : room.boundary.elements) {
      const double s = wall.project(place);
      if ((wall.pointAt(s) - place).norm() <= tolerance &&
          wall.normalAt(s).dot(normal) > alike)
        return true;
    }
  return false;
}

/** @brief The longest piece of a wall that another plan does not have; of no length
 * where it has all. */
Face
missingPiece(const PlanElement& wall, const Floorplan& other, double tolerance)
{
  Face longest;
  longest.wall = &wall;
  const auto count = static_cast<std::size_t>(std::max(1.0, wall.length() / step));
  const double width = wall.length() / static_cast<double>(count);
  std::size_t first = 0;
  for (std::size_t k = 0; k <= count; ++k) {
    const double s = (static_cast<double>(k) + 0.5) * width;
    if (k < count && !hasWallAt(other, wall.pointAt(s), wall.normalAt(s), tolerance))
      continue;
    if (static_cast<double>(k - first) * width > longest.length()) {
      longest.from = static_cast<double>(first) * width;
      longest.to = static_cast<double>(k) * width;
    }
    first = k + 1;
  }
  return longest;
}

std::vector<Face>
missingFaces(const Floorplan& plan,
             const Floorplan& other,
             const CompareSettings& settings,
             const std::vector<std::uint32_t>& ignored)
{
  std::vector<Face> faces;
  for (const auto& room : plan.rooms) {
    if (!isKept(room.id, ignored))
      continue;
    const auto& walls = room.boundary.elements;
    for (std::size_t k = 0; k < walls.size(); ++k) {
      Face face = missingPiece(walls[k], other, settings.tolerance);
      if (face.length() < settings.minimum_length)
        continue;
      face.room = room.id;
      face.number = k;
      face.walls = walls.size();
      faces.push_back(face);
    }
  }
  return faces;
}

/** @brief Whether two faces lie side by side over half of the shorter one's length. */
bool
overlap(const Face& a, const Face& b)
{
  const Eigen::Vector2d way = a.direction();
  const auto extentOf = [&](const Face& f) {
    return std::minmax({way.dot(f.wall->pointAt(f.from)), way.dot(f.place()),
                        way.dot(f.wall->pointAt(f.to))});
  };
  const auto [a_low, a_high] = extentOf(a);
  const auto [b_low, b_high] = extentOf(b);
  return std::min(a_high, b_high) - std::max(a_low, b_low) >
         std::min(a_high - a_low, b_high - b_low) / 2;
}

/** @brief How far a face has moved along its normal if `b` is where it is now; infinite
 * if it cannot be. */
double
moveOf(const Face& a, const Face& b)
{
  constexpr double no = std::numeric_limits<double>::infinity();
  if (!a.isWhole() || !b.isWhole() || a.wall->isArc() != b.wall->isArc() ||
      a.normal().dot(b.normal()) < parallel || !overlap(a, b))
    return no;
  return a.normal().dot(b.place() - a.place());
}

/** @brief Both faces of one partition: opposite each other, closer than it can be
 * thick, nothing of a room between them. */
bool
isPartition(const Face& a, const Face& b)
{
  if (a.room == b.room || a.normal().dot(b.normal()) > -parallel || !overlap(a, b))
    return false;
  const double thickness = -a.normal().dot(b.place() - a.place());
  return thickness > 0 && thickness < thickest;
}

bool
areNeighbours(const Face& a, const Face& b)
{
  const std::size_t apart =
      a.number > b.number ? a.number - b.number : b.number - a.number;
  return a.room == b.room && (apart == 1 || apart + 1 == a.walls);
}

/** @brief Faces that are one change. */
struct Group {
  std::vector<Face> faces;
  bool is_partition = false;
};

std::vector<Group>
grouped(const std::vector<Face>& faces)
{
  std::vector<Group> groups;
  for (const auto& face : faces) {
    Group joined{{face}, false};
    for (auto group = groups.begin(); group != groups.end();) {
      const auto belongs = [&](const Face& other) {
        return areNeighbours(face, other) || isPartition(face, other);
      };
      if (std::none_of(group->faces.begin(), group->faces.end(), belongs)) {
        ++group;
        continue;
      }
      joined.is_partition =
          joined.is_partition || group->is_partition ||
          std::any_of(group->faces.begin(), group->faces.end(),
                      [&](const Face& other) { return isPartition(face, other); });
      joined.faces.insert(joined.faces.begin(), group->faces.begin(),
                          group->faces.end());
      group = groups.erase(group);
    }
    groups.push_back(joined);
  }
  return groups;
}

/** @brief A face and where it is now. */
struct Move {
  Face before;
  Face after;
  double distance = 0; ///< along the normal, metres
};

/** @brief Takes the faces that have moved, the nearest pairs first, out of both lists.
 */
std::vector<Move>
takeMoves(std::vector<Face>& before, std::vector<Face>& after, double farthest)
{
  std::vector<Move> moves;
  while (true) {
    double least = farthest;
    std::size_t a_best = before.size();
    std::size_t b_best = after.size();
    for (std::size_t a = 0; a < before.size(); ++a)
      for (std::size_t b = 0; b < after.size(); ++b)
        if (std::abs(moveOf(before[a], after[b])) < least) {
          least = std::abs(moveOf(before[a], after[b]));
          a_best = a;
          b_best = b;
        }
    if (a_best == before.size())
      return moves;
    moves.push_back(
        {before[a_best], after[b_best], moveOf(before[a_best], after[b_best])});
    before.erase(before.begin() + static_cast<std::ptrdiff_t>(a_best));
    after.erase(after.begin() + static_cast<std::ptrdiff_t>(b_best));
  }
}

/** @brief Leaves out the pieces of walls before which the other plan has no room: what
 * has appeared there hides them, or what has vanished hid them before, and that is
 * told.
 */
void
dropHidden(std::vector<Face>& faces, const Floorplan& other)
{
  constexpr double before = 0.1; // metres
  const auto is_hidden = [&](const Face& face) {
    const Eigen::Vector2d place = face.place() + before * face.normal();
    return !face.isWhole() &&
           std::none_of(other.rooms.begin(), other.rooms.end(),
                        [&](const PlanRoom& room) { return room.contains(place); });
  };
  faces.erase(std::remove_if(faces.begin(), faces.end(), is_hidden), faces.end());
}

Change
changeOf(const std::vector<Move>& moves)
{
  Change change;
  change.kind = ChangeKind::Moved;
  change.what = moves.size() > 1 ? "partition" : "wall";
  change.is_length = true;
  for (const auto& move : moves) {
    change.before.push_back(move.before.name());
    change.after.push_back(move.after.name());
    change.size = std::max(change.size, move.before.length());
    const Eigen::Vector2d shift = move.distance * move.before.normal();
    change.shift.head<2>() += shift / static_cast<double>(moves.size());
  }
  return change;
}

/** @brief Moves of both faces of a partition by the same way are one. */
void
addMoves(std::vector<Move> moves, double tolerance, std::vector<Change>& changes)
{
  while (!moves.empty()) {
    std::vector<Move> together{moves.front()};
    moves.erase(moves.begin());
    const auto other = std::find_if(moves.begin(), moves.end(), [&](const Move& move) {
      return isPartition(together[0].before, move.before) &&
             std::abs(together[0].distance + move.distance) < 2 * tolerance;
    });
    if (other != moves.end()) {
      together.push_back(*other);
      moves.erase(other);
    }
    changes.push_back(changeOf(together));
  }
}

void
addGroups(const std::vector<Face>& faces, ChangeKind kind, std::vector<Change>& changes)
{
  for (const auto& group : grouped(faces)) {
    Change change;
    change.kind = kind;
    change.what = group.is_partition        ? "partition"
                  : group.faces.size() == 1 ? "wall"
                                            : "walls";
    change.is_length = true;
    for (const auto& face : group.faces) {
      (kind == ChangeKind::Appeared ? change.after : change.before)
          .push_back(face.name());
      change.size = group.is_partition ? std::max(change.size, face.length())
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
            const std::vector<std::uint32_t>& ignored_before,
            const std::vector<std::uint32_t>& ignored_after)
{
  auto gone = missingFaces(before, after, settings, ignored_before);
  auto come = missingFaces(after, before, settings, ignored_after);
  std::vector<Change> changes;
  addMoves(takeMoves(gone, come, settings.farthest), settings.tolerance, changes);
  dropHidden(gone, after);
  dropHidden(come, before);
  addGroups(gone, ChangeKind::Vanished, changes);
  addGroups(come, ChangeKind::Appeared, changes);
  return changes;
}

} // namespace tools
} // namespace sedr
} // namespace pcl
