// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_view.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief Parameters of adjustPlan(). Lengths in metres, angles in radians. */
struct AdjustmentParameters {
  /** @brief Standard deviation of the given positions. */
  double coarse = 0.01;

  /** @brief Distance up to which points beside a surface count: what is farther is
   * another surface. Some three standard deviations of the noisiest scanners. */
  double reach = 0.06;

  /** @brief Edge of a patch, the unit of evidence: below the width of what is between
   * two openings, above the correlation of a laser scanner's errors. */
  double patch = 0.2;

  /** @brief Distance from corners, floors and ceilings within which it is not known to
   * which surface a point belongs. */
  double margin = 0.06;

  /** @brief Deviation of built surfaces from planes and cylinders: none is known
   * better, however many points were seen. */
  double accuracy = 0.0003;

  /** @brief Patches that deviate by more standard deviations show something else. The
   * usual tuning of the biweight (Beaton and Tukey 1974) is 4 to 6. */
  double outlier_sigmas = 4;

  /** @brief Maximum share of points beside the surface, but within reach, in a patch of
   * one surface: more belong to what stands square to it, such as jambs. */
  double max_mixed = 0.2;

  /** @brief Minimum number of points that show a surface. */
  double min_points = 20;

  // Intervals in which a value would lie, evenly, if no tie held. They make the cost of
  // a free value: ln (interval / (standard deviation sqrt(2 pi))) nats.
  double free_direction = 1.5708; ///< of a wall, against another: a quarter turn
  double free_offset = 0.3;       ///< of a wall against the line of another
  double free_height = 0.3;       ///< of a floor or ceiling against another's
  double free_slope = 0.1;        ///< of a floor or ceiling that is not level
  double free_tilt = 1;           ///< of a wall that is not vertical

  // A wall is tilted only within these limits, as little is construction tolerance,
  // 4 cm in a storey, and much a roof.
  double min_tilt = M_PI / 180;
  double max_tilt = 28 * M_PI / 180;
  double min_tilted_height = 1.5; ///< of its points
  double rare_tilt = 10;          ///< nats: few walls are tilted

  double smooth_joint = 0.2; ///< maximum angle of an arc's joint that may be smooth

  std::size_t max_points = 5000000; ///< of a larger scan, every k-th point is used
  unsigned threads = 0;             ///< 0: all processors
};

/** @brief Result of adjustPlan(). */
struct AdjustmentReport {
  std::size_t walls = 0;  ///< lines and circles that were seen
  std::size_t slabs = 0;  ///< planes of floors, ceilings and details that were seen
  double noise = 0;       ///< standard deviation of a point, median of all surfaces
  double waviness = 0;    ///< standard deviation of the errors that patches share
  double correlation = 0; ///< length over which these errors fall to 1 / e
  std::string problem{};  ///< why the plan was not changed, a sentence; else empty
};

/** @brief Moves all walls, columns, niches, floors and ceilings of a plan to where the
 * points of a scan show them.
 *
 * The topology is kept. Unknowns are the lines, circles and planes of the building;
 * elements of a room on one line or circle share it. Observations are patches of the
 * points beside each surface: their mean distance, with a variance from the noise of
 * the points and from the correlated errors of the scan, both of which are estimated.
 * Patches of furniture and of what stands square to a surface are outliers. Straight
 * walls of a room are tilted where that is more probable, see SurfaceFit. Walls that
 * are parallel, square or on one line, smooth joints, level slabs and slabs of one
 * height are tied where this is more probable than chance: the cost of the
 * free values, in nats, against half of the squared contradiction in standard
 * deviations. Corners are then intersections. Surfaces that no point shows follow their
 * ties or stay. A loop that would break or cross itself keeps its place.
 *
 * O(n) for n points. The result does not depend on the number of threads. Memory is 16
 * bytes for each point near a surface.
 * @param[in,out] plan right to a few centimetres; curved slabs are not changed
 * @param raw the scan, raw or thinned; points that are not finite are left out
 * @param indices the points to use; empty: all */
AdjustmentReport adjustPlan(Floorplan& plan,
                            const PointView& raw,
                            const std::vector<int>& indices = {},
                            const AdjustmentParameters& parameters = {});

/** @brief States the accuracy of planes of floors and ceilings that adjustPlan() did
 * not place, such as slopes and parts of them that were fitted alone. They stay: their
 * distance from where all patches put them is an error of theirs.
 * @param raw, indices, parameters as of adjustPlan() */
void stateSlabs(Floorplan& plan,
                const PointView& raw,
                const std::vector<int>& indices = {},
                const AdjustmentParameters& parameters = {});

} // namespace pcl::sedr
