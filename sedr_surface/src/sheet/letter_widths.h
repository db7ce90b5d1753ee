// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace pcl::sedr {

/** @brief Returns the width of a line of text over the font size, in Helvetica and
 * metrically compatible fonts (Arial, Liberation Sans).
 * @param utf8 letters that are not ASCII count as wide as a digit */
double textWidth(const std::string& utf8);

/** @brief Returns the letters of a text as Unicode code points; invalid UTF-8 becomes
 * "?". */
std::u32string lettersOf(const std::string& utf8);

} // namespace pcl::sedr
