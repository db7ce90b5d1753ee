// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/impl/room_samples.h>
#include <pcl/sedr_surface/structural_poisson.h>

namespace pcl::sedr {

/** @brief Makes the surface of a room by screened Poisson: solved near the origin,
 * reduced to its largest component, with the label of the nearest point.
 * @param samples finite, with unit normals, on whose side those of the mesh are
 * @param parameters in range
 * @return an empty mesh if there is no surface; it is closed if the report says so */
RoomSurface surfaceOf(const RoomSamples& samples,
                      const RoomPoissonParameters& parameters);

} // namespace pcl::sedr
