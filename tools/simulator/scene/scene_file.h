// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"

#include <filesystem>
#include <string>

/** @file
 * Scenes as JSON: see doc/pcl_simulate_indoor_scan.md. What is wrong with a file -
 * unreadable, no JSON, unknown or missing keys, wrong types, a scene that cannot be -
 * throws std::invalid_argument with one sentence that names the file and the place in
 * it, as in "flat.json: rooms[2].openings[0].wall must be ...".
 */

namespace pcl::sedr::sim {

/** @brief The text of a scene file. */
std::string readSceneText(const std::filesystem::path& path);

/** @brief The scene that a text describes, checked by problemsOf().
 * @param source what to call the text in messages
 */
Scene parseScene(const std::string& text, const std::string& source);

} // namespace pcl::sedr::sim
