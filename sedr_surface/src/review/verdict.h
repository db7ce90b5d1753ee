// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/plan_review.h>

namespace pcl::sedr {

/** @brief Sets the expected shares of a review, its verdict and the number of its
 * checks by its doubts, the largest stake first. */
void setVerdict(const Floorplan& plan, PlanReview& review);

/** @brief Returns the area of all rooms, square metres. */
double areaOf(const Floorplan& plan);

} // namespace pcl::sedr
