// SPDX-License-Identifier: BSD-3-Clause
#include "edited_model.h"
#include "untouched.h"

#include "bytes/whole_file.h"
#include "colours/scan_colours.h"
#include "model/report.h"
#include "model/solid_files.h"
#include "plan_file.h"
#include "report/report_page.h"
#include "result_exchange.h"
#include "results/result_folder.h"
#include "run_tool.h"
#include "tool_cloud.h"
#include "tool_error.h"

#include "sedr_filters/src/base/number_text.h"
#include "sedr_filters/src/editing/plan_edits.h"
#include "sedr_surface/src/sheet/sheet.h"
#include "sedr_surface/src/sheet/text_places.h"
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_filters/plan_warning.h>
#include <pcl/sedr_surface/floorplan_extrusion.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <system_error>
#include <vector>

namespace pcl::sedr::tools {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/** @brief Returns the maps of walls that are as they were. */
Json
mapsOf(const Json& maps, const Untouched& untouched)
{
  Json kept = Json::array();
  for (Json map : maps) {
    Json walls = Json::array();
    std::uint32_t room = 0;
    for (const Json& wall : map["walls"])
      if (const auto now =
              untouched.find({map.value("room", 0U), wall.get<std::size_t>()})) {
        walls.push_back(now->wall);
        room = now->room;
      }
    if (walls.size() != map["walls"].size())
      continue;
    map["room"] = room;
    map["walls"] = walls;
    kept.push_back(std::move(map));
  }
  return kept;
}

/** @brief Gives the doubt of a room to the room that this is now a part of.
 * @return whether it still is a doubt: not of a room that is gone, whether two rooms
 * are one that were merged, or whether one is two that was split */
bool
followRooms(const Untouched& untouched, PlanWarning& warning)
{
  const std::uint32_t old = warning.room;
  warning.room = untouched.roomNow(old);
  if (warning.kind == WarningKind::OneRoom && warning.values.size() > 2) {
    double& other = warning.values[2];
    if (!(other >= 0 && other <= std::numeric_limits<std::uint32_t>::max()))
      throw ToolError("report.json doubts whether room " + std::to_string(old) +
                      " and room " + numberText(other) +
                      " are one, and that is no number of a room");
    other = untouched.roomNow(static_cast<std::uint32_t>(other));
    return warning.room != 0 && other != 0 && other != warning.room;
  }
  return warning.room != 0 &&
         !(warning.kind == WarningKind::TwoRooms && untouched.isSplit(old));
}

/** @brief Returns what was doubted of a plan and still is, and that it was edited.
 *
 * Doubts of walls follow their numbers, and go with walls that were touched. What a
 * room of another shape was doubted for stays, with a note that it is of the time
 * before. What was told of files is left out.
 * @param[in,out] report of the plan before; the edits are added to those it tells
 * @param edits sentences */
std::vector<PlanWarning>
carriedWarnings(Json& report,
                const Untouched& untouched,
                const std::vector<std::string>& edits)
{
  const std::set<WarningKind> of_files{
      WarningKind::Crossing, WarningKind::Contradiction, WarningKind::OpeningClosed,
      WarningKind::NoSolid,  WarningKind::NotInIfc,      WarningKind::IfcLoss,
      WarningKind::Edited}; // which are told anew
  Json& all = report["edits"];
  for (const std::string& edit : edits)
    all.push_back(edit);
  std::vector<PlanWarning> kept{
      warningOf(WarningKind::Edited,
                "the plan was edited by hand: " + all.back().get<std::string>() +
                    (all.size() > 1 ? ", the last of " + std::to_string(all.size()) +
                                          " edits that report.json tells"
                                    : "") +
                    "; mesh, points and distances are those of the scan")};
  for (PlanWarning& warning : warningsIn(report)) {
    if (of_files.count(warning.kind) > 0)
      continue;
    if (warning.wall > 0) {
      const auto now = untouched.find({warning.room, warning.wall});
      if (!now)
        continue;
      warning.room = now->room;
      warning.wall = now->wall;
    }
    else if (warning.room != 0) {
      const bool is_same = untouched.isSameRoom(warning.room);
      if (!followRooms(untouched, warning))
        continue;
      if (!is_same)
        warning.note = "before the plan was edited";
    }
    kept.push_back(std::move(warning));
  }
  return kept;
}

/** @brief Keeps in a report what it tells of rooms and walls that an edit did not
 * touch: what the scan shows of them, what of them was hidden and their meshes. Walls
 * get their new numbers.
 * @param rooms of the report before
 * @param report whose part of the plan setPlan() has replaced already */
void
carryOver(const Untouched& untouched, const Json& rooms, Json& report)
{
  for (Json& room : report["rooms"])
    for (const Json& old : rooms)
      if (old.value("id", 0U) == room["id"] && untouched.isSameRoom(room["id"]))
        for (const char* kept : {"unseen_outline", "mesh"})
          room[kept] = old.value(kept, Json());
  report["walls"] = mapsOf(report["walls"], untouched);
}

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
          !isDrawing(name)) {
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
  std::string plan_text, report_text; ///< as they were read

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

  /** @brief Returns whether a file that is not written any more is a drawing, of a
   * storey or stair that is gone. */
  static bool isDrawing(const std::string& name)
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
  const Untouched untouched(before, document.plan);
  std::vector<PlanWarning> warnings = carriedWarnings(model.report, untouched, edits);
  model.files.doubted = leadingSubjects(reviewOf(document.plan, warnings).doubts);
  model.writePlan();
  const std::string ending = nextEnding(path);
  model.write("floorplan.json" + ending, model.plan_text);
  model.write("report.json" + ending, model.report_text);
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
  carryOver(untouched, rooms, model.report);
  return model.finish();
}

std::vector<std::string>
undoEdit(const std::string& path)
{
  const std::string ending = nextEnding(path).substr(1); // the one before
  EditedModel model(path, ending.empty() ? "~" : ending);
  model.files.doubted = subjectsIn(model.report);
  model.writePlan();
  model.write("floorplan.json", model.plan_text);
  return model.finish({"floorplan.json" + ending, "report.json" + ending});
}

} // namespace pcl::sedr::tools
