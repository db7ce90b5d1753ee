// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "joint_scan.h"
#include "ranks.h"

#include <pcl/sedr_surface/indoor_structure_reconstruction.h>
#include <pcl/sedr_surface/structural_poisson.h>

namespace pcl::sedr::tools {

/** @brief Thins a scan on all ranks, each an equal run of its rows: the sums of their
 * voxels are added up, and every rank gets the means and the excerpt, the same bytes as
 * in one process. To be called on all ranks at the same time.
 * @param find_frame gives all ranks the same frame
 * @param grid its leaf, strays and threads */
ThinnedScan thinTogether(const Ranks& ranks,
                         const JointScan& scan,
                         const ParallelVoxelGrid<pcl::PointXYZ>& grid,
                         const FindFrame& find_frame);

/** @brief Deals the rooms out by number, and gathers their surfaces at rank 0. */
RoomSharing sharedRooms(const Ranks& ranks);

} // namespace pcl::sedr::tools
