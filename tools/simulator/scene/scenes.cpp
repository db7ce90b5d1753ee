// SPDX-License-Identifier: BSD-3-Clause
#include "scenes.h"

#include <filesystem>
#include <stdexcept>

namespace pcl::sedr::sim {

std::vector<Scene>
allScenes()
{
  std::vector<Scene> scenes;
  for (const BuiltInScene& scene : builtInScenes())
    scenes.push_back(parseScene(scene.text, scene.name));
  return scenes;
}

std::string
sceneText(const std::string& name_or_path)
{
  const std::filesystem::path path(name_or_path);
  if (path.extension() == ".json")
    return readSceneText(path);
  std::string known;
  for (const BuiltInScene& scene : builtInScenes()) {
    if (scene.name == name_or_path)
      return scene.text;
    known += (known.empty() ? "" : ", ") + scene.name;
  }
  throw std::invalid_argument("There is no scene '" + name_or_path + "'; known are " +
                              known + ", and files that end in .json");
}

Scene
sceneNamed(const std::string& name_or_path)
{
  return parseScene(sceneText(name_or_path), name_or_path);
}

} // namespace pcl::sedr::sim
