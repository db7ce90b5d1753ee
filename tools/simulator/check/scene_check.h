// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulator/scene/scene.h"

namespace pcl::sedr::sim {

/** @brief Checks that a scene is physically possible.
 *
 * Every room can be meshed: see meshOf(). Rooms do not overlap, and openings and niches
 * do not reach into other rooms. Voids lie within one part of a ceiling and of the
 * floor above it. Scanners are in a room and in no object. Outlines are sampled every
 * few centimetres.
 * @throw std::invalid_argument with a sentence about the first fault, which begins with
 * its place, as in "rooms[2].openings[0]" */
void checkScene(const Scene& scene);

} // namespace pcl::sedr::sim
