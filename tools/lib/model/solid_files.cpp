// SPDX-License-Identifier: BSD-3-Clause
#include "solid_files.h"

#include "bytes/whole_file.h"
#include "tool_error.h"

#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_surface/mesh_io.h>

#include <filesystem>

namespace pcl::sedr::tools {

namespace {

std::filesystem::path
materialsOf(const std::string& path)
{
  return std::filesystem::path(path).replace_extension(".mtl");
}

} // namespace

void
checkSolidOutput(const std::string& path)
{
  checkOutput(path, "a solid", {".ply", ".obj", ".glb"});
  if (hasExtension(path, ".obj"))
    checkWritable(materialsOf(path).string());
}

void
saveSolid(const std::string& path,
          const TriangleMesh& mesh,
          const std::vector<SolidElement>& elements,
          const Floorplan& plan,
          const Origin& origin,
          const std::vector<SeenColour>& colours)
{
  const std::vector<std::string> of_origin = originComments(origin);
  if (hasExtension(path, ".ply")) {
    std::vector<std::string> comments = elementComments(mesh, elements);
    comments.insert(comments.begin(), of_origin.begin(), of_origin.end());
    writeWhole(path, meshToPly(mesh, comments));
    return;
  }
  if (hasExtension(path, ".glb")) {
    writeWhole(path, solidToGlb(mesh, elements, storeysOf(plan), origin, colours));
    return;
  }
  const auto materials = materialsOf(path);
  writeWhole(materials.string(), solidMaterials());
  writeWhole(path, [&](std::ostream& stream) {
    for (const std::string& comment : of_origin)
      stream << "# " << comment << '\n';
    stream << solidToObj(mesh, elements, materials.filename().string(),
                         storeyOfRooms(plan));
  });
}

std::vector<std::string>
originComments(const Origin& origin)
{
  if (origin.isZero())
    return {};
  return {origin.comment()};
}

void
checkDrawingOutput(const std::string& path)
{
  checkOutput(path, "a drawing", {".svg", ".pdf", ".dxf"});
}

DrawingFormat
formatOf(const std::string& path)
{
  return hasExtension(path, ".svg")   ? DrawingFormat::Svg
         : hasExtension(path, ".pdf") ? DrawingFormat::Pdf
                                      : DrawingFormat::Dxf;
}

std::vector<DrawingSheet>
drawingSheets(const std::string& path, const Floorplan& plan, DrawingView view)
{
  const std::vector<PlanStorey> storeys = storeysOf(plan);
  if (storeys.size() <= 1)
    return {{path, {}, view, {}}};
  const std::filesystem::path whole(path);
  std::vector<DrawingSheet> sheets;
  for (const PlanStorey& storey : storeys) {
    std::filesystem::path name = whole.stem();
    name += "_" + std::to_string(storey.number);
    name += whole.extension();
    sheets.push_back({(whole.parent_path() / name).string(), storey, view, {}});
  }
  return sheets;
}

std::vector<DrawingSheet>
allDrawings(const Floorplan& plan)
{
  std::vector<DrawingSheet> all;
  for (const std::string extension : {".svg", ".pdf", ".dxf"}) {
    for (const DrawingSheet& sheet : drawingSheets("floorplan" + extension, plan))
      all.push_back(sheet);
    for (const DrawingSheet& sheet :
         drawingSheets("ceiling" + extension, plan, DrawingView::Ceiling))
      all.push_back(sheet);
    all.push_back({"section_rooms" + extension, {}, {}, sectionThroughRooms(plan)});
    if (const auto line = sectionThroughStairs(plan))
      all.push_back({"section_stairs" + extension, {}, {}, line});
  }
  return all;
}

void
saveDrawing(const DrawingSheet& sheet, const Floorplan& plan, DrawingSettings settings)
{
  settings.storey = sheet.storey ? &*sheet.storey : nullptr;
  settings.view = sheet.view;
  const DrawingFormat format = formatOf(sheet.path);
  auto* const write = format == DrawingFormat::Svg   ? &floorplanToSvg
                      : format == DrawingFormat::Pdf ? &floorplanToPdf
                                                     : &floorplanToDxf;
  writeWhole(sheet.path, sheet.section
                             ? drawSection(plan, *sheet.section, format, settings)
                             : write(plan, settings));
}

} // namespace pcl::sedr::tools
