// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ifc_file.h"
#include "options.h"
#include "scan_options.h"

#include <pcl/sedr_surface/indoor_structure_reconstruction.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

using Reconstruction = pcl::IndoorStructureReconstruction<pcl::PointXYZ>;

/** @brief What the command line sets; the defaults are the chain's. */
struct ModelSettings {
  explicit ModelSettings(const Reconstruction& chain);

  std::string input;               ///< as report.json names it
  std::vector<std::string> inputs; ///< what is read, each path by itself
  std::string folder;
  double voxel;
  bool keep_strays = false;
  double plane_tolerance;
  double grid;
  double angle; ///< degrees
  unsigned neighbours;
  std::size_t minimum_cells;
  double boundary_tolerance;
  int depth;
  unsigned threads;
  std::uint64_t seed;
  ScanOptions scan; ///< how it is read, the unit too
  bool z_up;
  bool levelled;
  bool fixed_grid = false;
  bool mesh_from_plan;
  bool no_mesh = false;
  bool partial = false; ///< take what there is, however little
  bool pictures = false;
  bool report = false;
  bool explain = false;   ///< print the priors
  std::string priors;     ///< name=value, with commas between them
  std::string prior_file; ///< lines of name = value
  IfcOptions ifc;
};

/** @brief Declares the options that say how a model is made. */
void addModelOptions(Options& options, ModelSettings& s);

/** @brief The files of a scan as report.json names them. */
std::string joinedNames(const std::vector<std::string>& paths);

/** @brief Sets the chain as the command line says. */
void apply(const ModelSettings& s, Reconstruction& chain);

} // namespace tools
} // namespace sedr
} // namespace pcl
