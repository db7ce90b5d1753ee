// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.h"
#include "output_folder.h"

#include "sedr_surface/src/solid/room_layers.h"
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/floorplan_io.h>
#include <pcl/sedr_filters/scan_frame.h>
#include <pcl/sedr_surface/floorplan_drawing.h>
#include <pcl/sedr_surface/floorplan_ifc.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <nlohmann/json.hpp>

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Throws ToolError if the file name of a solid does not end in .ply, .obj or
 * .glb, or if it or the materials of an OBJ cannot be written. To be called before the
 * work. */
void checkSolidOutput(const std::string& path);

/** @brief Writes solids as PLY, as OBJ with materials beside it (solid.mtl for
 * solid.obj), or as GLB; each completely or not at all. Throws ToolError on failure.
 * @param plan of these solids, for the storeys
 * @param colours of the elements of a GLB; empty: those of the labels */
void saveSolid(const std::string& path,
               const TriangleMesh& mesh,
               const std::vector<SolidElement>& elements,
               const Floorplan& plan,
               const Origin& origin = {},
               const std::vector<SeenColour>& colours = {});

/** @brief Returns header lines with the origin of a mesh; empty if it is 0. */
std::vector<std::string> originComments(const Origin& origin);

/** @brief As checkSolidOutput(), for a drawing: .svg, .pdf or .dxf. */
void checkDrawingOutput(const std::string& path);

/** @brief Returns the format of a drawing by the extension of its file. */
DrawingFormat formatOf(const std::string& path);

/** @brief Declares the options for the texts of sheets. */
void addSheetTexts(Options& options, SheetTexts& texts);

/** @brief Returns texts of sheets; those that are empty as a report.json tells them. */
SheetTexts filledIn(const SheetTexts& texts, const nlohmann::ordered_json& report);

/** @brief A drawing to write: its files and its content. */
struct DrawingSheet {
  std::vector<std::string> paths;     ///< one a format, at least one
  std::optional<PlanStorey> storey{}; ///< empty: the whole plan
  DrawingView view = DrawingView::Floor;
  std::optional<SectionLine> section{}; ///< instead of the plan
};

/** @brief Returns one sheet named `paths` for a plan with one storey, else one per
 * storey with its number before the extension: plan_1.svg, plan_2.svg. */
std::vector<DrawingSheet> drawingSheets(const std::vector<std::string>& paths,
                                        const Floorplan& plan,
                                        DrawingView view = DrawingView::Floor);

/** @brief Returns the drawings of a model, in all formats: plan and ceiling plan of
 * each storey, a section through most rooms, and one through the stairs if they were
 * seen. */
std::vector<DrawingSheet> allDrawings(const Floorplan& plan);

/** @brief Returns the sections among some sheets. */
std::vector<SectionLine> sectionsOf(const std::vector<DrawingSheet>& sheets);

/** @brief Writes a drawing in all of its formats. The settings hold but for storey and
 * view. Returns false, and writes nothing, if its section cuts no room. */
bool saveDrawing(const DrawingSheet& sheet,
                 const Floorplan& plan,
                 DrawingSettings settings = {});

/** @brief A plan and its solid, of which the files of a model are made that do not need
 * the scan. */
struct PlanFiles {
  PlanDocument document;
  TriangleMesh solid; ///< in the frame to write it in
  std::vector<SolidElement> elements;
  std::vector<SeenColour> colours; ///< of the elements; empty: those of their labels
  SheetTexts texts;
  unsigned threads = 0;            ///< 0: all processors
  std::set<std::string> doubted{}; ///< subjects of doubts whose walls drawings number
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
