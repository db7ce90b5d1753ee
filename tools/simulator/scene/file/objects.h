// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "json_view.h"
#include "simulator/scene/scene.h"

#include <vector>

namespace pcl::sedr::sim {

/** @brief Reads a list of objects; the only key of each is its kind.
 *
 * @param list elements such as {"table": {"at": [x, y], "size": [w, d, h]}}; the kinds
 * and their keys are in doc/pcl_simulate_indoor_scan.md
 * @param room provides floor, ceiling and walls; null for the outside, where objects
 * cannot stand at walls and the key "floor" gives the height of their feet
 */
std::vector<Object> readObjects(const std::vector<JsonView>& list, const Room* room);

} // namespace pcl::sedr::sim
