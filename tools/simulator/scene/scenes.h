// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"

#include <string>
#include <vector>

namespace pcl::sedr::sim {

/** @brief A scene file that is part of the simulator's library. */
struct BuiltInScene {
  std::string name;
  std::string text; ///< of its file: see scene_file.h
};

/** @brief Returns the files of tools/simulator/scenes. */
const std::vector<BuiltInScene>& builtInScenes();

/** @brief Returns all built-in scenes. */
std::vector<Scene> allScenes();

/** @brief Returns the text of a built-in scene, or of a file if the name ends in .json.
 * @throw std::invalid_argument naming the known scenes, or the file
 */
std::string sceneText(const std::string& name_or_path);

/** @brief Returns a built-in scene, or that of a file if the name ends in .json.
 * @throw std::invalid_argument naming the known scenes, or the fault of the file
 */
Scene sceneNamed(const std::string& name_or_path);

} // namespace pcl::sedr::sim
