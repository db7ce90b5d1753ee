// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/priors.h>
#include <pcl/sedr_segmentation/grid_slice_detail.h>

#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief Grid-slices analysis (paper, section 2.3.1).
 *
 * Slices at 1/4 and 1/2, then at 1/8 and 3/8 of the room height below the ceiling are
 * overlaid on the ceiling's cells. Empty cells enclosed by ceiling and slice together,
 * but not by the ceiling alone, are structural detail if points lie between slice and
 * ceiling. Beyond the paper, detail consists of regions of undersides of one height
 * above half the room height. They must adjoin the ceiling, have floor below and not be
 * the head of a door or window; an opening in the slice's outline does not matter.
 * Empty cells that a slice encloses with them belong to them. Points more than 5 m
 * beyond the ceiling's bounding box are ignored.
 *
 * @param points the scan
 * @param indices the points of the room
 * @param ceiling the points of its main ceiling
 * @param slab the plane of the ceiling
 * @param floor_height z of the floor
 * @param[out] problem the reason for a failure, a sentence; else empty. O(n log n) in
 * the points plus the cells of their bounding box. */
SliceDetails findSliceDetails(const PointView& points,
                              const std::vector<int>& indices,
                              const std::vector<int>& ceiling,
                              const PlanSlab& slab,
                              double floor_height,
                              const SliceParameters& parameters,
                              std::string& problem);

} // namespace pcl::sedr
