// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "json_view.h"
#include "simulator/scene/scene.h"

#include <vector>

namespace pcl::sedr::sim {

/** @brief The objects of a list, each an object with one key: what kind of thing it is.
 *
 * @param list elements such as {"table": {"at": [x, y], "size": [w, d, h]}}; the kinds
 * and their keys are in doc/pcl_simulate_indoor_scan.md
 * @param room where they stand, for floor, ceiling and walls; null for the outside,
 * where a thing has no wall to stand at and its key "floor" gives the height of its
 * feet
 */
std::vector<Object> readObjects(const std::vector<JsonView>& list, const Room* room);

} // namespace pcl::sedr::sim
