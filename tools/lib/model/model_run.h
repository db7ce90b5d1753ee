// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "colours/scan_colours.h"
#include "options.h"
#include "scan_options.h"

#include <pcl/sedr_surface/floorplan_drawing.h>
#include <pcl/sedr_surface/indoor_structure_reconstruction.h>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace pcl::sedr::tools {

using Reconstruction = pcl::IndoorStructureReconstruction<pcl::PointXYZ>;

/** @brief Settings from the command line that no stage holds. */
struct ModelSettings {
  std::vector<std::string> inputs; ///< paths to read
  std::string folder;
  ScanOptions scan; ///< settings for reading, including the unit
  ScanAssumptions known;
  unsigned threads = 0;
  bool no_mesh = false;
  bool partial = false; ///< accept a model of a small part
  bool pictures = false;
  bool report = false;
  SheetTexts texts;
  std::string priors;              ///< name=value, separated by commas
  std::string openings = "closed"; ///< or "cut": FloorplanExtrusion::setCutOpenings()
};

/** @brief Declares the options for making a model; those of stages are set in the
 * chain. */
void addModelOptions(Options& options, ModelSettings& s, Reconstruction& chain);

/** @brief Applies the settings to the chain. */
void apply(const ModelSettings& s, Reconstruction& chain);

/** @brief Makes a model folder from a scan: reads, reconstructs, measures and writes.
 * Throws ToolError on failure.
 * @param open passes the scan to the chain and returns its number of points
 * @param colours returns those of the surfaces, in the frame of the chain's results;
 * null: those of labels
 * @return the exit code */
int makeModel(const ModelSettings& settings,
              Reconstruction& chain,
              const std::function<std::size_t()>& open,
              const std::function<SurfaceColours()>& colours = nullptr);

/** @brief Does the same without writing, for a process that shares the work of
 * another. */
void helpModel(const ModelSettings& settings,
               Reconstruction& chain,
               const std::function<std::size_t()>& open);

} // namespace pcl::sedr::tools
