// SPDX-License-Identifier: BSD-3-Clause
#include "wall_faces.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::sedr::tools {

namespace {

constexpr double step = 0.05;                // metres, along a wall
constexpr double thickest = 0.6;             // metres, of a partition
const double alike = std::cos(M_PI / 9);     // between directions of the same surface
const double parallel = std::cos(M_PI / 18); // before and after a move

bool
isKept(std::uint32_t room, const std::vector<std::uint32_t>& ignored)
{
  return std::find(ignored.begin(), ignored.end(), room) == ignored.end();
}

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

/** @brief Returns the longest piece of a wall that rooms of another plan do not have;
 * empty if they have all of it. */
Face
missingPiece(const PlanElement& wall,
             const std::vector<const PlanRoom*>& others,
             double tolerance)
{
  Face longest;
  longest.wall = &wall;
  const auto count = static_cast<std::size_t>(std::max(1.0, wall.length() / step));
  const double width = wall.length() / static_cast<double>(count);
  std::size_t first = 0;
  for (std::size_t k = 0; k <= count; ++k) {
    const double s = (static_cast<double>(k) + 0.5) * width;
    if (k < count && !hasWallAt(others, wall.pointAt(s), wall.normalAt(s), tolerance))
      continue;
    if (static_cast<double>(k - first) * width > longest.length()) {
      longest.from = static_cast<double>(first) * width;
      longest.to = static_cast<double>(k) * width;
    }
    first = k + 1;
  }
  return longest;
}

/** @brief Returns whether two faces are side by side over half of the shorter one. */
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

} // namespace

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
    const RoomHeights heights = heightsOf(room);
    const std::vector<const PlanRoom*> others = roomsAt(other, heights);
    const auto& walls = room.boundary.elements;
    for (std::size_t k = 0; k < walls.size(); ++k) {
      Face face = missingPiece(walls[k], others, settings.tolerance);
      if (face.length() < settings.minimum_length)
        continue;
      face.room = room.id;
      face.number = k;
      face.walls = walls.size();
      face.heights = heights;
      faces.push_back(face);
    }
  }
  return faces;
}

double
moveOf(const Face& a, const Face& b)
{
  constexpr double no = std::numeric_limits<double>::infinity();
  if (!a.isWhole() || !b.isWhole() || a.wall->isArc() != b.wall->isArc() ||
      !shareHeights(a.heights, b.heights) || a.normal().dot(b.normal()) < parallel ||
      !overlap(a, b))
    return no;
  return a.normal().dot(b.place() - a.place());
}

bool
isPartition(const Face& a, const Face& b)
{
  if (a.room == b.room || !shareHeights(a.heights, b.heights) ||
      a.normal().dot(b.normal()) > -parallel || !overlap(a, b))
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

} // namespace pcl::sedr::tools
