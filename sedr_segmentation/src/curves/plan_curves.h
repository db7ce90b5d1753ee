// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "curve_adjustment.h"
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/priors.h>

#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief The curves that the elements of a plan run along, each once: elements of one
 * room on the same line or circle share it, as the edge of a soffit shares a wall's.
 *
 * Curves can be moved and the plan be built anew on them: its corners are where
 * neighbouring curves meet. */
class PlanCurves {
public:
  /** @brief One loop of the plan. */
  struct Loop {
    PlanLoop* loop = nullptr;
    std::size_t room = 0;            ///< index in the plan
    bool is_boundary = false;        ///< of the room
    std::vector<std::size_t> curves; ///< of each element
  };

  /** @brief `plan` must outlive this, its rooms stay where they are. */
  explicit PlanCurves(Floorplan& plan, const Priors& priors = {});

  std::vector<MeasuredCurve> curves;
  std::vector<Loop> loops;

  /** @brief Pairs of curves, the smaller first, that shall touch where they meet. */
  std::set<std::pair<std::size_t, std::size_t>> tangents;

  /** @brief Half of the length along which a curve was measured, metres. */
  double reach(std::size_t curve) const { return reach_[curve]; }

  /** @brief What curve `c` is worth now, as its inliers and their residual say. */
  void remeasure(std::size_t c);

  /** @brief Whether neighbours meet smoothly where they do: at less than `angle`
   * radians. */
  static bool meetSmoothly(const PlanElement& e, const PlanElement& next, double angle);

  /** @brief Builds the loops anew on the curves.
   * @param farthest no corner may move farther, metres
   * @return the indices of the loops that this would break: they would cross
   * themselves, turn an element around or lose a corner. The plan is changed only where
   * there are none. */
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

/** @brief All loops of a room: boundary, columns, then those of details and niches. */
std::vector<PlanLoop*> loopsOf(PlanRoom& room);

} // namespace sedr
} // namespace pcl
