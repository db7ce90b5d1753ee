// SPDX-License-Identifier: BSD-3-Clause
#include "joint_scan.h"
#include "model/model_run.h"
#include "run_tool.h"
#include "tagged_scan.h"
#include "tool_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

using namespace pcl::sedr::tools;
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

/** @brief Finds the point of a thinned scan that a point of the scan went into. */
class ScanVoxels {
public:
  /** @param model outlives this object
   * @param leaf edge of its voxels, metres */
  ScanVoxels(const StructureModel& model, double leaf)
      : model_(model)
      , to_building_(model.levelFrame().to(model.frame))
      , leaf_(leaf)
  {
    for (std::size_t i = 0; i < model.cloud->size(); ++i)
      points_.emplace_back(voxelOf(meanOf(i)), i);
    std::sort(points_.begin(), points_.end());
  }

  /** @brief Returns the index of the thinned point; that of none of them, the number of
   * thinned points, for strays, reflections and points that are not finite. O(log n),
   * thread-safe.
   * @param p in the frame of the scan */
  std::size_t of(const Eigen::Vector3f& p) const
  {
    const std::size_t none = points_.size();
    constexpr float far = 1e7F; // metres, beyond voxels
    if (!(p.cwiseAbs().maxCoeff() < far))
      return none;
    const Voxel voxel = voxelOf(model_.frame.toBuilding(p.cast<double>()));
    const auto at = [&](const Voxel& v) {
      const auto found = std::lower_bound(points_.begin(), points_.end(),
                                          std::pair(v, std::size_t{0}));
      return found != points_.end() && found->first == v ? found->second : none;
    };
    if (const std::size_t own = at(voxel); own != none)
      return own;
    // The mean of a voxel may have been rounded beyond its border.
    constexpr double rounding = 1e-4; // metres
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const int step : {-1, 1}) {
        Voxel beside = voxel;
        beside[axis] += step;
        const std::size_t near = at(beside);
        const double border = leaf_ * (voxel[axis] + (step < 0 ? 0 : 1));
        if (near != none &&
            std::abs(meanOf(near)[static_cast<Eigen::Index>(axis)] - border) < rounding)
          return near;
      }
    return none;
  }

private:
  using Voxel = std::array<std::int32_t, 3>;

  Voxel voxelOf(const Eigen::Vector3d& p) const
  {
    const Eigen::Array3i voxel = (p.array() / leaf_).floor().cast<std::int32_t>();
    return {voxel.x(), voxel.y(), voxel.z()};
  }

  Eigen::Vector3d meanOf(std::size_t point) const
  {
    return to_building_.toBuilding(
        (*model_.cloud)[point].getVector3fMap().cast<double>());
  }

  const StructureModel& model_;
  pcl::sedr::BuildingFrame to_building_; ///< from that of the results
  double leaf_;
  std::vector<std::pair<Voxel, std::size_t>> points_; ///< sorted
};

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
