// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../parting/room_parting.h"

#include <pcl/sedr_filters/point_view.h>

#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief Which parts of the air are what a floor mirrors of the room above it: below
 * most of their columns, as high as the air above, and no slab between: at half their
 * height, by the points at their ends, is the floor. O(n) for n points.
 * @param floors main floor of each part, metres
 * @return 1 for each such part */
std::vector<std::uint8_t> mirrorImages(const AirGaps& air,
                                       const PartedAir& parted,
                                       const PointView& points,
                                       const std::vector<double>& floors);

/** @brief Which parts of the air were seen only through panes of glass or in mirrors:
 * those whose points in their columns are nine tenths of that kind. O(n) for n points.
 * @param behind 1 for each point that was seen only through panes; empty: not known
 * @return 1 for each such part */
std::vector<std::uint8_t> viewsThroughPanes(const AirGaps& air,
                                            const PartedAir& parted,
                                            const PointView& points,
                                            const std::vector<std::uint8_t>& behind);

} // namespace pcl::sedr
