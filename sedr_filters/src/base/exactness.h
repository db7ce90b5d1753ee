// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>

namespace pcl {
namespace sedr {

// What rounding and drawing may do, and how work is dealt out: numbers that say nothing
// of buildings or scanners. What is believed of those stands in Priors.

constexpr double same_point = 1e-7;  ///< loops meet where they are nearer, metres
constexpr double same_place = 1e-6;  ///< places nearer than this are one, metres
constexpr double same_corner = 1e-4; ///< a shorter element is none, metres
constexpr double same_line =
    0.001; ///< what runs nearer to a line runs along it, metres
constexpr double farthest_place = 1e5; ///< metres; what is beyond is no place
constexpr double chord = 0.005;        ///< of arcs looked at as polygons, metres

constexpr auto full_turn = static_cast<float>(2 * 3.14159265358979323846); ///< radians

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

constexpr std::size_t points_a_block = 16384; ///< that a thread takes at a time
constexpr std::size_t cells_a_block = 4096;   ///< likewise
constexpr std::size_t samples_a_block = 64;   ///< likewise, of a contour

} // namespace sedr
} // namespace pcl
