// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace pcl::sedr {

/** @brief Offsets in a halo of a BandGrid from a cell's lowest corner to all eight. */
constexpr std::array<std::uint32_t, 8> corners = {0, 1, 10, 11, 100, 101, 110, 111};

/** @brief Computes the trilinear weights of the corners for a point within the cell.
 * @param share position along each axis, 0 to 1 */
inline void
cornerShares(const float* share, float* shares)
{
  for (std::size_t c = 0; c < 8; ++c)
    shares[c] = (c & 1 ? share[0] : 1 - share[0]) * (c & 2 ? share[1] : 1 - share[1]) *
                (c & 4 ? share[2] : 1 - share[2]);
}

} // namespace pcl::sedr
