// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "panes.h"

#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief The panes that mirror: of what rays meet behind them, a good part has its
 * like in front. Their offsets are moved to where most of it has.
 * @param filled cubes that hold points */
std::vector<Pane> mirrorsAmong(std::vector<Pane> panes,
                               const PiercedSurfaces& surfaces,
                               const std::vector<ScanRay>& rays,
                               const std::vector<std::uint32_t>& pierced,
                               const CubeTable& filled,
                               unsigned threads);

} // namespace pcl::sedr
