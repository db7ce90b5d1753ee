// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace pcl {
namespace sedr {

/** @brief The width of a line of text in Helvetica, and in fonts made to its measure
 * (Arial, Liberation Sans), over the size of the font.
 * @param utf8 letters that are not ASCII count as wide as a digit */
double textWidth(const std::string& utf8);

/** @brief The letters of a text one by one, as numbers of Unicode; bytes that are no
 * UTF-8 become "?". */
std::u32string lettersOf(const std::string& utf8);

} // namespace sedr
} // namespace pcl
