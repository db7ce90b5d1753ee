// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_surface/src/solid/room_layers.h"
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/scan_frame.h>
#include <pcl/sedr_surface/floorplan_drawing.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <optional>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief Whether a file's name ends in `extension`, such as ".ply". */
bool hasExtension(const std::string& path, const std::string& extension);

/** @brief Throws a ToolError if the name of a solid does not end in .ply, .obj or .glb,
 * or if it, and the materials of an OBJ, cannot be written. To be asked before the
 * work. */
void checkSolidOutput(const std::string& path);

/** @brief Writes solids as PLY, or as OBJ with a file of materials beside it, solid.mtl
 * for solid.obj, or as GLB; each whole or not at all. What fails is a ToolError.
 * @param plan whose solids they are: it tells their storeys */
void saveSolid(const std::string& path,
               const TriangleMesh& mesh,
               const std::vector<SolidElement>& elements,
               const Floorplan& plan,
               const Origin& origin = {});

/** @brief What the header of a mesh says of its origin: nothing of 0. */
std::vector<std::string> originComments(const Origin& origin);

/** @brief Likewise for a drawing: .svg, .pdf or .dxf. */
void checkDrawingOutput(const std::string& path);

/** @brief A drawing to write: its file, and what is on it. */
struct DrawingSheet {
  std::string path;
  std::optional<PlanStorey> storey; ///< nothing: the whole plan
};

/** @brief One sheet of the name `path` for a plan of one storey, else one a storey with
 * its number before the extension: plan_1.svg, plan_2.svg. */
std::vector<DrawingSheet> drawingSheets(const std::string& path, const Floorplan& plan);

/** @brief Writes a drawing; the storey is that of the sheet. */
void saveDrawing(const DrawingSheet& sheet,
                 const Floorplan& plan,
                 DrawingSettings settings = {});

} // namespace tools
} // namespace sedr
} // namespace pcl
