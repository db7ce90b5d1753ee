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

namespace pcl::sedr::tools {

using Reconstruction = pcl::IndoorStructureReconstruction<pcl::PointXYZ>;

/** @brief Settings from the command line; the defaults are the chain's. */
struct ModelSettings {
  explicit ModelSettings(const Reconstruction& chain);

  std::string input;               ///< name for report.json
  std::vector<std::string> inputs; ///< paths to read
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
  ScanOptions scan; ///< settings for reading, including the unit
  bool z_up;
  bool levelled;
  bool fixed_grid = false;
  bool mesh_from_plan;
  bool no_mesh = false;
  bool partial = false; ///< accept a model of a small part
  bool pictures = false;
  bool report = false;
  bool explain = false;   ///< print the priors
  std::string priors;     ///< name=value, separated by commas
  std::string prior_file; ///< lines of name = value
  IfcOptions ifc;
};

/** @brief Declares the options for making a model. */
void addModelOptions(Options& options, ModelSettings& s);

/** @brief Applies the settings to the chain. */
void apply(const ModelSettings& s, Reconstruction& chain);

} // namespace pcl::sedr::tools
