// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "patch_points.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace pcl::sedr {

/** @brief The errors of a scan. */
struct ScanErrors {
  double noise = 0;       ///< standard deviation of a point
  double waviness = 0;    ///< standard deviation of the errors that patches share
  double correlation = 0; ///< length over which these fall to 1 / e, metres
};

/** @brief The evidence of a patch: the mean of its points on the surface. */
struct PatchMean {
  double count = 0;
  double distance = 0; ///< from the surface, metres
  double variance = 0; ///< of a point
  double mixed = 0;    ///< share of the points within reach that are beside the surface
  double vote = 1;     ///< weight in the choice between surfaces
  double weight = 0;   ///< 1: of the surface, 0: an outlier
  double precision = 0; ///< that weight over the variance of the mean
  Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< mean of the points
  Eigen::Vector3d row = Eigen::Vector3d::Zero(); ///< negative derivatives
};

/** @brief Fits each surface alone to its patches, by robust least squares.
 *
 * Straight walls of rooms are fitted twice, vertical and tilted. A wall is tilted if
 * its run r exceeds the tolerance of construction and
 *
 *     r^2 / (2 sigma^2)  >  rare_tilt + ln (free_tilt / (sigma sqrt (2 pi)))
 *
 * where sigma^2 is the variance from the patches, whose errors are correlated, plus the
 * accuracy of built surfaces, plus the scatter of the runs of all walls: moving
 * scanners drift. And a tilted plane must be that much more probable than two vertical
 * ones, such as a wall above a panel. */
class SurfaceFit {
public:
  SurfaceFit(PlanUnknowns& unknowns,
             const PatchPoints& points,
             const AdjustmentParameters& parameters);

  /** @brief Moves the unknowns to the points, with counts, noise and information. */
  ScanErrors run();

private:
  /** @brief Rounds of patches that follow the moved surface; the third moves it by
   * hundredths of the noise. */
  static constexpr int rounds = 3;

  void start(std::size_t u);
  void refine(std::size_t u);
  bool
  isOfOneSurface(const PatchMean& patch, double usual_mixed, double variance) const;
  double deviationOf(const PatchMean& patch, double variance) const;
  bool solve(const std::vector<PatchMean>& patches,
             const std::vector<double>& weights,
             const Eigen::Matrix3d& prior,
             Eigen::Vector3d& step) const;
  void estimateErrors();
  void chooseTilts();
  bool isTilted(std::size_t number, double drift) const;

  PlanUnknowns& unknowns_;
  const std::vector<Unknown> given_;
  const PatchPoints& points_;
  const AdjustmentParameters& parameters_;
  ScanErrors errors_;
  std::vector<std::vector<PatchMean>> patches_; ///< of each unknown
};

} // namespace pcl::sedr
