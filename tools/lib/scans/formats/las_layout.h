// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

namespace pcl::sedr::tools::las {

/** Bytes of a point, and where its colour is, by point format; 0: it has none. */
inline constexpr std::array<std::size_t, 11> sizes{20, 28, 26, 34, 57, 63,
                                                   30, 36, 38, 59, 67};
inline constexpr std::array<std::size_t, 11> colours{0, 0,  20, 28, 0, 28,
                                                     0, 30, 30, 0,  30};

/** Bytes at which the numbers of a header stand. */
constexpr std::size_t encoding = 6;
constexpr std::size_t version = 24;
constexpr std::size_t software = 58; ///< that wrote it
constexpr std::size_t header_size = 94;
constexpr std::size_t begin = 96;         ///< of the points
constexpr std::size_t descriptions = 100; ///< how many records stand before the points
constexpr std::size_t format = 104;
constexpr std::size_t record = 105;
constexpr std::size_t points = 107; ///< then five numbers: by return
constexpr std::size_t scale = 131;
constexpr std::size_t shift = 155;
constexpr std::size_t bounds = 179;        ///< greatest and least x, y and z
constexpr std::size_t waveforms = 227;     ///< LAS 1.3
constexpr std::size_t after = 235;         ///< LAS 1.4: records after the points
constexpr std::size_t records_after = 243; ///< how many these are
constexpr std::size_t many_points = 247;   ///< then fifteen: by return

constexpr unsigned newest_minor = 4; ///< of version 1.x
constexpr std::size_t header_of_1_4 = 375;

} // namespace pcl::sedr::tools::las
