// SPDX-License-Identifier: BSD-3-Clause
#include "page_sections.h"

#include "html_text.h"

namespace pcl::sedr::tools {

namespace {

struct Deliverable {
  const char* name; ///< without extension
  const char* extension;
  bool is_a_storey; ///< whether there may be one per storey, with its number
  const char* what;
  const char* opens;
};

constexpr Deliverable deliverables[] = {
    {"model", ".ifc", false, "building model, IFC4: rooms, walls, slabs, openings",
     "Revit, Archicad, Allplan, FreeCAD, Blender with Bonsai, IFC viewers"},
    {"floorplan", ".dxf", true, "drawing in metres, with dimensions",
     "AutoCAD, BricsCAD, QCAD, LibreCAD"},
    {"floorplan", ".pdf", true, "drawing to scale, to print", "any PDF viewer"},
    {"floorplan", ".svg", true, "the same drawing, to edit",
     "any browser, Inkscape, Illustrator"},
    {"model", ".glb", false, "sharp model for the web, glTF 2.0",
     "Blender, three.js, Windows 3D Viewer, most viewers online"},
    {"solid", ".obj", false, "sharp model, grouped by storey, room and element",
     "Blender, SketchUp, Rhino, MeshLab"},
    {"solid", ".ply", false, "sharp model, coloured by label",
     "MeshLab, CloudCompare, Blender"},
    {"mesh", ".ply", false, "closed mesh, coloured by label",
     "MeshLab, CloudCompare, Blender"},
    {"structure", ".pcd", false, "points of the structure, with label and room",
     "CloudCompare, pcl_viewer, pcl_sedr_viewer"},
    {"floorplan", ".json", false, "plan, with all figures", "programs"},
    {"report", ".json", false, "this report", "programs"}};

} // namespace

std::string
deliverablesPart(const ResultFolder& folder, const ReportData& data)
{
  std::vector<std::vector<std::string>> rows;
  const auto add = [&](const Deliverable& d, const std::string& name) {
    if (folder.has(name))
      rows.push_back({"<a href=\"" + name + "\">" + name + "</a>", d.what, d.opens});
  };
  for (const Deliverable& d : deliverables) {
    add(d, std::string(d.name) + d.extension);
    if (d.is_a_storey)
      for (const auto& storey : data.storeys)
        add(d, d.name + ("_" + std::to_string(storey.number)) + d.extension);
  }
  if (rows.empty())
    return "";
  return htmlSection(
      "files", "Files",
      htmlTable({"file", "what it is", "what opens it"}, rows, {true, true, true}));
}

} // namespace pcl::sedr::tools
