// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_segmentation/contour.h>
#include <pcl/sedr_segmentation/plan_curve.h>
#include <pcl/sedr_segmentation/plan_points.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief How a loop is fitted to a contour; metres. */
struct LoopParameters {
  double tolerance = 0.05; ///< distance of an inlier from its curve (paper, Table 1)
  double expected_offset =
      -0.025;          ///< where the wall is looked for, from the contour, inside > 0
  double reach = 0.06; ///< how far from there it may be: a farther one is another wall
  double evidence_span =
      0.05; ///< how far along the contour a sample looks for it to each side
  double corner_reach = 0.15;  ///< how far from the contour two curves meet in a corner
  double minimum_length = 0.2; ///< of an element that has a curve of its own
  double minimum_radius = 0.15; ///< of an arc
  double maximum_radius = 25.0; ///< of an arc; flatter ones are segments
  std::uint64_t seed = 1;
  unsigned threads = 1; ///< that share a loop; 0: as many as there are processors
};

/** @brief A place on a contour, moved onto the wall where points show one. */
struct ContourSample {
  Eigen::Vector2d place;    ///< on the contour, its staircase evened out
  Eigen::Vector2d position; ///< on the wall, where points show one, or else the place
  Eigen::Vector2d tangent;  ///< unit, along the contour
  double support = 0;       ///< points by the loop's median, 1 at most; 0 for too few
  std::size_t points = 0;   ///< that show the wall here
  double deviation = 0;     ///< of these across the contour, root mean square, metres

  /** @brief Whether points show the wall here. */
  bool isSupported() const { return support > 0; }

  /** @brief What the sample counts for in a fit: little where only the contour shows
   * the wall. */
  double weight() const { return isSupported() ? support : 0.3; }
};

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

} // namespace sedr
} // namespace pcl
