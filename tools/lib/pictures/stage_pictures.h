// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bytes/whole_file.h"
#include "options.h"
#include "picture.h"
#include "tool_cloud.h"

#include <pcl/sedr_filters/point_types.h>
#include <pcl/sedr_segmentation/building.h>
#include <pcl/sedr_segmentation/floorplan_fitting.h>

#include <array>
#include <string>
#include <unordered_map>
#include <vector>

namespace pcl::sedr {

struct OpeningSearch;

namespace tools {

/** @brief Numbers of points by label, before and after a stage. */
using LabelCounts = std::array<std::array<std::size_t, 6>, 2>;

/** @brief What a stage made of a cloud, by cells of the plan. */
using CellChanges = std::unordered_map<CellKey, LabelCounts>;

/** @brief Edge of the cells of CellChanges, metres. */
constexpr double label_cell = 0.05;

/** @brief Counts the points of a scan, those without a label as StructureLabel::Other.
 * @param when 0 before, 1 after the stage */
void countLabels(const RowSource& scan, std::size_t when, CellChanges& changes);

/** @brief Draws what a stage made of a cloud: a map of every label that changed, or one
 * of all points without labels. Cells that lost all their points are dark; where the
 * label was there before, cells are the pinker the larger the share of points that
 * came. */
Picture drawLabels(const CellChanges& changes);

/** @brief Draws the rooms of a building, storey by storey: number and area of each
 * room, its hidden parts darker, and the heights of their ceilings. */
Picture drawRooms(const Building& building);

/** @brief Draws the result of FloorplanFitting (paper, Figure 7a): boundary points,
 * fitted lines and arcs, corners and rooms. */
Picture drawPlan(const Floorplan& plan, const std::vector<FittedBoundary>& boundaries);

/** @brief Draws the maps of the sides of walls on which OpeningDetection found
 * openings, the longest first: what was seen of each cell, and the openings. */
Picture drawOpenings(const Floorplan& plan, const OpeningSearch& search);

/** @brief The picture that a program is asked for by --picture. */
struct PictureFile {
  std::string path; ///< empty: none

  void declare(Options& options)
  {
    options.text("picture", path, "PNG file for a picture of what was decided");
  }

  /** @brief Throws ToolError if the file cannot be written or does not end in .png. To
   * be called before the work. */
  void check() const;

  /** @brief Writes what `draw` returns, completely or not at all, if it is asked for.
   */
  template <typename Draw>
  void write(Draw draw) const
  {
    if (!path.empty())
      writeWhole(path, draw().png());
  }
};

/** @brief The files of a stage's program: a cloud in, one out, and a picture. */
struct StageFiles {
  std::string input;
  std::string output;
  PictureFile picture;

  /** @brief Declares INPUT, OUTPUT and --picture.
   * @param plan gets PLAN.json, which is between them, if given */
  void declare(Options& options, const std::string& help, std::string* plan = nullptr);

  /** @brief Throws ToolError if an output cannot be written. To be called before the
   * work. */
  void check() const;

  /** @brief Writes the cloud, and the picture of what became of the input.
   * @param reading of the input */
  void save(const ToolCloud& cloud, const ScanSettings& reading = {}) const;
};

} // namespace tools
} // namespace pcl::sedr
