// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "json_view.h"
#include "simulator/scene/scene.h"

namespace pcl::sedr::sim {

/** @brief Reads a scanner; its stations are a list or a walk through the rooms.
 * @param scene with all its rooms, whose floors give the height of the walk
 */
Scanner readScanner(const JsonView& view, const Scene& scene);

} // namespace pcl::sedr::sim
