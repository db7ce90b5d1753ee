// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../curves/contour.h"
#include "../curves/plan_curve.h"
#include "../curves/plan_points.h"
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/priors.h>
#include <pcl/sedr_segmentation/floorplan_fitting.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief Samples of a contour, one a cell edge, each at the densest of the `evidence`
 * that lies across the contour within reach. */
std::vector<ContourSample> sampleContour(const Contour& contour,
                                         const PlanPoints& evidence,
                                         const LoopParameters& parameters);

/** @brief The distance within which samples belong to a curve: three standard
 * deviations of the points that show the wall, at most half of the tolerance; where the
 * samples' own noise, measured across neighbours, is larger, four standard deviations
 * of that, at most all of it. Metres, at least a millimetre. */
double sampleTolerance(const std::vector<ContourSample>& samples,
                       const LoopParameters& parameters);

/** @brief Lines and circles through the samples by seeded RANSAC, the best supported
 * first (paper, section 2.4). `known` curves come first and as they are. */
std::vector<PlanCurve> findCurves(const std::vector<ContourSample>& samples,
                                  const std::vector<PlanCurve>& known,
                                  const LoopParameters& parameters);

/** @brief A closed loop of segments and arcs along a contour, corners where
 * neighbouring curves meet.
 *
 * @param contour closed, the room on its left
 * @param evidence points of the walls, in plan; curves are fitted to them where there
 * are any
 * @param known elements that are already known exactly, such as the walls of the room
 * for a detail
 * @param[out] places the samples of the contour, if wanted
 * @return a loop that does not cross itself; where no sequence of curves gives one, the
 * simplified contour. Empty for a contour of fewer than four corners. */
PlanLoop fitLoop(const Contour& contour,
                 const PlanPoints& evidence,
                 const std::vector<PlanElement>& known,
                 const LoopParameters& parameters,
                 std::vector<ContourSample>* places = nullptr);

} // namespace pcl::sedr
