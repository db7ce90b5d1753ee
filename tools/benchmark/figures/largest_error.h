// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

namespace pcl::sedr::benchmark {

/** @brief Keeps the larger of two figures; NaN means none. */
inline void
keepLarger(double& figure, double other)
{
  figure = std::isnan(figure) ? other : std::max(figure, other);
}

/** @brief Keeps the larger of two relative errors; NaN means none. */
inline void
keepLargerError(double& error, double found, double truth)
{
  keepLarger(error, std::abs(found - truth) / truth);
}

} // namespace pcl::sedr::benchmark
