// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "building_of_two_rooms.h"

#include "sedr_surface/src/chain/seen_surfaces.h"

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

namespace sedr_test {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/** @brief Returns what is not explained of a cloud. */
inline std::vector<PlanWarning>
unexplained(const Cloud& cloud,
            const Floorplan& plan,
            const Building& building = buildingOfTwoRooms())
{
  const PointView points(cloud);
  const OpeningSearch maps(plan, points, nullptr, nullptr, OpeningParameters());
  return unexplainedSurfaces(points, building, plan, maps);
}

/** @brief Adds points each `step` metres on a rectangle from `corner` along `u` and
 * `v`. */
inline void
addRectangle(const Eigen::Vector3f& corner,
             const Eigen::Vector3f& u,
             const Eigen::Vector3f& v,
             Cloud& cloud,
             float step = 0.05F)
{
  for (float a = 0.025F; a < u.norm(); a += step)
    for (float b = 0.025F; b < v.norm(); b += step) {
      const Eigen::Vector3f p = corner + a * u.normalized() + b * v.normalized();
      cloud.push_back({p.x(), p.y(), p.z()});
    }
}

/** @brief Returns the walls of planned(1, 0, 4), 3 m deep: what of that at x = 0 has y
 * from 1 to 2 m and z from 0.5 to 2 m lies at x = `back`. */
inline Cloud
recessedRoom(float back, float step = 0.05F)
{
  Cloud cloud;
  addRectangle({0, 0, 0}, {4, 0, 0}, {0, 0, 2.5F}, cloud, step);
  addRectangle({0, 3, 0}, {4, 0, 0}, {0, 0, 2.5F}, cloud, step);
  addRectangle({4, 0, 0}, {0, 3, 0}, {0, 0, 2.5F}, cloud, step);
  addRectangle({0, 0, 0}, {0, 1, 0}, {0, 0, 2.5F}, cloud, step);
  addRectangle({0, 2, 0}, {0, 1, 0}, {0, 0, 2.5F}, cloud, step);
  addRectangle({0, 1, 0}, {0, 1, 0}, {0, 0, 0.5F}, cloud, step);
  addRectangle({0, 1, 2}, {0, 1, 0}, {0, 0, 0.5F}, cloud, step);
  addRectangle({back, 1, 0.5F}, {0, 1, 0}, {0, 0, 1.5F}, cloud, step);
  return cloud;
}

} // namespace sedr_test
