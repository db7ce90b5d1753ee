// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../sheet/sheet.h"
#include "sheet_layout.h"

#include <pcl/sedr_filters/scan_frame.h>

#include <string>

namespace pcl::sedr {

/** @brief Contents of the title strip. */
struct TitleBlock {
  std::string title;
  std::string storey; ///< "" for all storeys
  std::size_t rooms = 0;
  double area = 0; ///< square metres
  Origin origin;
  bool has_guesses = false; ///< whether to explain walls that were not seen
  bool has_slopes = false;  ///< whether to explain the lines of headroom
};

/** @brief Adds the frame of the sheet and the strip at its foot: title, storey, rooms
 * and area, scale and bar, north arrow, and fields to be filled in by hand. */
void addTitleBlock(Sheet& sheet, const SheetLayout& layout, const TitleBlock& block);

} // namespace pcl::sedr
