// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <vector>

namespace pcl::sedr {

/** @brief Returns whether a ceiling's surfaces hold few points for their area: of the
 * main ceiling, then of each detail.
 *
 * Cells that no surface explains are shared out among those that are there, and few of
 * their points are on them. Such a facet's height and borders say nothing of the
 * building. Facets of one surface are judged together; one without a number of points
 * is never sparse. */
std::vector<bool> sparseFacets(const PlanRoom& room);

} // namespace pcl::sedr
