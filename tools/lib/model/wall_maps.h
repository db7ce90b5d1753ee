// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/scan_frame.h>

#include <nlohmann/json.hpp>

namespace pcl::sedr {

struct OpeningSearch;

namespace tools {

/** @brief Returns what a scan shows of each wall, for report.json: `room`, `walls` (of
 * its boundary, from 1), `length`, `base` (z of the
 * lowest cells), `cell` (metres), `columns`, `rows`, `cells`
 * and the `openings` on it. The cells run row by row from the top, each run of equal
 * ones as its number and a letter: s seen, w within the wall, h hidden, e nothing, n no
 * room. Cells of all walls together are at most half a million, coarser for more.
 * @param to_maps from the frame of the plan to that in which it was searched */
nlohmann::ordered_json wallMaps(const Floorplan& plan,
                                const OpeningSearch& search,
                                const BuildingFrame& to_maps = {});

} // namespace tools
} // namespace pcl::sedr
