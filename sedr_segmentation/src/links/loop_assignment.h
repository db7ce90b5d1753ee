// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../loop/loop_fit.h"

#include <cstddef>
#include <vector>

namespace pcl::sedr {

/** @brief Assigns the samples of a loop to curves. The points around each sample do not
 * depend on the curves, so they are collected only once. */
class CurveAssignment {
public:
  /** @brief All arguments must outlive this object. */
  CurveAssignment(const std::vector<ContourSample>& samples,
                  const PlanPoints& evidence,
                  const LoopParameters& parameters);

  /** @brief Returns the curve of every sample: the closed sequence of minimum cost
   * (Viterbi 1967, around the loop). The cost of a sample grows with the evidence
   * around it against the curve. Every change of curve costs a constant, more between
   * adjacent parallel curves. O(n k log k) for n samples and k curves if few curves
   * cost about the minimum, O(n k^2) in the worst case. */
  std::vector<std::size_t> assign(const std::vector<PlanCurve>& curves) const;

private:
  /** @brief Evidence of the points around a sample for a curve. */
  struct Testimony {
    double count = 0;  ///< number of points on the curve, nearer ones weighted more
    double offset = 0; ///< mean signed distance from the curve, metres
  };

  double reach() const;
  void lookAround(std::size_t i);
  void judge(std::size_t i, const std::vector<PlanCurve>& curves, double* costs) const;
  Testimony hear(std::size_t i, const PlanCurve& curve) const;
  double costSupported(const ContourSample& sample,
                       const PlanCurve& curve,
                       const Testimony& heard,
                       double most) const;

  const std::vector<ContourSample>& samples_;
  const PlanPoints& evidence_;
  const LoopParameters& parameters_;
  std::vector<std::vector<Eigen::Vector2d>> points_; ///< around each sample
  std::vector<std::size_t> wall_; ///< points of the densest wall at each sample
};

} // namespace pcl::sedr
