// SPDX-License-Identifier: BSD-3-Clause
#include "wall_tilt_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pcl::sedr {

namespace {

/** @brief A scan point in the frame of a wall: along it, normal to it, and its height.
 */
struct WallPoint {
  double along = 0;
  double off = 0;
  double z = 0;
};

/** @brief Plane off = at + turn along + run (z - floor) with its residual. */
struct WallPlane {
  Eigen::Vector3d parameters = Eigen::Vector3d::Zero();
  double residual = 0; ///< root mean square of the inliers, metres
  std::size_t inliers = 0;
};

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

/** @brief Fits a plane with weights that are 0 from three robust deviations on (Tukey).
 */
WallPlane
fitted(const std::vector<WallPoint>& points, WallPlane plane, double floor)
{
  constexpr int rounds = 10;
  constexpr std::size_t fewest = 50;
  if (points.size() < fewest)
    return plane;
  const auto offOf = [&](const WallPoint& p) {
    return p.off - plane.parameters.dot(Eigen::Vector3d(1, p.along, p.z - floor));
  };
  for (int round = 0; round < rounds; ++round) {
    std::vector<double> sizes;
    for (const WallPoint& p : points)
      sizes.push_back(std::abs(offOf(p)));
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
    std::nth_element(sizes.begin(), middle, sizes.end());
    const double limit = std::max(3 * 1.4826 * *middle, 0.003);
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    plane.inliers = 0;
    double squares = 0;
    for (const WallPoint& p : points) {
      const double off = offOf(p);
      if (std::abs(off) >= limit)
        continue;
      const double weight = std::pow(1 - std::pow(off / limit, 2), 2);
      const Eigen::Vector3d row(1, p.along, p.z - floor);
      normal.noalias() += weight * row * row.transpose();
      right += weight * off * row;
      squares += off * off;
      ++plane.inliers;
    }
    plane.parameters += normal.ldlt().solve(right);
    plane.residual = std::sqrt(squares / static_cast<double>(plane.inliers));
  }
  return plane;
}

/** @brief Returns the points of a wall except near its ends, floor and ceiling. */
std::vector<WallPoint>
pointsOf(const PlanElement& wall,
         double floor,
         double head,
         const Straightening& map,
         const PointView& raw,
         const std::vector<int>& indices)
{
  constexpr double reach = 0.04; // metres
  constexpr double border = 0.08;
  const Eigen::Vector2d way = (wall.end - wall.start).normalized();
  const Eigen::Vector2d left(-way.y(), way.x());
  std::vector<WallPoint> points;
  const std::size_t size = indices.empty() ? raw.size() : indices.size();
  for (std::size_t k = 0; k < size; ++k) {
    const std::size_t i = indices.empty() ? k : static_cast<std::size_t>(indices[k]);
    const Eigen::Vector3d p = raw[i].cast<double>();
    const Eigen::Vector2d from = p.head<2>() - wall.start;
    if (!(std::abs(from.dot(left)) < reach) || !(p.z() > floor + border) ||
        !(p.z() < head - border) || from.dot(way) < border ||
        from.dot(way) > wall.length() - border)
      continue;
    const Eigen::Vector3d scanned = map.back(p);
    const Eigen::Vector2d to = scanned.head<2>() - wall.start;
    points.push_back({to.dot(way), to.dot(left), p.z()});
  }
  return points;
}

void
moveDetails(const Straightening& map, PlanRoom& room)
{
  const auto move = [&](PlanLoop& loop, const PlanSlab& slab) {
    for (PlanElement& element : loop.elements)
      for (Eigen::Vector2d* end : {&element.start, &element.end})
        if (!element.isArc())
          *end = map.back({end->x(), end->y(), slab.heightAt(*end)}).head<2>();
  };
  for (auto* const details : {&room.details, &room.floor_details})
    for (PlanDetail& detail : *details) {
      move(detail.boundary, detail.slab);
      for (PlanLoop& hole : detail.holes)
        move(hole, detail.slab);
    }
}

} // namespace

void
fitTilts(const Straightening& map,
         const std::vector<TiltedFace>& faces,
         const PointView& raw,
         const std::vector<int>& indices,
         Floorplan& plan)
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
      const Eigen::Vector2d middle = wall.pointAt(wall.length() / 2);
      const double floor = room.floor.heightAt(middle);
      const double head = room.ceilingAt(middle + 0.01 * wall.normalAt(0));
      WallPlane plane; // of the map, the fallback if there are too few points
      plane.parameters << sign * face->run * (floor - face->head), 0, sign * face->run;
      plane.residual = wall.residual;
      plane.inliers = wall.inliers;
      plane = fitted(pointsOf(wall, floor, head, map, raw, indices), plane, floor);
      const Eigen::Vector2d way = (wall.end - wall.start).normalized();
      const Eigen::Vector2d left(-way.y(), way.x());
      for (Eigen::Vector2d* end : {&wall.start, &wall.end}) {
        const double along = (*end - wall.start).dot(way);
        *end += (plane.parameters[0] + plane.parameters[1] * along) * left;
      }
      wall.residual = plane.residual;
      wall.inliers = plane.inliers;
      is_moved[i] = true;
      wall.tilt = std::atan(plane.parameters[2]);
    }
    if (std::find(is_moved.begin(), is_moved.end(), true) == is_moved.end())
      continue;
    moveDetails(map, room);
    rejoin(room.boundary, is_moved);
  }
}

} // namespace pcl::sedr
