// SPDX-License-Identifier: BSD-3-Clause
#include "report_settings.h"

#include <pcl/common/angles.h>
#include <pcl/sedr_filters/priors.h>

#include <boost/algorithm/string/join.hpp>

#include <filesystem>

namespace pcl::sedr::tools {

namespace {

using Json = nlohmann::ordered_json;
using Reconstruction = IndoorStructureReconstruction<pcl::PointXYZ>;

/** @brief Returns the names of files or folders, not where on the disk they are. */
std::string
namesOf(const std::vector<std::string>& paths)
{
  std::vector<std::string> names;
  for (const auto& path : paths)
    names.push_back((std::filesystem::absolute(path) / "")
                        .lexically_normal()
                        .parent_path()
                        .filename());
  return boost::join(names, ", ");
}

} // namespace

Json
inputOf(const RunRecord& run)
{
  const ScanSettings& reading = run.reading;
  Json input{{"path", namesOf(run.inputs)},
             {"points", run.points},
             {"unit", reading.unit}};
  if (!reading.up.empty())
    input["up"] = reading.up;
  if (reading.scan > 0)
    input["scan"] = reading.scan;
  if (reading.skip_broken)
    input["skip_broken"] = true;
  if (!reading.columns.empty())
    input["columns"] = reading.columns;
  return input;
}

Json
parametersOf(const RunRecord& run, const Reconstruction& chain)
{
  const ChainStages& c = chain.getStages();
  return {{"unit", run.reading.unit},
          {"z_up", chain.getAssumptions().trust_up},
          {"levelled", chain.getAssumptions().keep_levelled},
          {"threads", chain.getNumberOfThreads()},
          {"seed", chain.getSeed()},
          {"voxel_size", chain.getVoxelSize()},
          {"plane_tolerance", chain.getPlaneTolerance()},
          {"maximum_tilt_degrees", pcl::rad2deg(c.plane_detection.getMaximumTilt())},
          {"grid_size", chain.getGridSize()},
          {"minimum_room_area", c.room_segmentation.getMinimumArea()},
          {"headroom", c.room_segmentation.getHeadroom()},
          {"minimum_enclosure", c.room_segmentation.getMinimumEnclosure()},
          {"storey_step", c.room_segmentation.getStoreyStep()},
          {"boundary_angle_degrees", pcl::rad2deg(chain.getBoundaryAngle())},
          {"boundary_neighbors", chain.getBoundaryNeighbors()},
          {"wall_distance", c.wall_growing.getDistanceThreshold()},
          {"boundary_tolerance", chain.getBoundaryTolerance()},
          {"refinement_distance", c.refinement.getMaximumDistance()},
          {"repair_grid_size", c.hole_repair.getGridSize()},
          {"chord_tolerance", c.extrusion.getChordTolerance()},
          {"cut_openings", c.extrusion.getCutOpenings()},
          {"tree_depth", c.poisson.getDepth()}};
}

Json
priorsOf(const Reconstruction& chain)
{
  Json priors = Json::array();
  for (const Prior& prior : priorTable())
    priors.push_back({{"name", prior.name},
                      {"value", chain.getPriors().*prior.member},
                      {"unit", prior.unit},
                      {"low", prior.low},
                      {"high", prior.high},
                      {"source", prior.source}});
  return priors;
}

} // namespace pcl::sedr::tools
