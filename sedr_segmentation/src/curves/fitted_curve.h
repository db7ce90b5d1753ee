// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_curve.h"

#include <Eigen/Core>

#include <vector>

namespace pcl::sedr {

/** @brief Fits a line or a circle to places by iterated least squares with Tukey's
 * weights. At least three places.
 * @param sigma noise of the places, metres; outliers are beyond four of it */
PlanCurve
fitCurve(bool is_circle, const std::vector<Eigen::Vector2d>& places, double sigma);

/** @brief Finds the intersection of two curves that is nearest to a place.
 * @return whether there is one; lines nearly parallel have none */
bool meet(const PlanCurve& a,
          const PlanCurve& b,
          const Eigen::Vector2d& near,
          Eigen::Vector2d& place);

} // namespace pcl::sedr
