// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../scan/patch_normals.h"
#include "sedr_filters/src/grids/place_table.h"

#include <Eigen/Core>

#include <vector>

namespace pcl::sedr {

/** @brief Returns the horizontal way of a plane for each metre up. */
Eigen::Vector2d runOf(const Eigen::Vector3d& normal);

/** @brief How the surfaces of walls lean, place by place: patches of 0.4 m that are
 * within 28 degrees of vertical. What is nearly vertical, as far as the normals of such
 * patches tell, leans not at all, with a smooth transition: a run r counts as
 * r - vertical_run^2 / r. */
class WallSlopes {
public:
  static constexpr double patch_size = 0.4; ///< metres

  /** @brief Run of what seems to lean by 2 degrees. */
  static constexpr double vertical_run = 0.035;

  WallSlopes() = default;

  /** @brief Finds the patches, O(n log n).
   * @param threads 0: all processors; the result does not depend on it */
  WallSlopes(const PointView& points,
             const std::vector<int>& indices,
             unsigned threads);

  /** @brief Checks whether no wall leans anywhere. */
  bool areNone() const { return leaning_.empty(); }

  /** @brief Returns the horizontal way for each metre up of the surface that a point is
   * on. Zero for a vertical one, and where there is none. */
  Eigen::Vector2d at(const Eigen::Vector3d& p) const;

  /** @brief Returns all patches, with the mean normal of those around in their plane.
   */
  const std::vector<PlanePatch>& patches() const { return patches_; }

  /** @brief Returns those that lean, as indices. */
  const std::vector<std::size_t>& leaning() const { return leaning_; }

private:
  std::vector<PlanePatch> patches_;
  std::vector<std::size_t> leaning_;
  PlaceTable near_{0.4}; ///< of those that lean
};

} // namespace pcl::sedr
