// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room_layers.h"

#include <pcl/sedr_surface/triangle_mesh.h>

#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief Tilts walls of a solid that was built with vertical ones. Every vertex moves
 * to the intersection of its surfaces (walls, ceilings, floors, risers) by Newton's
 * method. Floors and ceilings that would fold are triangulated again. The adjacency of
 * surfaces does not change.
 * @param layers of the room with vertical walls, which are exact at height `head`
 * @param runs of each wall: metres into the room per metre of height
 * @param[in,out] solid with indices into layers.elements
 * @return an empty string, or what cannot be built, as the end of a sentence */
std::string tiltWalls(const RoomLayers& layers,
                      const std::vector<double>& runs,
                      double head,
                      TriangleMesh& solid);

} // namespace pcl::sedr
