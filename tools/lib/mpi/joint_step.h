// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rank_mail.h"

#include <exception>
#include <functional>
#include <string>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief What every rank but the first throws where a joint step failed on some rank;
 * the first throws the ToolError, and will tell. */
class StepFailed : public std::exception {
public:
  const char* what() const noexcept override { return "a joint step failed"; }
};

/** @brief What went wrong, in words; to be called where something was caught. */
std::string currentProblem();

/** @brief "rank 2 on 'tower'". */
std::string nameOf(int rank);

/** @brief What all ranks do at the same time, each with what it holds. If one fails all
 * fail, at the end of this step, so that nobody waits for what will not come: a
 * ToolError on rank 0 that names the ranks that failed and what they held, StepFailed
 * on the others. */
void
together(RankMail& mail, const std::string& held, const std::function<void()>& step);

} // namespace tools
} // namespace sedr
} // namespace pcl
