// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "json_view.h"
#include "simulator/scene/scene.h"

namespace pcl::sedr::sim {

/** @brief A scanner, its stations as a list or along a walk through the rooms.
 * @param scene with all its rooms, whose floors carry the walk
 */
Scanner readScanner(const JsonView& view, const Scene& scene);

} // namespace pcl::sedr::sim
