// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "picture.h"

#include <pcl/sedr_filters/structure_label.h>
#include <pcl/sedr_segmentation/building.h>
#include <pcl/sedr_segmentation/floorplan_fitting.h>

#include <map>
#include <unordered_map>
#include <vector>

namespace pcl::sedr {

struct OpeningSearch;

namespace tools {

/** @brief Numbers of points in the cells of the plan, by label. */
using LabelCounts = std::map<StructureLabel, std::unordered_map<CellKey, std::size_t>>;

/** @brief Edge of the cells of LabelCounts, metres. */
constexpr double label_cell = 0.05;

/** @brief Counts the points of a scan, those without a label as StructureLabel::Other.
 */
LabelCounts labelCountsOf(const RowSource& scan);

/** @brief Draws what a stage made of a cloud: a map of every label that changed, or one
 * of all points without labels. Cells that lost all their points are dark; where the
 * label was there before, cells are the pinker the larger the share of points that
 * came. */
Picture drawLabels(const LabelCounts& before, const LabelCounts& after);

/** @brief Draws the rooms of a building, storey by storey: number and area of each
 * room, its hidden parts darker, and the heights of their ceilings. */
Picture drawRooms(const Building& building);

/** @brief Draws the result of FloorplanFitting (paper, Figure 7a): boundary points,
 * fitted lines and arcs, corners and rooms. */
Picture drawPlan(const Floorplan& plan, const std::vector<FittedBoundary>& boundaries);

/** @brief Draws the maps of the sides of walls on which OpeningDetection found
 * openings, the longest first: what was seen of each cell, and the openings. */
Picture drawOpenings(const Floorplan& plan, const OpeningSearch& search);

} // namespace tools
} // namespace pcl::sedr
