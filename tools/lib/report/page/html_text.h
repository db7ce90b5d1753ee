// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "colour.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Returns a colour as in CSS: "#f0901e". */
std::string hexCode(Colour colour);

/** @brief Escapes text for elements and attributes: & < > " ' become entities, control
 * characters and invalid UTF-8 become U+FFFD. */
std::string escaped(const std::string& text);

/** @brief Returns a table with one header row; cells are HTML. Columns from the second
 * on hold numbers, unless `is_text` says otherwise. */
std::string htmlTable(const std::vector<std::string>& heads,
                      const std::vector<std::vector<std::string>>& rows,
                      const std::vector<bool>& is_text = {});

/** @brief Returns a section with its heading and an id to link to. */
std::string
htmlSection(const std::string& id, const std::string& heading, const std::string& body);

/** @brief Returns an embedded picture with a caption.
 * @param png bytes of a PNG file
 * @param caption HTML */
std::string htmlPicture(const std::string& png, const std::string& caption);

/** @brief Formats a number with fixed decimals and separated thousands. */
std::string numberText(double value, int digits);

/** @brief Formats a share of 1 in percent: "12 %", "0.4 %". */
std::string percentText(double share);

std::string base64(const std::uint8_t* bytes, std::size_t count);

std::string base64(const std::string& bytes);

} // namespace pcl::sedr::tools
