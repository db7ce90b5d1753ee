// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_unknowns.h"

#include "sedr_filters/src/grids/place_table.h"
#include "sedr_filters/src/plan/plan_surfaces.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief A column of patches of a wall, or a patch of a slab: an upright box. */
struct PatchSite {
  std::size_t unknown = 0;
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX(); ///< along the wall
  double half = 0; ///< half extent along it; of a slab's patch in x and y
  double low = 0;  ///< z; of walls
  double high = 0;
  bool is_slab = false;
  bool is_wall = false;    ///< its top counts more, as furniture hides it least
  std::uint32_t first = 0; ///< number of its lowest patch
  std::uint32_t patches = 1;
};

/** @brief The points of a scan beside the surfaces of a plan, sorted by patches. Those
 * of an unknown are consecutive. */
class PatchPoints {
public:
  /** @brief Assigns the points, O(n). The plan must not be empty of loops. */
  PatchPoints(const Floorplan& plan,
              const PlanUnknowns& unknowns,
              const PointView& raw,
              const std::vector<int>& indices,
              const AdjustmentParameters& parameters);

  /** @brief Returns the reason for a failure, a sentence; else empty. */
  const std::string& problem() const { return problem_; }

  /** @brief Returns the patches of an unknown: the first and the one beyond the last.
   */
  std::pair<std::size_t, std::size_t> patchesOf(std::size_t unknown) const
  {
    return {first_patch_[unknown], first_patch_[unknown + 1]};
  }

  std::size_t patches() const { return is_top_.size(); }
  bool isTop(std::size_t patch) const { return is_top_[patch] != 0; }

  const Eigen::Vector3f* begin(std::size_t patch) const
  {
    return points_.data() + starts_[patch];
  }
  const Eigen::Vector3f* end(std::size_t patch) const
  {
    return points_.data() + starts_[patch + 1];
  }

private:
  /** @brief A point of a patch. */
  struct Hit {
    std::uint32_t patch;
    Eigen::Vector3f point;
  };

  void addWalls(const Floorplan& plan);
  void addWall(const VerticalSurface& surface, std::size_t unknown);
  void addSlabs(const Floorplan& plan, unsigned threads);
  void number();
  std::string tabulate();
  void see(const Eigen::Vector3f& point, std::vector<Hit>& hits) const;
  void gather(const PointView& raw, const std::vector<int>& indices);
  bool
  isBeside(const PatchSite& site, const Eigen::Vector3d& p, double& distance) const;

  const PlanUnknowns& unknowns_;
  const AdjustmentParameters& parameters_;
  double farthest_; ///< maximum distance of a point from a given surface
  std::string problem_;
  std::vector<PatchSite> sites_;
  PlaceTable near_;
  std::vector<std::size_t> first_patch_; ///< of each unknown
  std::vector<std::uint8_t> is_top_;
  std::vector<std::size_t> starts_; ///< of each patch's points
  std::vector<Eigen::Vector3f> points_;
};

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
