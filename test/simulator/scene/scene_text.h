// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulator/scene/scene_file.h"

#include <nlohmann/json.hpp>

#include <string>

/** @file Small scene files for tests to modify and read. */

namespace pcl::sedr::sim::test {

using nlohmann::json;

/** @brief Returns the file of a room of 5 x 4 x 3 m with one scanner and nothing else.
 */
inline json
minimalFile()
{
  return json::parse(R"({
    "format": "sedr-scene", "version": 1, "name": "minimal", "summary": "a box",
    "rooms": [{"name": "box", "outline": [[0, 0], [5, 0], [5, 4], [0, 4]],
               "floor": 0, "ceiling": 3}],
    "scanners": [{"stations": [[2, 2, 1.5]], "rays": 100, "noise": 0.005}]
  })");
}

inline Scene
read(const json& file)
{
  return parseScene(file.dump(), "test.json");
}

/** @brief Returns the scene of the minimal file with a value set at a JSON pointer. */
inline Scene
readWith(const std::string& pointer, const json& value)
{
  json file = minimalFile();
  file[json::json_pointer(pointer)] = value;
  return read(file);
}

} // namespace pcl::sedr::sim::test
