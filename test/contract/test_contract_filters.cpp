// SPDX-License-Identifier: BSD-3-Clause
#include "contract/adaptors/floor_projection_recovery.h"
#include "contract/adaptors/grid_region_outlier_removal.h"
#include "contract/adaptors/parallel_voxel_grid.h"
#include "contract/adaptors/structure_refinement.h"
#include "contract/adaptors/vertical_hole_repair.h"
#include "contract_suite.h"

namespace contract {

using FilterAdaptors = ::testing::Types<ParallelVoxelGridAdaptor,
                                        GridRegionOutlierRemovalAdaptor,
                                        OpenedGridRegionOutlierRemovalAdaptor,
                                        FloorProjectionRecoveryAdaptor,
                                        StructureRefinementAdaptor,
                                        VerticalHoleRepairAdaptor>;
INSTANTIATE_TYPED_TEST_SUITE_P(Filters, Contract, FilterAdaptors);

} // namespace contract
