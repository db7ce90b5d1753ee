// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/point_view.h>

#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief What is wrong with a scan as a whole, a sentence with its numbers; empty if
 * it may be one of rooms in metres: too few finite points, too small, or so large that
 * its unit cannot be the metre. Looks at no more than 100,000 of the points. */
std::string scanProblem(const PointView& points, const std::vector<int>& indices);

/** @brief Whether the scan looks as if another axis than z were up: a sentence, else
 * empty. Then z gives rooms higher than 4.5 m, or none (`z_has_rooms` is false), while
 * across another axis there are two planes at the distance of a floor and a ceiling
 * that are half as large again. For thinned points. */
std::string upProblem(const PointView& points,
                      const std::vector<int>& indices,
                      bool z_has_rooms = true);

} // namespace sedr
} // namespace pcl
