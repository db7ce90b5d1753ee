// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/priors.h>
#include <pcl/sedr_segmentation/grid_slice_detail.h>

#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Grid-slices analysis (paper, section 2.3.1).
 *
 * Slices of the points at a quarter and a half, then at an eighth and three eighths of
 * the room's height below the ceiling are laid over the ceiling's cells; empty cells
 * that ceiling and slice enclose together, and the ceiling alone does not, are
 * structural detail if points are seen there between slice and ceiling. Beyond the
 * paper, what those points are is looked at: regions of undersides of one height, above
 * half the room's height, that join the ceiling, have floor below and are not the head
 * of a door or window are detail, whether or not an opening breaks the slice's outline;
 * empty cells that a slice encloses with them belong to them. Nothing farther than 5 m
 * beyond the ceiling's bounding box is looked at.
 *
 * @param points the scan
 * @param indices the points of the room
 * @param ceiling those of its main ceiling
 * @param slab the plane of the ceiling
 * @param floor_height z of the floor
 * @param[out] problem why nothing could be done, a sentence; empty otherwise
 * O(n log n) in the points plus the cells of their bounding box. */
SliceDetails findSliceDetails(const PointView& points,
                              const std::vector<int>& indices,
                              const std::vector<int>& ceiling,
                              const PlanSlab& slab,
                              double floor_height,
                              const SliceParameters& parameters,
                              std::string& problem);

} // namespace sedr
} // namespace pcl
