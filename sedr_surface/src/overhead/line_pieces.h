// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::sedr {

/** @brief Distance from a border at which the ceiling beside it is asked for: loops of
 * facets meet within tolerance only; metres. */
constexpr double beside_border = 0.05;

/** @brief Returns a line through places as few segments that no place is farther from
 * than the tolerance, metres. Where eight places or more and the middles between them
 * are on an arc, a third of the tolerance off at most, it is an arc. The ends of the
 * line stay; one that ends where it starts is closed. */
std::vector<PlanElement> piecesOf(const std::vector<Eigen::Vector2d>& line,
                                  double tolerance);

/** @brief Returns a line of pieces without bulges that are too small. Of the segments
 * between two arcs, those that cost least: a third of `min_area`, square metres, for
 * each corner, and the area between the line and what is kept of it. */
std::vector<PlanElement> withoutBulges(const std::vector<PlanElement>& line,
                                       double min_area);

/** @brief Returns the part of an arc between two places that passes a third one; of a
 * circle it may run through the circle's start. */
PlanElement partPassing(const PlanElement& arc,
                        const Eigen::Vector2d& a,
                        const Eigen::Vector2d& b,
                        const Eigen::Vector2d& passed);

} // namespace pcl::sedr
