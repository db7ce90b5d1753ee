// SPDX-License-Identifier: BSD-3-Clause
#include "contract/adaptors/ceiling_boundary_wall_growing.h"
#include "contract/contract_suite.h"

namespace contract {

using SegmentationAdaptors = ::testing::Types<CeilingBoundaryWallGrowingAdaptor,
                                              SlicedCeilingBoundaryWallGrowingAdaptor>;
INSTANTIATE_TYPED_TEST_SUITE_P(Segmentation, Contract, SegmentationAdaptors);

} // namespace contract
