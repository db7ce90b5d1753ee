// SPDX-License-Identifier: BSD-3-Clause
#include "upright_walls.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pcl::sedr {

namespace {

/** @brief Returns the tilted face that most of a wall is on, null if there is none;
 * `sign` is 1 or -1 for equal or opposite directions. */
const TiltedFace*
faceBehind(const PlanElement& wall, const std::vector<TiltedFace>& faces, double& sign)
{
  constexpr double near = 0.1; // metres
  constexpr double min_cosine = 0.99;
  if (wall.isArc())
    return nullptr;
  const TiltedFace* behind = nullptr;
  double longest = 0;
  for (const TiltedFace& face : faces) {
    const Eigen::Vector2d way = (face.end - face.start).normalized();
    const Eigen::Vector2d left(-way.y(), way.x());
    const double cosine = way.dot((wall.end - wall.start).normalized());
    const auto [first, last] = std::minmax(
        {(wall.start - face.start).dot(way), (wall.end - face.start).dot(way)});
    const double from = std::max(first, 0.0);
    const double to = std::min(last, (face.end - face.start).norm());
    const Eigen::Vector2d middle = face.start + (from + to) / 2 * way;
    const double off = std::abs(
        (wall.pointAt(std::abs((middle - wall.start).dot(way))) - middle).dot(left));
    if (face.run == 0 || std::abs(cosine) < min_cosine || off >= near ||
        to - from <= longest)
      continue;
    behind = &face;
    longest = to - from;
    sign = cosine > 0 ? 1 : -1;
  }
  return behind;
}

/** @brief A face near a point and how strongly the point follows it. */
struct Pull {
  double weight = 0;
  double shift = 0; ///< metres to the left
  Eigen::Vector2d left = Eigen::Vector2d::Zero();
};

} // namespace

Eigen::Vector3d
upright(const std::vector<TiltedFace>& faces, const Eigen::Vector3d& p)
{
  constexpr double beside = 0.4; // of a face, whose ends are known to a patch, metres
  constexpr double reach = 1;    // metres
  std::vector<Pull> pulls;
  for (const TiltedFace& face : faces) {
    const Eigen::Vector2d way = (face.end - face.start).normalized();
    const Eigen::Vector2d left(-way.y(), way.x());
    const Eigen::Vector2d from = p.head<2>() - face.start;
    const double along = from.dot(way);
    if (p.z() < face.low || p.z() > face.head || along < -beside ||
        along > (face.end - face.start).norm() + beside)
      continue;
    const double shift = face.run * (face.head - p.z());
    const double width = reach + std::abs(face.run) * (face.head - face.low);
    const double weight = 1 - std::abs(from.dot(left) + shift) / width;
    if (weight > 0)
      pulls.push_back({weight, shift, left});
  }
  // The nearest face comes last, so what is on it stays on it.
  std::sort(pulls.begin(), pulls.end(),
            [](const Pull& a, const Pull& b) { return a.weight < b.weight; });
  Eigen::Vector3d moved = p;
  for (const Pull& pull : pulls) {
    const double so_far = (moved - p).head<2>().dot(pull.left);
    moved.head<2>() += pull.weight * (pull.shift - so_far) * pull.left;
  }
  return moved;
}

void
tiltWalls(const std::vector<TiltedFace>& faces, Floorplan& plan)
{
  for (PlanRoom& room : plan.rooms) {
    auto& walls = room.boundary.elements;
    std::vector<bool> is_moved(walls.size(), false);
    for (std::size_t i = 0; i < walls.size(); ++i) {
      PlanElement& wall = walls[i];
      double sign = 1;
      const TiltedFace* const face = faceBehind(wall, faces, sign);
      if (!face)
        continue;
      const double floor = room.floor.heightAt(wall.pointAt(wall.length() / 2));
      const Eigen::Vector2d out = -wall.normalAt(0);
      const Eigen::Vector2d foot = sign * face->run * (face->head - floor) * out;
      wall.start += foot;
      wall.end += foot;
      is_moved[i] = true;
      wall.tilt = std::atan(sign * face->run);
    }
    rejoin(room.boundary, is_moved);
  }
}

} // namespace pcl::sedr
