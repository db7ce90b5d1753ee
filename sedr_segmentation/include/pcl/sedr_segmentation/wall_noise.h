// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief Noise of the walls of rooms that share heights, measured along straight
 * stretches of them; metres. It decides how many corners a plan has. */
struct WallNoise {
  double measured = 0;       ///< standard deviation of a place from a metre of its wall
  double sigma = 0.01;       ///< that which the fit takes: within what it is made for
  double correlation = 0.1;  ///< so long a piece of wall is one independent observation
  double spread = 0.01;      ///< standard deviation of such an observation from metres
                             ///< of its wall, which waves: at least sigma
  std::size_t stretches = 0; ///< in which it was measured; 0: too few, it is assumed
  std::vector<std::uint32_t> rooms; ///< their numbers
};

} // namespace pcl::sedr
