# SPDX-License-Identifier: BSD-3-Clause
# Writes OUTPUT, a C++ source with the files SCENES (names, joined by commas) of FOLDER as string literals.
string(REPLACE "," ";" SCENES "${SCENES}")
set(entries "")
foreach(scene IN LISTS SCENES)
  file(READ ${FOLDER}/${scene}.json text)
  string(APPEND entries "    {\"${scene}\", R\"sedr_scene(${text})sedr_scene\"},\n")
endforeach()
file(WRITE ${OUTPUT} "// Made from tools/simulator/scenes by embed_scenes.cmake.
#include \"simulator/scene/scene.h\"

namespace pcl::sedr::sim {

const std::vector<BuiltInScene>&
builtInScenes()
{
  static const std::vector<BuiltInScene> scenes{
${entries}  };
  return scenes;
}

} // namespace pcl::sedr::sim
")
