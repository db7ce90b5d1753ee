// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../sheet/sheet.h"
#include "sheet_layout.h"

#include <pcl/sedr_surface/floorplan_drawing.h>

#include <string>

namespace pcl::sedr {

/** @brief What the title block of a drawing tells beside its settings. */
struct TitleTexts {
  std::string usual_title; ///< if none is given
  std::string part_caption;
  std::string part; ///< storey or section
  std::string summary_caption;
  std::string summary;
  std::string notes;
  bool has_north = true;
};

/** @brief Adds the frame of the sheet and the strip at its foot: title, project,
 * client, part, scale and bar, north arrow, and fields to be filled in by hand. */
void addTitleBlock(Sheet& sheet,
                   const SheetLayout& layout,
                   const DrawingSettings& settings,
                   const TitleTexts& texts);

} // namespace pcl::sedr
