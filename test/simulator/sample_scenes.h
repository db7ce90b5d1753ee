// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulator/scene/scene.h"

#include <nlohmann/json.hpp>

#include <string>

/** @file Small scenes whose measures are known in closed form. */

namespace pcl::sedr::sim::test {

using nlohmann::json;

/** @brief Returns the file of a room of 5 x 4 x 3 m, scanned without noise from one
 * station. */
inline json
boxFile()
{
  return json::parse(R"({
    "format": "sedr-scene", "version": 1, "name": "sample", "summary": "a box",
    "rooms": [{"name": "box", "outline": [[0, 0], [5, 0], [5, 4], [0, 4]],
               "floor": 0, "ceiling": 3}],
    "scanners": [{"stations": [[2, 1.5, 1.5]], "rays": 20000, "noise": 0}]
  })");
}

/** @brief Returns a file of three rooms: a lower one of 6 x 5 x 2.6 m, and above a slab
 * of 0.3 m an upper one of 6 x 5 x 2.5 m, with stairs. A hall of 4 x 5 x 5.4 m behind
 * 0.2 m of wall is open to both. */
inline json
twoStoreyFile()
{
  return json::parse(R"({
    "format": "sedr-scene", "version": 1, "name": "stacked", "summary": "two storeys",
    "rooms": [
      {"name": "below", "outline": {"rectangle": [[0, 0], [6, 5]]},
       "floor": 0, "ceiling": 2.6,
       "voids": [{"loop": {"rectangle": [[1, 3.6], [4.5, 4.8]]}, "leads_to": "above"}],
       "furniture": [{"stairs": {"at": [4.9, 4.2], "yaw": 90, "width": 1,
                      "rise": 0.18125, "going": 0.24, "steps": 15}}],
       "openings": [{"wall": 1, "from": 1, "to": 1.9, "head": 2.1, "depth": 0.2,
                     "leads_to": "hall"}]},
      {"name": "above", "outline": {"rectangle": [[0, 0], [6, 5]]},
       "floor": 2.9, "ceiling": 5.4,
       "openings": [{"wall": 1, "from": 1, "to": 4, "sill": 3.9, "head": 5.2,
                     "depth": 0.2, "leads_to": "hall"}]},
      {"name": "hall", "outline": {"rectangle": [[6.2, 0], [10.2, 5]]},
       "floor": 0, "ceiling": 5.4}],
    "scanners": [{"stations": [[3, 2, 1.5]], "rays": 20000, "noise": 0}]
  })");
}

/** @brief Sets the values at JSON pointers, as in {"/rooms/0/floor": 1}. */
inline json
with(json file, const std::string& changes)
{
  const json values = json::parse(changes);
  for (const auto& change : values.items())
    file[json::json_pointer(change.key())] = change.value();
  return file;
}

inline Scene
read(const json& file)
{
  return parseScene(file.dump(), "test.json");
}

/** @brief Returns why a file is refused; empty if it is not. */
inline std::string
refusalOf(const json& file)
{
  try {
    read(file);
    return {};
  }
  catch (const std::invalid_argument& error) {
    return error.what();
  }
}

} // namespace pcl::sedr::sim::test
