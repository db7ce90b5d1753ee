// SPDX-License-Identifier: BSD-3-Clause
#include "model_run.h"

#include "bytes/whole_file.h"
#include "formats/scan_formats.h"
#include "joint_scan.h"
#include "output_folder.h"
#include "report.h"
#include "report/report_page.h"
#include "run_tool.h"
#include "solid_files.h"
#include "stage_pictures.h"
#include "tool_cloud.h"
#include "tool_error.h"

#include "sedr_filters/src/base/number_text.h"
#include "sedr_filters/src/base/parallel.h"
#include "sedr_surface/src/sheet/sheet.h"
#include <pcl/sedr_filters/impl/refinement.h>
#include <pcl/sedr_surface/mesh_evaluation.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <boost/crc.hpp>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>
#include <vector>

namespace pcl::sedr::tools {

namespace {

constexpr const char* rooms_picture = "pictures/room_segmentation.png";
constexpr const char* plan_picture = "pictures/floorplan_fitting.png";

/** @brief Returns the names of the files that a run writes, without those of several
 * storeys. */
std::vector<std::string>
outputNames(const ModelSettings& settings)
{
  std::vector<std::string> names = planFileNames();
  names.insert(names.end(), {"structure.pcd", "report.json"});
  if (!settings.no_mesh)
    names.push_back("mesh.ply");
  if (settings.report)
    names.push_back("report.html");
  if (settings.pictures)
    names.insert(names.end(), {rooms_picture, plan_picture});
  return names;
}

/** @brief Runs a step that is not a stage of the chain, with progress. The step fills
 * in the points of its report. */
StageReport
timed(const std::string& name, const std::function<void(StageReport&)>& step)
{
  const Progress progress(name);
  StageReport report{name};
  const auto start = std::chrono::steady_clock::now();
  step(report);
  report.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

/** @brief Returns whether the unit of the scan needs no doubt: the user named it, or
 * the files are E57, whose unit is the metre by its standard. */
bool
knowsUnit(const ModelSettings& settings)
{
  const std::vector<std::string> files = scanFilesOf(settings.inputs);
  return settings.scan.settings.unit ||
         std::all_of(files.begin(), files.end(), [](const std::string& file) {
           return looksLikeE57(InputFile(file));
         });
}

/** @brief Returns the coverage. Throws ToolError if less than half of the scanned floor
 * is in the plan, unless a partial model is allowed. */
Coverage
checkedCoverage(const Reconstruction& chain, bool takes_partial)
{
  constexpr double least = 0.5;
  const StructureModel& model = chain.getModel();
  const Coverage& coverage = model.coverage;
  if (coverage.share() >= least || takes_partial)
    return coverage;
  const auto gap = coverageWarning(coverage);
  std::string reason = gap ? sentenceOf(*gap) : "";
  if (!model.unit_doubt.empty())
    reason += "; " + model.unit_doubt;
  for (const PlanWarning& warning : model.warnings)
    if (warning.kind == WarningKind::Up)
      reason += "; " + sentenceOf(warning);
  throw ToolError("less than half of the floor that was seen could be modelled: " +
                      reason + "; say --partial for a model of what there is",
                  NothingFound);
}

/** @brief Runs the chain with progress. Throws ToolError that names the failed
 * stage. */
void
reconstruct(const ModelSettings& settings, Reconstruction& chain, RunRecord& record)
{
  ScanAssumptions known = settings.known;
  known.unit_is_known = knowsUnit(settings);
  known.up_is_known = !settings.scan.settings.up.empty();
  chain.setAssumptions(known);
  std::unique_ptr<Progress> progress;
  chain.setStageCallback([&](const std::string& stage) {
    progress.reset(); // ends the line before the next one
    progress = std::make_unique<Progress>(stage);
    return true;
  });
  bool is_done = chain.findStructure();
  if (is_done) {
    progress.reset();
    record.coverage = checkedCoverage(chain, settings.partial);
    is_done = settings.no_mesh || chain.makeMesh();
  }
  chain.setStageCallback(nullptr); // it refers to `progress`, which ends here
  progress.reset();
  record.warnings = chain.getModel().warnings;
  if (!is_done)
    throw ToolError(chain.getModel().failed_stage == "input"
                        ? chain.getErrorMessage()
                        : "no structure found: " + chain.getErrorMessage(),
                    NothingFound);
}

/** @brief Measures distances of the labelled scan points, before refinement, from the
 * mesh; not those in openings and on their reveals, for the mesh closes openings. */
MeshEvaluationResult
evaluate(const Reconstruction& chain, unsigned threads, StageReport& report)
{
  const StructureModel& result = chain.getModel();
  constexpr double reveal = 0.05; // metres: what noise makes of its points
  const std::size_t scanned = result.cloud->size();
  const OpeningSpaces openings(*chain.getFloorplan());
  std::vector<std::uint8_t> is_structure(scanned);
  parallelFor(scanned, 4096, threads, [&](std::size_t i) {
    const Eigen::Vector3d place = (*result.cloud)[i].getVector3fMap().cast<double>();
    is_structure[i] = result.labels[i] != 0 && !openings.contains(place, reveal);
  });
  pcl::IndicesPtr structure(new pcl::Indices);
  for (std::size_t i = 0; i < scanned; ++i)
    if (is_structure[i])
      structure->push_back(static_cast<int>(i));
  pcl::MeshEvaluation evaluation;
  const std::shared_ptr<const TriangleMesh> mesh(
      std::shared_ptr<void>(),
      &chain.getStages().poisson.getMesh()); // not owned, to avoid a copy
  evaluation.setInputMesh(mesh);
  evaluation.setInputCloud(result.cloud);
  evaluation.setIndices(structure);
  evaluation.setNumberOfThreads(threads);
  MeshEvaluationResult figures;
  if (!evaluation.compute(figures))
    throw ToolError(evaluation.getErrorMessage(), NothingFound);
  report.points_in = structure->size();
  report.points_out = structure->size() - figures.skipped_points;
  return figures;
}

/** @brief Returns a check sum of the thinned scan. */
std::string
scanSum(const StructureModel& model)
{
  boost::crc_optimal<64, 0x42f0e1eba9ea3693> sum; // of ECMA-182
  for (const auto& point : *model.cloud)
    sum.process_bytes(point.data, 3 * sizeof(float));
  return formatText("%016llx", static_cast<unsigned long long>(sum.checksum()));
}

/** @brief Writes the points and the mesh. */
void
writePoints(const OutputFolder& folder,
            const Reconstruction& chain,
            const SurfaceColours& colours,
            const ModelSettings& settings)
{
  const StructureModel& model = chain.getModel();
  const Origin& origin = chain.getOrigin();
  std::vector<std::array<std::uint8_t, 5>> of_points;
  for (const auto& [rgb, is_seen] :
       colours.of(placesOf(*model.structure), settings.threads))
    of_points.push_back({rgb[2], rgb[1], rgb[0], 255, is_seen});
  saveStructure(folder.file("structure.pcd"), *model.structureInScanFrame(), origin,
                of_points);
  if (settings.no_mesh)
    return;
  const TriangleMesh& mesh = chain.getStages().poisson.getMesh();
  const std::vector<SeenColour> of_mesh =
      colours.of(verticesOf(mesh), settings.threads);
  writeWhole(folder.file("mesh.ply"),
             model.isMoved() // otherwise no copy is needed
                 ? meshToPly(chain.meshInScanFrame(), originComments(origin), of_mesh)
                 : meshToPly(mesh, originComments(origin), of_mesh));
}

PlanFiles
planFiles(const ModelSettings& settings,
          const Reconstruction& chain,
          const SurfaceColours& colours)
{
  const StructureModel& model = chain.getModel();
  const auto& extrusion = chain.getStages().extrusion;
  return {{*model.plan, chain.getOrigin(), model.levelling, chain.getPriors().max_wall,
           scanSum(model)},
          model.inScanFrame(extrusion.getMesh()),
          extrusion.getElements(),
          colours.ofElements(extrusion.getMesh(), extrusion.getElements().size(),
                             settings.threads),
          settings.texts,
          settings.threads};
}

void
writePictures(const OutputFolder& folder, const Reconstruction& chain)
{
  const ChainStages& stages = chain.getStages();
  const StructureModel& model = chain.getModel();
  writeWhole(folder.file(rooms_picture),
             drawRooms(stages.room_segmentation.getBuilding()).png());
  const BuildingFrame to_building = model.levelFrame().to(model.frame);
  const Floorplan plan = moved(*model.plan, to_building.yaw(),
                               to_building.toBuilding(Eigen::Vector3d::Zero()));
  writeWhole(folder.file(plan_picture),
             drawPlan(plan, stages.floorplan_fitting.getBoundaries()).png());
}

/** @brief Writes report.html from the model's files, which must exist.
 * @return why it could not, or an empty text: the model is good without it */
std::string
writeReportPage(const ModelSettings& settings, const OutputFolder& folder)
{
  const Progress progress("writing the page");
  PageSettings page;
  page.name = (std::filesystem::absolute(settings.folder) / "")
                  .lexically_normal()
                  .parent_path()
                  .filename();
  std::error_code error; // the page cannot show a scan of several files
  if (settings.inputs.size() == 1 &&
      std::filesystem::is_regular_file(settings.inputs.front(), error))
    page.scan = settings.inputs.front();
  try {
    writePage(std::filesystem::path(folder.file("")).string(), page);
  }
  catch (const ToolError& problem) {
    return std::string("the model is complete, but not its page: ") + problem.what();
  }
  return {};
}

} // namespace

int
makeModel(const ModelSettings& settings,
          Reconstruction& chain,
          const std::function<std::size_t()>& open,
          const std::function<SurfaceColours()>& colours)
{
  if (settings.no_mesh && settings.report)
    throw ToolError("--report shows the mesh, which --no-mesh leaves out");
  OutputFolder folder(settings.folder, scanFilesOf(settings.inputs));
  folder.check(outputNames(settings));
  loadFonts();
  RunRecord record;
  record.inputs = settings.inputs;
  record.reading = settings.scan.settings;
  record.texts = settings.texts;
  const StageReport reading = timed("reading", [&](StageReport& report) {
    record.points = report.points_in = report.points_out = open();
  });
  reconstruct(settings, chain, record);
  if (const auto gap = coverageWarning(record.coverage))
    record.warnings.push_back(*gap);
  record.stages = chain.getModel().reports;
  record.stages.insert(record.stages.begin(), reading);
  if (!settings.no_mesh)
    record.stages.push_back(timed("MeshEvaluation", [&](StageReport& report) {
      record.figures = evaluate(chain, settings.threads, report);
    }));
  SurfaceColours seen;
  const StageReport colouring = timed("colours", [&](StageReport& report) {
    seen = colours ? colours() : SurfaceColours();
    report.points_in = record.points;
    report.points_out = chain.getModel().cloud->size();
  });
  if (!seen.empty())
    record.stages.push_back(colouring);
  record.stages.push_back(timed("writing", [&](StageReport& report) {
    PlanFiles of_plan = planFiles(settings, chain, seen);
    of_plan.doubted =
        leadingSubjects(reviewOf(of_plan.document.plan, record.warnings).doubts);
    IfcModel ifc;
    const std::function<void()> files[] = {
        [&] { writePoints(folder, chain, seen, settings); },
        [&] { writeSolids(folder, of_plan); },
        [&] { ifc = writeBuildingModel(folder, of_plan); },
        [&] { writeDrawings(folder, of_plan); }, [&] { writePictures(folder, chain); }};
    parallelBlocks(settings.pictures ? 5 : 4, 1, settings.threads,
                   [&](std::size_t k, std::size_t) { files[k](); });
    record.schedules = ifc.schedules;
    record.warnings.insert(record.warnings.end(), ifc.warnings.begin(),
                           ifc.warnings.end());
    report.points_in = report.points_out = chain.getStructure()->size();
  }));
  record.files = folder.written();
  record.files.emplace_back("report.json");
  if (settings.report)
    record.files.emplace_back("report.html");
  PlanReview review;
  writeWhole(folder.file("report.json"), makeReport(record, chain, review));
  std::string problem;
  if (settings.report)
    problem = writeReportPage(settings, folder);
  std::vector<std::string> told = review.remarks;
  for (std::string& line : firstOf(review.doubts))
    told.push_back(std::move(line));
  const std::string summary = summaryOf(record, chain) + "\n" + review.text;
  folder.exchange(); // what follows needs no memory to speak of
  for (const std::string& line : told)
    warn(line);
  std::cout << summary << std::endl;
  if (!problem.empty())
    throw ToolError(problem);
  return Done;
}

void
helpModel(const ModelSettings& settings,
          Reconstruction& chain,
          const std::function<std::size_t()>& open)
{
  open();
  RunRecord record;
  reconstruct(settings, chain, record);
}

} // namespace pcl::sedr::tools
