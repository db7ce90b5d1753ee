// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

namespace pcl::sedr::benchmark {

/** @brief Calls `work` in a separate process. A crash there does
 * not end the caller, and every run starts with fresh memory. The caller must have no
 * other thread.
 * @throw std::runtime_error, a sentence: the error of `work`, or the signal that ended
 * the process */
void runIsolated(const std::function<void()>& work);

} // namespace pcl::sedr::benchmark
