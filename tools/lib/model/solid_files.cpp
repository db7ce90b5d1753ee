// SPDX-License-Identifier: BSD-3-Clause
#include "solid_files.h"

#include "bytes/whole_file.h"
#include "report.h" // SheetTexts as JSON
#include "tool_error.h"

#include "sedr_filters/src/base/parallel.h"
#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_surface/plan_review.h>
#include <pcl/sedr_surface/triangle_mesh.h>

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

void
addSheetTexts(Options& options, SheetTexts& texts)
{
  options.words("title", texts.title,
                "of the sheets; none: what is drawn, such as \"Floor plan\"");
  options.words("client", texts.client, "of the title block, as are the next ones");
  options.words("project", texts.project,
                "name of the project, also in the IFC, whose GUIDs are made of it");
  options.date("date", texts.date, "of the sheets and the IFC");
  options.words("drawn-by", texts.drawn_by, "who has drawn it, author of the IFC");
}

SheetTexts
filledIn(const SheetTexts& texts, const nlohmann::ordered_json& report)
{
  const auto told = report.find("parameters");
  nlohmann::json filled = texts;
  if (told != report.end() && told->is_object())
    for (auto& [name, text] : filled.items())
      if (text == "" && told->contains(name) && told->at(name).is_string())
        text = told->at(name).get<std::string>();
  return filled;
}

std::vector<DrawingSheet>
drawingSheets(const std::vector<std::string>& paths,
              const Floorplan& plan,
              DrawingView view)
{
  const std::vector<PlanStorey> storeys = storeysOf(plan);
  if (storeys.size() <= 1)
    return {{paths, {}, view, {}}};
  std::vector<DrawingSheet> sheets;
  for (const PlanStorey& storey : storeys) {
    sheets.push_back({paths, storey, view, {}});
    for (std::string& path : sheets.back().paths) {
      std::filesystem::path name(path);
      const std::string extension = name.extension();
      path = name.replace_extension().string() + "_" + std::to_string(storey.number) +
             extension;
    }
  }
  return sheets;
}

std::vector<DrawingSheet>
allDrawings(const Floorplan& plan)
{
  const auto named = [](const std::string& name) {
    return std::vector{name + ".svg", name + ".pdf", name + ".dxf"};
  };
  std::vector<DrawingSheet> all = drawingSheets(named("floorplan"), plan);
  for (const DrawingSheet& sheet :
       drawingSheets(named("ceiling"), plan, DrawingView::Ceiling))
    all.push_back(sheet);
  all.push_back({named("section_rooms"), {}, {}, sectionThroughRooms(plan)});
  if (const auto line = sectionThroughStairs(plan))
    all.push_back({named("section_stairs"), {}, {}, line});
  return all;
}

std::vector<SectionLine>
sectionsOf(const std::vector<DrawingSheet>& sheets)
{
  std::vector<SectionLine> sections;
  for (const DrawingSheet& sheet : sheets)
    if (sheet.section)
      sections.push_back(*sheet.section);
  return sections;
}

bool
saveDrawing(const DrawingSheet& sheet, const Floorplan& plan, DrawingSettings settings)
{
  settings.storey = sheet.storey ? &*sheet.storey : nullptr;
  settings.view = sheet.view;
  std::vector<DrawingFormat> formats;
  for (const std::string& path : sheet.paths)
    formats.push_back(formatOf(path));
  const std::vector<std::string> files =
      sheet.section ? drawSection(plan, *sheet.section, formats, settings)
                    : drawFloorplan(plan, formats, settings);
  for (std::size_t k = 0; k < files.size(); ++k)
    writeWhole(sheet.paths[k], files[k]);
  return !files.empty();
}

std::vector<std::string>
planFileNames()
{
  std::vector<std::string> names{"solid.ply",    "solid.obj", "solid.mtl",
                                 "model.ifc",    "model.glb", "rooms.csv",
                                 "openings.csv", "walls.csv", "floorplan.json"};
  for (const DrawingSheet& sheet : allDrawings({}))
    names.insert(names.end(), sheet.paths.begin(), sheet.paths.end());
  return names;
}

void
writeSolids(const OutputFolder& folder, const PlanFiles& files)
{
  const PlanDocument& document = files.document;
  writeWhole(folder.file("floorplan.json"), documentToJson(document));
  for (const char* name : {"solid.ply", "solid.obj", "model.glb"})
    saveSolid(folder.file(name), files.solid, files.elements, document.plan,
              document.origin, files.colours);
}

IfcModel
writeBuildingModel(const OutputFolder& folder, const PlanFiles& files)
{
  const PlanDocument& document = files.document;
  IfcSettings settings;
  if (!files.texts.project.empty())
    settings.name = files.texts.project;
  settings.date = files.texts.date;
  settings.author = files.texts.drawn_by;
  settings.scan = document.scan;
  settings.max_wall = document.max_wall;
  IfcModel model = writeIfc(document.plan, settings, document.origin);
  writeWhole(folder.file("model.ifc"), model.text);
  for (const ScheduleTable& table : tablesOf(model.schedules))
    writeWhole(folder.file(table.name + ".csv"), csvOf(table));
  return model;
}

void
writeDrawings(const OutputFolder& folder, const PlanFiles& files)
{
  const PlanDocument& document = files.document;
  DrawingSettings settings;
  settings.texts = files.texts;
  settings.max_wall = document.max_wall;
  settings.origin = document.origin;
  settings.is_numbered = wallsAmong(files.doubted);
  std::vector<DrawingSheet> sheets = allDrawings(document.plan);
  settings.sections = sectionsOf(sheets);
  for (DrawingSheet& sheet : sheets)
    for (std::string& path : sheet.paths)
      path = folder.file(path);
  parallelBlocks(sheets.size(), 1, files.threads, [&](std::size_t k, std::size_t) {
    saveDrawing(sheets[k], document.plan, settings);
  });
}

} // namespace pcl::sedr::tools
