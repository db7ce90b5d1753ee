// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/plan_surfaces.h>
#include <pcl/sedr_filters/point_types.h>

#include <pcl/point_cloud.h>
#include <pcl/type_traits.h>

#include <cstdint>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Whether a point type has a `room`. */
template <typename PointT>
constexpr bool has_room = pcl::traits::has_field<PointT, pcl::fields::room>::value;

/** @brief The labels of a cloud: its own field if the point type has one, else none. */
template <typename PointT>
std::vector<std::uint32_t>
labelsOf(const pcl::PointCloud<PointT>& cloud)
{
  std::vector<std::uint32_t> labels;
  if constexpr (pcl::traits::has_label<PointT>::value)
    for (const auto& p : cloud)
      labels.push_back(p.label);
  return labels;
}

/** @brief The rooms of a cloud: its own field if the point type has one, else none. */
template <typename PointT>
std::vector<std::uint32_t>
roomsOf(const pcl::PointCloud<PointT>& cloud)
{
  std::vector<std::uint32_t> rooms;
  if constexpr (has_room<PointT>)
    for (const auto& p : cloud)
      rooms.push_back(p.room);
  return rooms;
}

/** @brief Moves a point to the structure, and sets its normal, label and room where its type has
 * them. */
template <typename PointT>
void
setSurfacePoint(const SurfacePoint& surface, PointT& p)
{
  p.x = static_cast<float>(surface.position.x());
  p.y = static_cast<float>(surface.position.y());
  p.z = static_cast<float>(surface.position.z());
  if constexpr (pcl::traits::has_normal<PointT>::value) {
    p.normal_x = static_cast<float>(surface.normal.x());
    p.normal_y = static_cast<float>(surface.normal.y());
    p.normal_z = static_cast<float>(surface.normal.z());
  }
  if constexpr (pcl::traits::has_label<PointT>::value)
    p.label = static_cast<std::uint32_t>(surface.label);
  if constexpr (has_room<PointT>)
    p.room = surface.room;
}

} // namespace sedr
} // namespace pcl
