// SPDX-License-Identifier: BSD-3-Clause
#include "wall_feet.h"

#include "../curves/contour.h"
#include "sedr_filters/src/base/quantiles.h"
#include "sedr_filters/src/walls/plan_walls.h"
#include <pcl/sedr_filters/priors.h>

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

namespace {

constexpr double patch_size = WallSlopes::patch_size;
constexpr std::size_t min_patches = 9;

/** @brief Finds the plane of a wall among the patches that meet the ceiling there.
 * @param[out] normal of the plane, to the left of the wall
 * @param[out] offset normal . p of its points
 * @return false if there is none that leans and stands near the floor */
bool
leaningPlane(const PlanElement& wall,
             double floor,
             const WallSlopes& slopes,
             const CellGrid& grid,
             const RoomCells& cells,
             Eigen::Vector3d& normal,
             double& offset)
{
  constexpr double near = 0.1; // of a patch from the wall at the ceiling, metres
  constexpr double min_cosine = 0.97;
  constexpr double on_plane = 0.04;
  constexpr double max_turn = radians(6);
  constexpr double min_run = 0.026; // 1.5 degrees
  constexpr double min_height = 1.5;
  constexpr double max_above_floor = 1;
  const Eigen::Vector2d way = (wall.end - wall.start).normalized();
  const Eigen::Vector2d left(-way.y(), way.x());
  const auto isOn = [&](const PlanePatch& patch) {
    if (std::abs(patch.normal.head<2>().normalized().dot(left)) < min_cosine)
      return false;
    const Eigen::Vector2d to =
        atCeiling(patch.middle, runOf(patch.normal), grid, cells) - wall.start;
    return std::abs(to.dot(left)) < near && to.dot(way) > 0 &&
           to.dot(way) < wall.length();
  };
  std::size_t leaning = 0;
  for (const std::size_t k : slopes.leaning())
    leaning += isOn(slopes.patches()[k]) ? 1 : 0;
  if (leaning < min_patches)
    return false;
  std::vector<const PlanePatch*> members;
  std::vector<Weighted> runs;
  for (const PlanePatch& patch : slopes.patches())
    if (isOn(patch)) {
      members.push_back(&patch);
      runs.emplace_back(runOf(patch.normal).dot(left), patch.count);
    }
  const double run = weightedQuantile(std::move(runs), 0.5);
  normal = Eigen::Vector3d(left.x(), left.y(), -run).normalized();
  for (int round = 0; round < 2; ++round) {
    const auto alike = [&](const PlanePatch& patch) {
      return std::abs(patch.normal.dot(normal)) > std::cos(max_turn);
    };
    std::vector<Weighted> offsets;
    for (const PlanePatch* const patch : members)
      if (alike(*patch))
        offsets.emplace_back(normal.dot(patch->middle), patch->count);
    offset = weightedQuantile(std::move(offsets), 0.5);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    std::vector<double> heights;
    for (const PlanePatch* const patch : members)
      if (alike(*patch) && std::abs(normal.dot(patch->middle) - offset) < on_plane) {
        sum += (patch->normal.dot(normal) < 0 ? -patch->count : patch->count) *
               patch->normal;
        heights.push_back(patch->middle.z());
      }
    if (heights.size() < min_patches)
      return false;
    const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
    if (*high - *low + patch_size < min_height ||
        *low - patch_size / 2 - floor > max_above_floor)
      return false;
    normal = sum.normalized();
  }
  return runOf(normal).norm() > min_run;
}

/** @brief Removes the pieces into which the outline at the ceiling parts a wall that
 * leans, as it is aslant there below a slope.
 * @param heads the elements before they moved to their feet */
void
joinPieces(const std::vector<PlanElement>& heads,
           std::vector<PlanElement>& walls,
           std::vector<bool>& is_moved)
{
  constexpr double on_line = 0.3; // metres, of a short piece from its wall
  constexpr double same_foot = 0.05;
  const std::size_t n = walls.size();
  std::vector<bool> is_part(n, false); // of a wall beside it
  const auto isNear = [](const PlanElement& piece, const PlanElement& of, double most) {
    const Eigen::Vector2d way = (of.end - of.start).normalized();
    const Eigen::Vector2d left(-way.y(), way.x());
    return !piece.isArc() && std::abs((piece.start - of.start).dot(left)) < most &&
           std::abs((piece.end - of.start).dot(left)) < most;
  };
  for (const std::size_t step : {std::size_t{1}, n - 1}) // onwards, back
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = (i + step) % n; is_moved[i] && !is_part[i] && j != i;
           j = (j + step) % n) {
        if (is_part[j] || !(is_moved[j] ? isNear(walls[j], walls[i], same_foot)
                                        : 2 * heads[j].length() < heads[i].length() &&
                                              isNear(heads[j], heads[i], on_line)))
          break;
        is_part[j] = true;
      }
  for (std::size_t i = n; i-- > 0;)
    if (is_part[i]) {
      walls.erase(walls.begin() + static_cast<std::ptrdiff_t>(i));
      is_moved.erase(is_moved.begin() + static_cast<std::ptrdiff_t>(i));
    }
}

} // namespace

void
moveToFeet(const WallSlopes& slopes,
           const CellGrid& grid,
           const RoomCells& cells,
           PlanRoom& room)
{
  std::vector<PlanElement>& walls = room.boundary.elements;
  const std::vector<PlanElement> heads = walls;
  std::vector<bool> is_moved(walls.size(), false);
  for (std::size_t i = 0; i < walls.size() && !slopes.areNone(); ++i) {
    PlanElement& wall = walls[i];
    const double floor = room.floor.heightAt(wall.pointAt(wall.length() / 2));
    Eigen::Vector3d normal;
    double offset = 0;
    if (wall.isArc() || !leaningPlane(wall, floor, slopes, grid, cells, normal, offset))
      continue;
    const double across = normal.head<2>().norm();
    const Eigen::Vector2d left = normal.head<2>() / across;
    const double foot = (offset - normal.z() * floor) / across;
    for (Eigen::Vector2d* const end : {&wall.start, &wall.end})
      *end += (foot - left.dot(*end)) * left;
    wall.tilt = std::atan(-normal.z() / across);
    is_moved[i] = true;
  }
  joinPieces(heads, walls, is_moved);
  rejoin(room.boundary, is_moved);
  if (walls.size() < 3 || crossesItself(room.boundary.polygon(0.05)))
    walls = heads;
}

} // namespace pcl::sedr
