// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room_layers.h"

#include <pcl/sedr_surface/triangle_mesh.h>

#include <string>

namespace pcl::sedr {

/** @brief Returns a room with vertical walls, each at its position at headOf() the
 * room. Its details move with them. */
PlanRoom verticalAtHead(const PlanRoom& room);

/** @brief Tilts walls of a solid that was built with vertical ones. Every vertex moves
 * to the intersection of its surfaces (walls, ceilings, floors, risers) by Newton's
 * method. Floors and ceilings that would fold are triangulated again. The adjacency of
 * surfaces does not change.
 * @param layers of verticalAtHead()
 * @param room with tilted walls
 * @param[in,out] solid with indices into layers.elements
 * @return an empty string, or what cannot be built, as the end of a sentence */
std::string
tiltSolid(const RoomLayers& layers, const PlanRoom& room, TriangleMesh& solid);

} // namespace pcl::sedr
