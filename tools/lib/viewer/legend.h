// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "image.h"
#include "painter.h"

#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief A line of the legend, optionally with a colour that it explains. */
struct LegendLine {
  std::string text; ///< ASCII
  Colour colour = colours::ink;
  bool is_sample = false; ///< whether a colour patch precedes the text
};

/** @brief Returns what is shown, counts, and the meanings of colours, rooms with their
 * areas; ASCII, from top to bottom. */
std::vector<LegendLine>
legendOf(const ViewedResult& result, const Painter& painter, const ViewState& state);

/** @brief Formats a count with separated thousands: "1,234,567". */
std::string countText(std::size_t count);

/** @brief Draws the legend for a view: lines of text, some with a colour patch. Empty,
 * 0 by 0, for no lines. */
Image drawLegend(const std::vector<LegendLine>& lines);

} // namespace pcl::sedr::tools
