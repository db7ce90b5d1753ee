// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>

namespace pcl::sedr {

// Tolerances of rounding and drawing, and block sizes of parallel work: numbers that do
// not depend on buildings or scanners. Assumptions about those are in Priors.

constexpr double same_point = 1e-7;    ///< nearer ends of loops coincide, metres
constexpr double same_place = 1e-6;    ///< nearer places coincide, metres
constexpr double same_line = 0.001;    ///< nearer elements lie on the line, metres
constexpr double farthest_place = 1e5; ///< maximum coordinate, metres
constexpr double chord = 0.005; ///< tolerance of polygons that replace arcs, metres

constexpr auto full_turn = static_cast<float>(2 * 3.14159265358979323846); ///< radians

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

constexpr std::size_t points_a_block = 16384; ///< points that a thread takes at once

} // namespace pcl::sedr
