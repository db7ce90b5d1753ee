// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulator/scene/scene_text.h"

/** @file A building of two rooms above each other and a tall hall beside them. */

namespace pcl::sedr::sim::test {

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

} // namespace pcl::sedr::sim::test
