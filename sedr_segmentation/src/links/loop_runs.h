// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../loop/loop_fit.h"

#include <cstddef>
#include <vector>

namespace pcl::sedr {

/** @brief A run: samples first .. first + count - 1 (modulo the loop) on one curve. */
struct Run {
  PlanCurve curve;
  std::size_t first = 0;
  std::size_t count = 0;
  bool is_known = false;
};

/** @brief Finds the runs of a loop's samples, in order around it. Curves are found
 * among the samples and fitted to the evidence; `known` ones are not changed. Empty if
 * there are none. */
std::vector<Run> findRuns(const std::vector<ContourSample>& samples,
                          const PlanPoints& evidence,
                          const std::vector<PlanCurve>& known,
                          const LoopParameters& parameters);

} // namespace pcl::sedr
