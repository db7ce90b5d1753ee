// SPDX-License-Identifier: BSD-3-Clause
#include "scenes.h"

#include <stdexcept>

namespace pcl::sedr::sim {

std::vector<Scene>
allScenes()
{
  return {makeBlsRoom(), makeHlsHall(), makeSynFlat()};
}

Scene
sceneNamed(const std::string& name)
{
  std::string known;
  for (const Scene& scene : allScenes()) {
    if (scene.name == name)
      return scene;
    known += (known.empty() ? "" : ", ") + scene.name;
  }
  throw std::invalid_argument("There is no scene '" + name + "'; known are " + known);
}

} // namespace pcl::sedr::sim
