// SPDX-License-Identifier: BSD-3-Clause
#include "vertical_walls.h"

#include <pcl/sedr_segmentation/tilted_faces.h>

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

} // namespace

Eigen::Vector3d
withVerticalWalls(const std::vector<TiltedFace>& faces, const Eigen::Vector3d& p)
{
  constexpr double beside = 0.4;  // of a face, whose ends are known to a patch, metres
  constexpr double reach = 1;     // metres
  constexpr double on_face = 1e6; // weight there: it follows the face alone
  // Each face asks for its shift along its normal, the point for none: least squares.
  Eigen::Matrix2d asked = Eigen::Matrix2d::Identity();
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
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
    const double near = 1 - std::abs(from.dot(left) + shift) / width;
    if (near <= 0)
      continue;
    const double weight = std::min(near / (1 - near), on_face);
    asked += weight * left * left.transpose();
    sum += weight * shift * left;
  }
  Eigen::Vector3d moved = p;
  moved.head<2>() += asked.inverse() * sum;
  return moved;
}

void
tiltWalls(const std::vector<TiltedFace>& faces, Floorplan& plan)
{
  for (PlanRoom& room : plan.rooms) {
    auto& walls = room.boundary.elements;
    std::vector<bool> is_moved(walls.size(), false);
    std::vector<std::size_t> wall_of; // of each niche
    for (const PlanNiche& niche : room.niches) {
      const PlanElement& mouth = niche.boundary.elements.back();
      wall_of.push_back(room.boundary.nearest((mouth.start + mouth.end) / 2));
    }
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
      for (std::size_t k = 0; k < wall_of.size(); ++k)
        for (PlanElement& side : room.niches[k].boundary.elements)
          if (wall_of[k] == i) {
            side.start += foot;
            side.end += foot;
          }
      is_moved[i] = true;
      wall.tilt = std::atan(sign * face->run);
    }
    rejoin(room.boundary, is_moved);
  }
}

} // namespace pcl::sedr
