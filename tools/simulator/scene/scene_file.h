// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"

#include <filesystem>
#include <string>

/** @file Scenes as JSON: see doc/pcl_simulate_indoor_scan.md. Invalid files throw
 * std::invalid_argument: unreadable, not JSON, unknown or missing keys, wrong types, an
 * impossible scene. The sentence names the file and the place in it, as in "flat.json:
 * rooms[2].openings[0].wall must be ...". */

namespace pcl::sedr::sim {

/** @brief Returns the text of a scene file. */
std::string readSceneText(const std::filesystem::path& path);

/** @brief Parses a scene and checks it with problemsOf().
 * @param source the name of the text in messages
 */
Scene parseScene(const std::string& text, const std::string& source);

} // namespace pcl::sedr::sim
