// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief Text as it may stand in an element or an attribute: & < > " ' become
 * entities, control characters and bytes that are no UTF-8 become U+FFFD. */
std::string escaped(const std::string& text);

/** @brief The same for a string in quotes within a script, quotes included: nothing in
 * it ends the script. */
std::string scriptString(const std::string& text);

/** @brief A table: one row of heads, then the rows; cells are HTML already. Columns
 * from the second on hold numbers, unless `is_text` says otherwise for one. */
std::string htmlTable(const std::vector<std::string>& heads,
                      const std::vector<std::vector<std::string>>& rows,
                      const std::vector<bool>& is_text = {});

/** @brief A section with its heading and an id to link to. */
std::string
htmlSection(const std::string& id, const std::string& heading, const std::string& body);

/** @brief A picture with a caption, in the page itself.
 * @param png bytes of a PNG file
 * @param caption HTML */
std::string htmlPicture(const std::string& png, const std::string& caption);

/** @brief A number with so many digits after the point, thousands apart. */
std::string numberText(double value, int digits);

/** @brief A share of 1 in percent: "12 %", "0.4 %". */
std::string percentText(double share);

std::string base64(const std::uint8_t* bytes, std::size_t count);

std::string base64(const std::string& bytes);

} // namespace tools
} // namespace sedr
} // namespace pcl
