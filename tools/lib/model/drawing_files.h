// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "output_folder.h"

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_surface/floorplan_drawing.h>

#include <string>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief The drawings in a folder of results, of a plan of one storey. */
extern const std::vector<std::string> drawing_names;

/** @brief Writes the drawings of a plan into a folder, as SVG, PDF and DXF: of
 * several storeys one each, with its number. Those of an earlier run, which may have
 * had other storeys, make way; what the run has read, `input`, stays. */
void writeDrawings(OutputFolder& folder,
                   const Floorplan& plan,
                   const std::string& input,
                   const DrawingSettings& settings = {});

} // namespace tools
} // namespace sedr
} // namespace pcl
