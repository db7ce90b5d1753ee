// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "output_folder.h"

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_surface/floorplan_drawing.h>

#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Drawings in a result folder of a plan with one storey. */
extern const std::vector<std::string> drawing_names;

/** @brief Writes the drawings of a plan as SVG, PDF and DXF; with several storeys one
 * each, with its number. Drawings of an earlier run are removed, except `input`. */
void writeDrawings(OutputFolder& folder,
                   const Floorplan& plan,
                   const std::string& input,
                   const DrawingSettings& settings = {},
                   unsigned threads = 1);

} // namespace pcl::sedr::tools
