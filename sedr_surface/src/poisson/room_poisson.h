// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/impl/room_samples.h>
#include <pcl/sedr_surface/structural_poisson.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief Reconstructs the surface of one room by screened Poisson. It is solved near
 * the origin and reduced to its largest component.
 *
 * @param points finite, with unit normals into the room
 * @param parameters in range
 * @param mesh the surface, its normals on the side of those of the points; empty if
 * there is none
 * @param nearest for each triangle the index of the point nearest to its centre
 * @param report results; `room`, `skipped_points` and `scaled_normals` are not changed
 * @return true if there is a surface; it is closed if report.closed */
bool reconstructRoom(const std::vector<OrientedPoint>& points,
                     const RoomPoissonParameters& parameters,
                     TriangleMesh& mesh,
                     std::vector<std::uint32_t>& nearest,
                     RoomPoissonReport& report);

/** @brief Makes the surface of a room from its samples; parameters in range. */
RoomSurface surfaceOf(const RoomSamples& samples,
                      const RoomPoissonParameters& parameters);

} // namespace pcl::sedr
