// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "json_view.h"
#include "simulator/scene/loop.h"

namespace pcl::sedr::sim {

/** @brief Reads a loop: a list of corners, a rectangle, or a circle.
 *
 * A corner is [x, y]. Where an arc starts, it is {"at": [x, y], "radius": r} or {"at":
 * [x, y], "bulge": b}. A positive radius turns left, and the arc is less than half a
 * circle; a bulge is that of LoopVertex. {"rectangle": [[x, y], [x, y]]} gives two
 * opposite corners, {"circle": [x, y], "radius": r} centre and radius.
 */
Loop readLoop(const JsonView& view);

} // namespace pcl::sedr::sim
