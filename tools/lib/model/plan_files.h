// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "output_folder.h"

#include <pcl/sedr_filters/floorplan_io.h>
#include <pcl/sedr_surface/floorplan_drawing.h>
#include <pcl/sedr_surface/floorplan_ifc.h>
#include <pcl/sedr_surface/mesh_io.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief A plan and its solid, of which the files of a model are made that do not need
 * the scan. */
struct PlanFiles {
  PlanDocument document;
  TriangleMesh solid; ///< in the frame to write it in
  std::vector<SolidElement> elements;
  std::vector<SeenColour> colours; ///< of the elements; empty: those of their labels
  SheetTexts texts;
  unsigned threads = 0; ///< 0: all processors
};

/** @brief Returns their names, without those of several storeys. */
std::vector<std::string> planFileNames();

/** @brief Writes floorplan.json, solid.ply, solid.obj and model.glb. */
void writeSolids(const OutputFolder& folder, const PlanFiles& files);

/** @brief Writes model.ifc and the schedules of it. */
IfcModel writeBuildingModel(const OutputFolder& folder, const PlanFiles& files);

/** @brief Writes the drawings as SVG, PDF and DXF; with several storeys one each. */
void writeDrawings(const OutputFolder& folder, const PlanFiles& files);

} // namespace pcl::sedr::tools
