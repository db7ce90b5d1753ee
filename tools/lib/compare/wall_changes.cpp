// SPDX-License-Identifier: BSD-3-Clause
#include "element_changes.h"

#include "wall_faces.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr::tools {

namespace {

/** @brief Faces that form one change. */
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

/** @brief A face and its new position. */
struct Move {
  Face before;
  Face after;
  double distance = 0; ///< along the normal, metres
};

/** @brief Removes moved faces from both lists and returns them, the nearest pairs
 * first. */
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

/** @brief Adds moves; equal moves of both faces of a partition are merged. */
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

} // namespace pcl::sedr::tools
