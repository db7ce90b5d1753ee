// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_segmentation/src/borders/sheet_plan.h"

#include "plan_loops.h"

#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace sheet_test {

using pcl::sedr::FacetSheet;
using pcl::sedr::PlanRoom;
using Height = std::function<double(double, double)>;

/** A rectangular room with a ceiling in closed form, and points of it. */
struct Scene {
  double width = 6;
  double depth = 4;
  Height height;
  std::vector<Eigen::Vector3d> points;
  std::vector<Eigen::Vector3d> risers; ///< points of vertical faces
  PlanRoom room;
  double turn = 0; ///< of the room about the origin, radians
};

/** Returns the room and its points turned about the origin. */
inline Scene
turned(Scene scene, double radians)
{
  const Eigen::Rotation2Dd turn(radians);
  for (auto* points : {&scene.points, &scene.risers})
    for (Eigen::Vector3d& p : *points)
      p.head<2>() = turn * p.head<2>();
  for (auto& element : scene.room.boundary.elements) {
    element.start = turn * element.start;
    element.end = turn * element.end;
  }
  scene.turn += radians;
  return scene;
}

/** Makes points of a ceiling every 4 cm, with noise along the normal. */
inline Scene
sceneOf(double width, double depth, Height height, double noise = 0.01, int seed = 1)
{
  constexpr double spacing = 0.04;
  Scene scene;
  scene.width = width;
  scene.depth = depth;
  scene.height = height;
  scene.room.boundary = sedr_test::rectangle(0, 0, width, depth);
  std::mt19937 random(static_cast<unsigned>(seed));
  std::normal_distribution<double> off(0, noise);
  std::uniform_real_distribution<double> jitter(0, spacing);
  for (double y = 0; y < depth; y += spacing)
    for (double x = 0; x < width; x += spacing) {
      const double u = std::min(x + jitter(random), width);
      const double v = std::min(y + jitter(random), depth);
      const double dx = (height(u + 1e-5, v) - height(u - 1e-5, v)) / 2e-5;
      const double dy = (height(u, v + 1e-5) - height(u, v - 1e-5)) / 2e-5;
      const Eigen::Vector3d normal = Eigen::Vector3d(-dx, -dy, 1).normalized();
      scene.points.push_back(Eigen::Vector3d(u, v, height(u, v)) +
                             off(random) * normal);
    }
  return scene;
}

inline FacetSheet
fitted(const Scene& scene, const pcl::sedr::SheetParameters& parameters = {})
{
  const auto grid = pcl::sedr::gridWithin(scene.room.boundary, parameters);
  return pcl::sedr::fitSheet(
      scene.points, grid, pcl::sedr::cellsWithin(grid, scene.room.boundary),
      pcl::sedr::wallDirections(scene.room.boundary), parameters);
}

/** Returns the room with the ceiling that is fitted to its points. */
inline PlanRoom
fittedRoom(const Scene& scene)
{
  PlanRoom room = scene.room;
  pcl::PointCloud<pcl::PointXYZ> cloud;
  for (const Eigen::Vector3d& p : scene.points)
    cloud.emplace_back(p.x(), p.y(), p.z());
  FacetSheet sheet = fitted(scene);
  refitToScan(sheet, pcl::sedr::PointView(cloud), {});
  giveCeiling(sheet, scene.points, scene.risers, room);
  return room;
}

/** Deviation of a ceiling from the truth along the normal: mean, and share of places
 * beyond a centimetre. */
struct Off {
  double mean = 0;
  double beyond = 0;
};

inline Off
offBy(const Scene& scene, const PlanRoom& room)
{
  constexpr double step = 0.021;
  const Eigen::Rotation2Dd turn(scene.turn);
  Off off;
  int count = 0;
  for (double y = step / 2; y < scene.depth; y += step)
    for (double x = step / 2; x < scene.width; x += step) {
      const double truth = scene.height(x, y);
      const double dx = (scene.height(x + 1e-4, y) - scene.height(x - 1e-4, y)) / 2e-4;
      const double dy = (scene.height(x, y + 1e-4) - scene.height(x, y - 1e-4)) / 2e-4;
      const double d = std::abs(room.ceilingAt(turn * Eigen::Vector2d(x, y)) - truth) /
                       std::sqrt(1 + dx * dx + dy * dy);
      off.mean += d;
      off.beyond += d > 0.01 ? 1 : 0;
      ++count;
    }
  off.mean /= count;
  off.beyond /= count;
  return off;
}

} // namespace sheet_test
