// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_surface/src/solid/room_layers.h"
#include <pcl/sedr_surface/triangle_mesh.h>

#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Lets the walls of a solid lean that was built with vertical ones: every
 * vertex moves to where the surfaces about it meet, walls, ceilings, floors and risers,
 * by Newton's method; floors and ceilings are triangulated anew where that folds them.
 * Which surfaces meet stays as it was.
 * @param layers of the room with its walls vertical, where they are at `head`
 * @param runs of each wall: metres into the room for a metre up
 * @param[in,out] solid with indices into layers.elements
 * @return an empty string, or what cannot be built so, a sentence's end */
std::string leanWalls(const RoomLayers& layers,
                      const std::vector<double>& runs,
                      double head,
                      TriangleMesh& solid);

} // namespace sedr
} // namespace pcl
