// SPDX-License-Identifier: BSD-3-Clause
#include "joint_scan.h"
#include "model/model_run.h"
#include "run_tool.h"
#include "tagged_scan.h"
#include "tool_error.h"

#include "sedr_surface/src/chain/scan_voxels.h"

#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

using namespace pcl::sedr::tools;
using pcl::sedr::ScanVoxels;
using pcl::sedr::StructureModel;

namespace {

/** @brief Throws ToolError if the classified scan cannot be written, or would replace
 * the scan. */
void
checkClassified(const std::string& path, const std::vector<std::string>& inputs)
{
  checkTaggedOutput(path);
  std::error_code error;
  for (const std::string& input : scanFilesOf(inputs))
    if (std::filesystem::equivalent(path, input, error))
      throw ToolError("'" + path + "' is the scan itself: give another name");
}

/** @brief Writes the scan with what its points were found to be. */
void
saveClassified(const std::string& path,
               const JointScan& scan,
               const Reconstruction& chain)
{
  const Progress progress("writing the classified scan");
  const StructureModel& model = chain.getModel();
  const ScanVoxels voxels(model, chain.getVoxelSize());
  const auto tag_of = [&](const Eigen::Vector3f& p) {
    const std::size_t i = voxels.of(p);
    return i < model.labels.size()
               ? PointTag{model.labels[i], model.rooms[i], model.owners[i]}
               : PointTag();
  };
  saveTagged(path, scan, tag_of, chain.getNumberOfThreads());
}

} // namespace

int
main(int argc, char** argv)
{
  Reconstruction chain;
  ModelSettings settings;
  std::string classified;
  std::string colours = "scan";
  Options options(
      "pcl_sedr",
      "Reconstructs ceiling, floor and walls of an indoor scan as one closed mesh a "
      "room.\nWrites structure.pcd, mesh.ply, solid.ply, .obj, model.glb, .ifc, "
      "floorplan.json, .svg, .pdf, .dxf, report.json and schedules (rooms.csv, "
      "openings.csv, walls.csv); of several storeys one drawing each, "
      "floorplan_1.svg, ...");
  options.files(
      "INPUT", settings.inputs,
      "PCD, PLY, E57, LAS or text, z up, or a folder of them; several are one "
      "scan; - is the standard input");
  options.file("OUTPUT_DIR", settings.folder,
               "folder for the results, made if missing");
  addModelOptions(options, settings, chain);
  options.flag("pictures", settings.pictures,
               "write pictures of the rooms and the fitted plan to "
               "OUTPUT_DIR/pictures");
  options.text("classified", classified,
               "write the whole scan to this .las or .pcd, each point with label, room "
               "and owner, in LAS with the class of ASPRS");
  options.text("colours", colours,
               "of mesh.ply, model.glb and structure.pcd: those of the scan if it has "
               "any, or those of the labels",
               {"scan", "label"});
  return runTool(options, argc, argv, [&] {
    if (!classified.empty())
      checkClassified(classified, settings.inputs);
    apply(settings, chain);
    std::shared_ptr<const JointScan> scan;
    const auto open = [&] {
      // Everything but the headers is read during thinning.
      scan = std::make_shared<JointScan>(settings.inputs, settings.scan.resolved());
      chain.setInputSource(scan);
      chain.setOrigin(scan->origin());
      chain.setScanPositions(scan->positions());
      return scan->size();
    };
    const auto seen = [&] {
      return colours == "scan" && scan->hasColours()
                 ? coloursOf(*scan, chain.getModel(),
                             chain.getStages().poisson.getMesh(),
                             chain.getStages().extrusion.getMesh(), settings.threads)
                 : SurfaceColours();
    };
    const int code = makeModel(settings, chain, open, seen);
    if (!classified.empty())
      saveClassified(classified, *scan, chain);
    return code;
  });
}
