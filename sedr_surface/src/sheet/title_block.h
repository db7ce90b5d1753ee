// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sheet.h"
#include "sheet_layout.h"

#include <pcl/sedr_filters/scan_frame.h>

#include <string>

namespace pcl {
namespace sedr {

/** @brief What the strip at the foot of a sheet tells. */
struct TitleBlock {
  std::string title;
  std::string storey; ///< "" where all storeys are drawn
  std::size_t rooms = 0;
  double area = 0; ///< square metres
  Origin origin;
  bool has_slopes = false; ///< lines of headroom are to be told
};

/** @brief Adds the frame of the sheet, and at its foot title, storey, rooms and area,
 * scale and bar, an arrow to the north, and fields to be filled in by hand. */
void addTitleBlock(Sheet& sheet, const SheetLayout& layout, const TitleBlock& block);

} // namespace sedr
} // namespace pcl
