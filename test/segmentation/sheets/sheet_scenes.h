// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "segmentation/plan/room_evidence.h"

namespace sedr_test {

using Height = std::function<double(double, double)>;

/** A rectangular room with a ceiling in closed form, and points of it. */
struct Scene {
  double width = 6;
  double depth = 4;
  Height height;
  RoomPoints points; ///< of floor, walls, ceiling and what was added
  RoomParts parts;
  double turn = 0; ///< of the room about the origin, degrees

  Eigen::Vector2d placed(double x, double y) const
  {
    return Eigen::Rotation2Dd(turn * M_PI / 180) * Eigen::Vector2d(x, y);
  }

  /** Adds points of the vertical face between two places, if the ceiling jumps there.
   */
  void addRiser(Eigen::Vector2d a, Eigen::Vector2d b)
  {
    const auto rise = [&] { return height(b.x(), b.y()) - height(a.x(), a.y()); };
    for (int k = 0; k < 20; ++k) {
      const Eigen::Vector2d middle = (a + b) / 2;
      const double h = height(middle.x(), middle.y());
      (std::abs(h - height(a.x(), a.y())) > std::abs(rise()) / 2 ? b : a) = middle;
    }
    const Eigen::Vector2d p = placed(a.x(), a.y());
    const double low = height(a.x(), a.y()) + std::min(rise(), 0.0);
    if (std::abs(rise()) > 0.01)
      for (double z = low; z < low + std::abs(rise()); z += 0.03)
        parts.details.push_back(points.point(p.x(), p.y(), z));
  }
};

/** Makes points of a ceiling every 4 cm, with noise along the normal, of its steps,
 * and below it of walls and a floor. */
inline Scene
sceneOf(double width,
        double depth,
        const Height& height,
        double noise = 0.01,
        double turn = 0,
        unsigned seed = 1,
        bool sees_steps = true)
{
  constexpr double spacing = 0.04;
  Scene scene{width, depth, height, RoomPoints(0.05, 0.003), {}, turn};
  const PlanLoop loop = rectangle(0, 0, width, depth);
  scene.parts.floor = scene.points.slab(sedr_test::placed(loop, turn, {0, 0}), -1);
  for (const PlanElement& e : loop.elements)
    for (double s = spacing / 2; s < e.length(); s += spacing) {
      const Eigen::Vector2d p = e.pointAt(s);
      const Eigen::Vector2d at = scene.placed(p.x(), p.y());
      for (double z = -1 + spacing / 2; z < height(p.x(), p.y()); z += spacing)
        scene.parts.walls.push_back(scene.points.point(at.x(), at.y(), z));
    }
  std::mt19937 random(seed);
  std::normal_distribution<double> off(0, noise);
  std::uniform_real_distribution<double> jitter(0, spacing);
  for (double y = 0; y < depth; y += spacing)
    for (double x = 0; x < width; x += spacing) {
      const double u = std::min(x + jitter(random), width);
      const double v = std::min(y + jitter(random), depth);
      const double dx = (height(u + 1e-5, v) - height(u - 1e-5, v)) / 2e-5;
      const double dy = (height(u, v + 1e-5) - height(u, v - 1e-5)) / 2e-5;
      const Eigen::Vector3d p = Eigen::Vector3d(u, v, height(u, v)) +
                                off(random) * Eigen::Vector3d(-dx, -dy, 1).normalized();
      const Eigen::Vector2d at = scene.placed(p.x(), p.y());
      scene.parts.ceiling.push_back(scene.points.point(at.x(), at.y(), p.z()));
      if (!sees_steps)
        continue;
      scene.addRiser({x, y}, {x + spacing, y});
      scene.addRiser({x, y}, {x, y + spacing});
    }
  return scene;
}

inline PlanRoom
fittedRoom(const Scene& scene)
{
  return fitted(scene.points, scene.parts);
}

/** Deviation of a ceiling from the truth along the normal: mean, and share of places
 * beyond a centimetre; more than a cell off the walls. */
struct Off {
  double mean = 0;
  double beyond = 0;
};

inline Off
offBy(const Scene& scene, const PlanRoom& room)
{
  constexpr double step = 0.021;
  Off off;
  int count = 0;
  for (double y = step / 2; y < scene.depth; y += step)
    for (double x = step / 2; x < scene.width; x += step) {
      const double truth = scene.height(x, y);
      const double dx = (scene.height(x + 1e-4, y) - scene.height(x - 1e-4, y)) / 2e-4;
      const double dy = (scene.height(x, y + 1e-4) - scene.height(x, y - 1e-4)) / 2e-4;
      const double d = std::abs(room.ceilingAt(scene.placed(x, y)) - truth) /
                       std::sqrt(1 + dx * dx + dy * dy);
      off.mean += d;
      off.beyond += d > 0.01 ? 1 : 0;
      ++count;
    }
  off.mean /= count;
  off.beyond /= count;
  return off;
}

} // namespace sedr_test
