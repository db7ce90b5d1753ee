// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../curves/plan_curve.h"

#include <Eigen/Core>

#include <vector>

namespace pcl::sedr {

/** @brief A curve on which faces of walls lie, from one place along it to another:
 * metres, of a circle the angle times its radius. */
struct FaceCurve {
  PlanCurve curve;
  double from = 0;
  double to = 0;
  bool is_main = false; ///< along a main direction

  /** @brief Returns how far along the curve the place nearest to `p` is; of a circle at
   * `from` or more. */
  double along(const Eigen::Vector2d& p) const;
  Eigen::Vector2d at(double s) const;
};

/** @brief Radii of circles that walls may have, metres. */
struct RadiusRange {
  double min = 0.15;
  double max = 25;
};

/** @brief The curves of faces, and the directions of most of them. */
struct FaceCurves {
  std::vector<FaceCurve> curves;
  std::vector<Eigen::Vector2d> normals; ///< main directions, two for each angle
};

/** @brief Finds lines and circles that explain places on the faces of walls: peaks of
 * the offsets along main directions, and what is fitted to chains of neighbouring
 * places with steady normals; each grown as far as places go on. Of all these those are
 * kept that explain what no better one does, by more than their parameters cost
 * (greedily: what is explained is submodular). O(places x curves near them). */
FaceCurves faceCurves(const std::vector<Eigen::Vector2d>& places,
                      const RadiusRange& radii = {});

} // namespace pcl::sedr
