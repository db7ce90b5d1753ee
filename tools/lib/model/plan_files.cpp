// SPDX-License-Identifier: BSD-3-Clause
#include "plan_files.h"

#include "bytes/whole_file.h"
#include "solid_files.h"

#include "sedr_filters/src/base/parallel.h"

namespace pcl::sedr::tools {

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
