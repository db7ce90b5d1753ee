// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

namespace pcl::sedr::benchmark {

/** @brief Calls `work` in a separate process and returns its result. A crash there does
 * not end the caller, and every run starts with fresh memory. The caller must have no
 * other thread.
 * @throw std::runtime_error, a sentence: the error of `work`, or the signal that ended
 * the process */
std::string runIsolated(const std::function<std::string()>& work);

} // namespace pcl::sedr::benchmark
