// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "curve_adjustment.h"
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/priors.h>

#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace pcl::sedr {

/** @brief The carrier curves of the elements of a plan, without duplicates. Elements of
 * one room on the same line or circle share it, like the edge of a soffit and a wall.
 *
 * After curves were moved, the plan can be rebuilt on them; its corners are the
 * intersections of neighbouring curves. */
class PlanCurves {
public:
  /** @brief A loop of the plan. */
  struct Loop {
    PlanLoop* loop = nullptr;
    std::size_t room = 0;            ///< index in the plan
    bool is_boundary = false;        ///< of the room
    std::vector<std::size_t> curves; ///< curve of each element
  };

  /** @brief `plan` must outlive this object, and its rooms must not be moved in memory.
   */
  explicit PlanCurves(Floorplan& plan, const Priors& priors = {});

  std::vector<MeasuredCurve> curves;
  std::vector<Loop> loops;

  /** @brief Pairs of tangent curves, the smaller index first. */
  std::set<std::pair<std::size_t, std::size_t>> tangents;

  /** @brief Returns half of the measured length of a curve, metres. */
  double reach(std::size_t curve) const { return reach_[curve]; }

  /** @brief Updates the information of curve `c` from its inliers and residual. */
  void remeasure(std::size_t c);

  /** @brief Returns whether adjacent elements meet at less than `angle` radians. */
  static bool meetSmoothly(const PlanElement& e, const PlanElement& next, double angle);

  /** @brief Rebuilds the loops on the curves.
   * @param farthest maximum move of a corner, metres
   * @return the indices of the loops that would break, i.e. cross themselves, reverse
   * an element or lose a corner. The plan is changed only if there are none. */
  std::vector<std::size_t> rebuild(double farthest);

private:
  std::size_t curveOf(const PlanElement& e, std::size_t first);
  bool isAlong(const PlanElement& e, const PlanCurve& curve) const;
  void measure(std::size_t curve, const PlanElement& e);
  bool moved(const Loop& loop, double farthest, PlanLoop& result) const;
  bool cornerOf(const Loop& loop,
                std::size_t i,
                double farthest,
                Eigen::Vector2d& corner) const;

  Priors priors_;
  std::vector<double> reach_;
};

/** @brief Returns all loops of a room: boundary, columns, then details and niches. */
std::vector<PlanLoop*> loopsOf(PlanRoom& room);

} // namespace pcl::sedr
