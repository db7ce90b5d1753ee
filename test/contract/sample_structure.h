// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contract.h"

#include <cstdint>

namespace contract {

/** The results of earlier stages for a cloud of sample rooms: the label and room of
 * each point, and the plan. A room far away is room 2. Without walls, the plan is a
 * room of 6 m x 6 m about the origin. */
struct SampleStructure {
  std::shared_ptr<pcl::sedr::Floorplan> plan = std::make_shared<pcl::sedr::Floorplan>();
  std::vector<std::uint32_t> labels;
  std::vector<std::uint32_t> rooms;

  SampleStructure() = default;

  /** @param indices the points that define the plan */
  SampleStructure(const Cloud& cloud, const pcl::Indices& indices)
  {
    for (const auto& p : cloud) {
      labels.push_back(p.z > 2.45f ? 1 : p.z < 0.05f ? 2 : 3);
      rooms.push_back(p.x > 4096.f ? 2 : 1);
    }
    for (const std::uint32_t room : {1u, 2u})
      addRoom(cloud, indices, room);
  }

private:
  void addRoom(const Cloud& cloud, const pcl::Indices& indices, std::uint32_t room)
  {
    Eigen::Vector2d low = Eigen::Vector2d::Constant(1e9);
    Eigen::Vector2d high = -low;
    for (const auto i : indices) {
      const auto at = static_cast<std::size_t>(i);
      if (i < 0 || at >= cloud.size() || rooms[at] != room || !isFinite(cloud[at]))
        continue;
      const Eigen::Vector2d place(cloud[at].x, cloud[at].y);
      low = low.cwiseMin(place);
      high = high.cwiseMax(place);
    }
    const bool has_walls = (high - low).minCoeff() > 1;
    if (!has_walls && room == 2)
      return;
    if (!has_walls)
      low = -(high = Eigen::Vector2d(3, 3));
    plan->rooms.push_back(sedr_test::roomOf(
        sedr_test::rectangle(low.x(), low.y(), high.x(), high.y()), 2.5, room));
  }
};

inline std::string
bytesOf(const std::vector<pcl::sedr::SurfacePoint>& points)
{
  std::string bytes;
  for (const auto& p : points)
    bytes += bytesOf(p.position.x(), p.position.y(), p.position.z(), p.normal.x(),
                     p.normal.y(), p.normal.z(), static_cast<std::uint32_t>(p.label),
                     p.room);
  return bytes;
}

} // namespace contract
