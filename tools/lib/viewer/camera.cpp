// SPDX-License-Identifier: BSD-3-Clause
#include "camera.h"

#include "results/storey_rule.h"

#include <pcl/sedr_filters/cell_grid.h>

#include <algorithm>
#include <cmath>

namespace pcl::sedr::tools {

namespace {

constexpr double eye_height = 1.6;     // metres
constexpr double wall_clearance = 0.6; // metres

/** @brief Returns the pose from which a box fills the window, looking along
 * `-towards`. */
CameraPose
poseAround(const Eigen::AlignedBox3d& box,
           const Eigen::Vector3d& towards,
           const Eigen::Vector3d& up,
           double aspect)
{
  constexpr double margin = 1.08;
  CameraPose pose;
  pose.up = up;
  pose.focus = box.center();
  const Eigen::Vector3d right = up.cross(towards).normalized();
  const Eigen::Vector3d above = towards.cross(right);
  const double slope = std::tan(pose.view_angle / 2 * M_PI / 180) / margin;
  double distance = 0;
  for (int k = 0; k < 8; ++k) {
    const Eigen::Vector3d corner =
        box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(k)) - pose.focus;
    const double needed = std::max(std::abs(corner.dot(above)) / slope,
                                   std::abs(corner.dot(right)) / (slope * aspect));
    distance = std::max(distance, needed + corner.dot(towards));
  }
  pose.position = pose.focus + distance * towards;
  return pose;
}

/** @brief Returns the free distance from a place in a direction within a room. */
double
freeWay(const PlanRoom& room, const Eigen::Vector2d& place, double angle)
{
  constexpr double step = 0.1;
  const Eigen::Vector2d way(std::cos(angle), std::sin(angle));
  double length = 0;
  while (room.contains(place + (length + step) * way))
    length += step;
  return length;
}

/** @brief Returns a pose away from walls with the longest free line of sight. */
CameraPose
poseInside(const PlanRoom& room, double aspect)
{
  Eigen::AlignedBox2d box;
  for (const auto& corner : room.boundary.polygon(0.05))
    box.extend(corner);
  constexpr int parts = 16;
  constexpr int directions = 16;
  double longest = -1;
  Eigen::Vector2d place = box.center();
  double angle = 0;
  for (int j = 0; j <= parts; ++j)
    for (int i = 0; i <= parts; ++i) {
      const Eigen::Vector2d candidate =
          box.min() + box.sizes().cwiseProduct(Eigen::Vector2d(i, j)) / parts;
      if (!room.contains(candidate) ||
          room.boundary.distance(candidate) < wall_clearance)
        continue;
      for (int k = 0; k < directions; ++k) {
        const double turned = 2 * M_PI * k / directions;
        const double length = freeWay(room, candidate, turned);
        if (length > longest + 1e-9) {
          longest = length;
          place = candidate;
          angle = turned;
        }
      }
    }
  const double floor = room.floorAt(place);
  const double eyes =
      floor + std::min(eye_height, 0.6 * (room.ceilingAt(place) - floor));
  CameraPose pose;
  pose.position = {place.x(), place.y(), eyes};
  pose.focus = pose.position + Eigen::Vector3d(std::cos(angle), std::sin(angle), -0.05);
  pose.view_angle = aspect > 1 ? 65 : 80;
  return pose;
}

} // namespace

CameraPose
cameraPose(const ViewedResult& result,
           ViewPoint view_point,
           double aspect,
           std::uint32_t storey)
{
  auto box = result.bounds();
  if (box.isEmpty())
    box.extend(Eigen::Vector3d::Zero());
  switch (view_point) {
  case ViewPoint::Top:
    return poseAround(box, Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitY(), aspect);
  case ViewPoint::Inside: {
    const StoreyRule rule(result.plan);
    const PlanStorey* shown = rule.find(storey);
    const auto rooms = shown ? partOf(result.plan, *shown).rooms : result.plan.rooms;
    const auto largest = std::max_element(
        rooms.begin(), rooms.end(),
        [](const PlanRoom& a, const PlanRoom& b) { return a.area() < b.area(); });
    if (largest != rooms.end())
      return poseInside(*largest, aspect);
    CameraPose pose;
    pose.position = box.center();
    pose.focus = pose.position + Eigen::Vector3d::UnitX();
    pose.view_angle = 65;
    return pose;
  }
  default: {
    const double azimuth = -55 * M_PI / 180;
    const double elevation = 42 * M_PI / 180;
    const Eigen::Vector3d towards(std::cos(elevation) * std::cos(azimuth),
                                  std::cos(elevation) * std::sin(azimuth),
                                  std::sin(elevation));
    return poseAround(box, towards, Eigen::Vector3d::UnitZ(), aspect);
  }
  }
}

} // namespace pcl::sedr::tools
