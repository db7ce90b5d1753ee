// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"

#include <string>
#include <vector>

namespace pcl::sedr::sim {

/** @brief A study with a soffit along two walls and a recess, scanned by backpack. */
Scene makeBlsRoom();

/** @brief A hall with a curved wall and columns, cluttered, scanned by hand. */
Scene makeHlsHall();

/** @brief Three rooms and a corridor with open doors, scanned from a tripod. */
Scene makeSynFlat();

/** @brief All scenes that come with the simulator. */
std::vector<Scene> allScenes();

/** @brief The scene of that name.
 * @throw std::invalid_argument naming the known scenes, if there is none
 */
Scene sceneNamed(const std::string& name);

} // namespace pcl::sedr::sim
