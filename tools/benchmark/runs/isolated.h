// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

namespace pcl {
namespace sedr {
namespace benchmark {

/** @brief Calls `work` in a process of its own and returns what it returned, so that
 * not even a crash ends the caller, and every run begins with fresh memory. The calling
 * process must have no other thread.
 * @throw std::runtime_error, a sentence: what `work` threw, or which signal ended it */
std::string runIsolated(const std::function<std::string()>& work);

} // namespace benchmark
} // namespace sedr
} // namespace pcl
