// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rank_mail.h"

#include <exception>
#include <functional>
#include <string>

namespace pcl::sedr::tools {

/** @brief Thrown on all ranks but the first if a joint step failed on any rank; the
 * first throws and reports the ToolError. */
class StepFailed : public std::exception {
public:
  const char* what() const noexcept override { return "a joint step failed"; }
};

/** @brief Describes the current exception; to be called in a catch block. */
std::string currentProblem();

/** @brief Returns "rank 2 on 'tower'". */
std::string nameOf(int rank);

/** @brief Runs a step on all ranks at the same time. If it fails on one, it fails on
 * all at its end, so that no rank waits forever. Rank 0 throws ToolError with the
 * failed ranks and their inputs; the others throw StepFailed. */
void
together(RankMail& mail, const std::string& held, const std::function<void()>& step);

} // namespace pcl::sedr::tools
