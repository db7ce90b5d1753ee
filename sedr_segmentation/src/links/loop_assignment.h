// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../loop/loop_fit.h"

#include <cstddef>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Assigns the samples of a loop to curves. What the points around each sample
 * are does not depend on the curves: they are looked up once, however often these
 * change. */
class CurveAssignment {
public:
  /** @brief All must outlive this. */
  CurveAssignment(const std::vector<ContourSample>& samples,
                  const PlanPoints& evidence,
                  const LoopParameters& parameters);

  /** @brief The curve of every sample: the cheapest closed sequence, where a sample
   * costs what the evidence around it has against the curve, and every change of curve
   * costs a constant, more where the two run side by side (Viterbi 1967, around the
   * loop). O(n k log k) for n samples and k curves
   * of which few are as cheap as the best, O(n k^2) at worst. */
  std::vector<std::size_t> assign(const std::vector<PlanCurve>& curves) const;

private:
  /** @brief What the points around a sample say about a curve. */
  struct Testimony {
    double count = 0;  ///< of the points on the curve, those near it counting more
    double offset = 0; ///< of their mean from the curve, metres
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
  std::vector<std::size_t> wall_; ///< points of the densest wall across each sample
};

} // namespace sedr
} // namespace pcl
