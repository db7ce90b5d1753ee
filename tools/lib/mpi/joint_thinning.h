// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "part_of_scan.h"
#include "rank_mail.h"

#include <pcl/sedr_surface/indoor_structure_reconstruction.h>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief Thins a scan on all ranks, each its own rows. Voxels are added up by those
 * that are in charge of them, a stretch of the sorted voxels each, which sends their
 * means to rank 0: nobody holds what all ranks have counted.
 *
 * To be called by all ranks at the same time, each with its own order.
 * @return on rank 0 what ParallelVoxelGrid and ScanExcerpt make of the whole scan, the
 * same bytes; nothing on the others. What fails on any rank is thrown, see together()
 */
ThinnedScan thinTogether(RankMail& mail, const ThinOrder& order, unsigned threads);

} // namespace tools
} // namespace sedr
} // namespace pcl
