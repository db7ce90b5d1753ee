// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "part_of_scan.h"
#include "rank_mail.h"

#include <pcl/sedr_surface/indoor_structure_reconstruction.h>

namespace pcl::sedr::tools {

/** @brief Thins a scan on all ranks, each its own rows. Each rank sums a range of the
 * sorted voxels and sends their means to rank 0, so no rank holds the voxel sums of
 * all.
 *
 * To be called on all ranks at the same time, each with its own order.
 * @return on rank 0 the results of ParallelVoxelGrid and ScanExcerpt for the whole
 * scan, the same bytes; empty on the others. Failures on any rank are thrown, see
 * together() */
ThinnedScan thinTogether(RankMail& mail, const ThinOrder& order, unsigned threads);

} // namespace pcl::sedr::tools
