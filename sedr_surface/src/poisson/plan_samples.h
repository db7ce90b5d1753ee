// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_surface/impl/room_samples.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief Points on the surface of a room. */
struct PlanSamples {
  std::vector<OrientedPoint> points; ///< normals into the room
  std::vector<std::uint32_t> labels; ///< StructureLabel of each point
  std::string problem;               ///< why there are none, or empty
};

/** @brief Samples the solid of a room (extrudeRoom()): one point per `spacing`. Within
 * two spacings of an edge of more than 20 degrees there are five points per two
 * spacings, which keeps edges and corners sharp.
 *
 * @param spacing metres, above 0
 *
 * The same room gives the same points. O(n e) for n points near e edges. */
PlanSamples samplePlan(const PlanRoom& room, double spacing);

} // namespace pcl::sedr
