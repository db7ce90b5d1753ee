// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

namespace pcl::sedr::tools::las {

/** @brief A point format: record size and offset of the colour. */
struct Format {
  std::size_t record;
  std::size_t colour; ///< 0: none
};

inline constexpr std::array<Format, 11> formats{{{20, 0},
                                                 {28, 0},
                                                 {26, 20},
                                                 {34, 28},
                                                 {57, 0},
                                                 {63, 28},
                                                 {30, 0},
                                                 {36, 30},
                                                 {38, 30},
                                                 {59, 0},
                                                 {67, 30}}};

/** Bytes at which the numbers of a header stand. */
constexpr std::size_t encoding = 6;
constexpr std::size_t version = 24;
constexpr std::size_t software = 58; ///< that wrote it
constexpr std::size_t header_size = 94;
constexpr std::size_t begin = 96;         ///< of the points
constexpr std::size_t descriptions = 100; ///< how many records stand before the points
constexpr std::size_t format = 104;
constexpr std::size_t record = 105;
constexpr std::size_t points = 107;
constexpr std::size_t returns = 111; ///< five numbers: points by return
constexpr std::size_t scale = 131;
constexpr std::size_t shift = 155;
constexpr std::size_t bounds = 179;        ///< greatest and least x, y and z
constexpr std::size_t waveforms = 227;     ///< LAS 1.3
constexpr std::size_t after = 235;         ///< LAS 1.4: records after the points
constexpr std::size_t records_after = 243; ///< how many these are
constexpr std::size_t many_points = 247;
constexpr std::size_t many_returns = 255; ///< fifteen numbers

constexpr unsigned newest_minor = 4; ///< of version 1.x
constexpr std::size_t header_of_1_4 = 375;

} // namespace pcl::sedr::tools::las
