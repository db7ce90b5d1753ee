// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/impl/refinement.h>
#include <pcl/sedr_filters/impl/stage_error.h>
#include <pcl/sedr_filters/point_types.h>

#include <pcl/point_cloud.h>
#include <pcl/type_traits.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief True if a point type has the field `room`. */
template <typename PointT>
constexpr bool has_room = pcl::traits::has_field<PointT, pcl::fields::room>::value;

/** @brief Returns the field `room` of a cloud; empty if the type has none. */
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

/** @brief Returns what is missing or wrong in the input of a stage that works with
 * labelled points and a plan, as a sentence; empty if nothing is.
 * @param[in,out] labels of every point of the cloud; empty: filled from the point type
 * @param[in,out] rooms likewise */
template <typename PointT>
std::string
structureProblem(const Floorplan* plan,
                 const pcl::PointCloud<PointT>& cloud,
                 const pcl::Indices& indices,
                 std::vector<std::uint32_t>& labels,
                 std::vector<std::uint32_t>& rooms)
{
  if (!plan || plan->rooms.empty())
    return "no floor plan with rooms was set";
  std::string problem = indicesProblem(indices, cloud.size());
  if (!problem.empty())
    return problem;
  if constexpr (pcl::traits::has_label<PointT>::value)
    if (labels.empty())
      for (const PointT& p : cloud)
        labels.push_back(p.label);
  if (rooms.empty())
    rooms = roomsOf(cloud);
  if (labels.size() != cloud.size() || rooms.size() != cloud.size())
    problem = "the cloud has " + std::to_string(cloud.size()) + " points, but " +
              std::to_string(labels.size()) + " labels and " +
              std::to_string(rooms.size()) + " rooms are known";
  return problem;
}

/** @brief Returns the sentence that no labelled point lies on the plan. */
inline std::string
nonePlaced(const pcl::Indices& indices,
           const std::vector<std::uint32_t>& labels,
           double distance)
{
  const auto labelled = std::count_if(indices.begin(), indices.end(), [&](index_t i) {
    return labels[static_cast<std::size_t>(i)] != 0;
  });
  return "none of the " + std::to_string(labelled) + " labelled points of " +
         std::to_string(indices.size()) + " is within " + std::to_string(distance) +
         " m of its surface in the plan";
}

/** @brief Sets position, and normal, label and room where the type has them. */
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

} // namespace pcl::sedr
