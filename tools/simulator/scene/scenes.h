// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"

#include <filesystem>
#include <string>
#include <vector>

/** @file Scenes as JSON: see doc/pcl_simulate_indoor_scan.md. Invalid files throw
 * std::invalid_argument: unreadable, not JSON, unknown or missing keys, wrong types, an
 * impossible scene. The sentence names the file and the place in it, as in "flat.json:
 * rooms[2].openings[0].wall must be ...". */

namespace pcl::sedr::sim {

/** @brief A scene file that is part of the simulator's library. */
struct BuiltInScene {
  std::string name;
  std::string text; ///< of its file: see parseScene()
};

/** @brief Returns the text of a scene file. */
std::string readSceneText(const std::filesystem::path& path);

/** @brief Parses a scene and checks it: see checkScene().
 * @param source the name of the text in messages */
Scene parseScene(const std::string& text, const std::string& source);

/** @brief Checks that a scene is physically possible.
 *
 * Every room can be meshed: see meshOf(). Rooms do not overlap, and openings and niches
 * do not reach into other rooms. Voids lie within one part of a ceiling and of the
 * floor above it. Scanners are in a room and in no object. Outlines are sampled every
 * few centimetres.
 * @throw std::invalid_argument with a sentence about the first fault, which begins with
 * its place, as in "rooms[2].openings[0]" */
void checkScene(const Scene& scene);

/** @brief Returns the files of tools/simulator/scenes. */
const std::vector<BuiltInScene>& builtInScenes();

/** @brief Returns all built-in scenes. */
std::vector<Scene> allScenes();

/** @brief Returns the text of a built-in scene, or of a file if the name ends in .json.
 * @throw std::invalid_argument naming the known scenes, or the file */
std::string sceneText(const std::string& name_or_path);

/** @brief Returns a built-in scene, or that of a file if the name ends in .json.
 * @throw std::invalid_argument naming the known scenes, or the fault of the file */
Scene sceneNamed(const std::string& name_or_path);

} // namespace pcl::sedr::sim
