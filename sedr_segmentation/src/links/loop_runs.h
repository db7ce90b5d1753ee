// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../loop/loop_fit.h"

#include <cstddef>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Samples first .. first + count - 1 (around the loop) that follow one curve.
 */
struct Run {
  PlanCurve curve;
  std::size_t first = 0;
  std::size_t count = 0;
  bool is_known = false;
};

/** @brief The curves that the samples of a loop follow, one after the other around it,
 * first as found, then as fitted to the evidence; `known` ones stay as they are. Empty
 * where there are none. */
std::vector<Run> findRuns(const std::vector<ContourSample>& samples,
                          const PlanPoints& evidence,
                          const std::vector<PlanCurve>& known,
                          const LoopParameters& parameters);

} // namespace sedr
} // namespace pcl
