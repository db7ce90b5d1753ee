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

} // namespace pcl::sedr
