// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "painter.h"

#include <string>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief A line of the legend; a colour of its own says what that colour means. */
struct LegendLine {
  std::string text; ///< ASCII
  Colour colour = colours::ink;
  bool is_sample = false; ///< whether a patch of the colour stands before the text
};

/** @brief What is shown, its counts, and what the colours mean, rooms with their areas;
 * ASCII, from the top down. */
std::vector<LegendLine>
legendOf(const ViewedResult& result, const Painter& painter, const ViewState& state);

/** @brief A count with its thousands apart: "1,234,567". */
std::string countText(std::size_t count);

} // namespace tools
} // namespace sedr
} // namespace pcl
