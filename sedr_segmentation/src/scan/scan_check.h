// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/priors.h>

#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief Returns the problem of a scan as a whole, a sentence with numbers; empty if
 * it may show rooms in metres. Problems are too few finite points, too small a scan, or
 * too large for the unit to be the metre. Uses at most 100,000 of the
 * points.
 * @param indices of the points to use; null: all */
std::string scanProblem(const PointView& points,
                        const std::vector<int>* indices = nullptr,
                        const Priors& priors = {});

} // namespace pcl::sedr
