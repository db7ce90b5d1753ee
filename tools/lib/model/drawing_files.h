// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "output_folder.h"

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/origin.h>

#include <string>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief The drawings in a folder of results, of a plan of one storey. */
extern const std::vector<std::string> drawing_names;

/** @brief Writes the drawings of a plan, counted from `origin`, into a folder: of
 * several storeys one each, with its number. Those of an earlier run, which may have
 * had other storeys, make way; what the run has read, `input`, stays. */
void writeDrawings(OutputFolder& folder,
                   const Floorplan& plan,
                   const std::string& input,
                   const Origin& origin = {});

} // namespace tools
} // namespace sedr
} // namespace pcl
