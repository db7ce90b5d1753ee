// SPDX-License-Identifier: BSD-3-Clause
#include "edited_model.h"

#include "bytes/whole_file.h"
#include "carried_report.h"
#include "colours/scan_colours.h"
#include "model/plan_files.h"
#include "model/plan_report.h"
#include "plan_file.h"
#include "report/report_page.h"
#include "result_exchange.h"
#include "results/result_folder.h"
#include "run_tool.h"
#include "tool_cloud.h"
#include "tool_error.h"

#include "sedr_filters/src/editing/plan_edits.h"
#include "sedr_surface/src/sheet/sheet.h"
#include <pcl/sedr_surface/floorplan_extrusion.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace pcl::sedr::tools {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Extrusion = pcl::FloorplanExtrusion<pcl::PointXYZ>;

/** @brief Returns the ending of the files that the next edit keeps: so many tildes that
 * there are none yet. */
std::string
nextEnding(const std::string& path)
{
  std::string ending = "~";
  while (fs::exists(fs::path(path) / ("floorplan.json" + ending)))
    ending += "~";
  return ending;
}

/** @brief The files of an edited model while they are written. */
class EditedModel {
public:
  /** @param ending of the names of the plan and the report that it has */
  EditedModel(const std::string& path, const std::string& ending)
      : path_(path)
      , folder_(path, {})
      , before_(path)
  {
    for (const char* name : {"report.json", "floorplan.json"})
      if (!before_.has(name + ending))
        throw ToolError("'" + path + "' has no " + name + ending +
                        (ending.empty() ? ", as pcl_sedr leaves it"
                                        : ": there is no edit to undo"));
    plan_text = textOfFile(before_.file("floorplan.json" + ending));
    report_text = textOfFile(before_.file("report.json" + ending));
    report = Json::parse(report_text);
    files.document = loadPlan(before_.file("floorplan.json" + ending));
  }

  /** @brief Writes the files that follow from the plan, but not the report. */
  void writePlan()
  {
    loadFonts();
    const Json& parameters = report["parameters"];
    files.texts = nlohmann::json(parameters).get<SheetTexts>();
    extrusion.setFloorplan(files.document.plan);
    extrusion.setCutOpenings(parameters.value("cut_openings", false));
    pcl::PolygonMesh unused;
    extrusion.reconstruct(unused);
    files.solid = extrusion.getMesh();
    files.elements = extrusion.getElements();
    if (files.document.levelling && !parameters.value("levelled", false))
      for (Eigen::Vector3d& v : files.solid.vertices)
        v = files.document.levelling->back(v);
    files.colours =
        colours().ofElements(files.solid, files.elements.size(), files.threads);
    writeSolids(folder_, files);
    ifc = writeBuildingModel(folder_, files);
    writeDrawings(folder_, files);
  }

  void write(const std::string& name, const std::string& text)
  {
    writeWhole(folder_.file(name), text);
  }

  /** @brief Writes the report, and its page if there is one, and exchanges all files.
   * @param removed names of files to remove
   * @return the names of those that stay */
  std::vector<std::string> finish(const std::vector<std::string>& removed = {})
  {
    std::vector<std::string> written = folder_.written();
    std::vector<std::string> kept;
    for (const std::string& name : writtenFiles(path_))
      if (before_.has(name) && name != "report.json" && name != "report.html" &&
          !std::binary_search(written.begin(), written.end(), name) &&
          !isOfPlan(name)) {
        std::error_code error; // of file systems without links
        fs::create_hard_link(before_.file(name), folder_.file(name), error);
        if (error)
          fs::copy_file(before_.file(name), folder_.file(name));
        kept.push_back(name);
      }
    written = folder_.written();
    written.erase(std::remove_if(written.begin(), written.end(),
                                 [](const auto& name) { return name.back() == '~'; }),
                  written.end());
    written.emplace_back("report.json");
    if (before_.has("report.html"))
      written.emplace_back("report.html");
    report["files"] = written;
    write("report.json", textOf(report, files.document.origin));
    if (before_.has("report.html")) {
      PageSettings page;
      page.name = fs::absolute(path_ + "/").lexically_normal().parent_path().filename();
      page.scan = before_.scanPath();
      writePage(fs::path(folder_.file("")).string(), page);
    }
    folder_.exchange(removed);
    return kept;
  }

  PlanFiles files;
  IfcModel ifc;
  Extrusion extrusion;
  Json report;
  std::string plan_text;   ///< as it was read
  std::string report_text; ///< as it was read

private:
  /** @brief Returns the colours that the points of the structure have. */
  SurfaceColours colours() const
  {
    if (!before_.has("structure.pcd"))
      return {};
    const ToolCloud cloud = loadCloud(before_.file("structure.pcd"));
    const std::vector<std::uint32_t> seen = wholeField(cloud.blob, "seen");
    const auto* const rgb = findField(cloud.blob, "rgb");
    SurfacePlaces places;
    std::vector<SeenColour> colours;
    for (std::size_t i = 0; rgb && i < seen.size(); ++i) {
      const std::uint8_t* const blue =
          &cloud.blob.data[i * cloud.blob.point_step + rgb->offset];
      places.add((*cloud.points)[i].getVector3fMap(), {cloud.room[i], cloud.label[i]});
      colours.push_back({{blue[2], blue[1], blue[0]}, seen[i] != 0});
    }
    return {places, colours, before_.voxelSize()};
  }

  /** @brief Returns whether a file that is not written any more was of the plan before:
   * a drawing, of a storey or stair that is gone. */
  static bool isOfPlan(const std::string& name)
  {
    return hasExtension(name, ".svg") || hasExtension(name, ".pdf") ||
           hasExtension(name, ".dxf");
  }

  std::string path_;
  OutputFolder folder_;
  ResultFolder before_;
};

} // namespace

std::vector<std::string>
editModel(const std::string& path, const EditPlan& edit)
{
  EditedModel model(path, "");
  PlanDocument& document = model.files.document;
  const Floorplan before = document.plan;
  PlanEditor editor(before, document.max_wall);
  const std::vector<std::string> edits = edit(editor);
  document.plan = editor.getFloorplan();
  model.writePlan();
  const std::string ending = nextEnding(path);
  model.write("floorplan.json" + ending, model.plan_text);
  model.write("report.json" + ending, model.report_text);
  std::vector<PlanWarning> warnings =
      carriedWarnings(model.report, before, document.plan, edits);
  std::vector<PlanWarning> of_files = model.extrusion.getWarnings();
  for (const RoomSolidReport& solid : model.extrusion.getReports())
    if (!solid.problem.empty())
      of_files.push_back({WarningKind::NoSolid, {}, solid.room, 0, solid.problem});
  of_files.insert(of_files.end(), model.ifc.warnings.begin(), model.ifc.warnings.end());
  for (const PlanWarning& warning : of_files)
    warn(sentenceOf(warning));
  warnings.insert(warnings.end(), of_files.begin(), of_files.end());
  const Json rooms = model.report["rooms"];
  setPlan(model.report, document.plan, model.ifc.schedules,
          model.extrusion.getReports(), warnings);
  carryOver(model.report, rooms, before, document.plan);
  return model.finish();
}

std::vector<std::string>
undoEdit(const std::string& path)
{
  const std::string ending = nextEnding(path).substr(1); // the one before
  EditedModel model(path, ending.empty() ? "~" : ending);
  model.writePlan();
  model.write("floorplan.json", model.plan_text);
  return model.finish({"floorplan.json" + ending, "report.json" + ending});
}

} // namespace pcl::sedr::tools
