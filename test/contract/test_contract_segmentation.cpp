// SPDX-License-Identifier: BSD-3-Clause
#include "contract/adaptors/ceiling_boundary_wall_growing.h"
#include "contract/adaptors/floorplan_fitting.h"
#include "contract/adaptors/grid_slice_detail.h"
#include "contract/adaptors/horizontal_plane_detection.h"
#include "contract/adaptors/room_segmentation.h"
#include "contract_suite.h"

namespace contract {

using SegmentationAdaptors = ::testing::Types<CeilingBoundaryWallGrowingAdaptor,
                                              SlicedCeilingBoundaryWallGrowingAdaptor,
                                              HorizontalPlaneDetectionAdaptor,
                                              RoomSegmentationAdaptor,
                                              GridSliceDetailAdaptor,
                                              FloorplanFittingAdaptor>;
INSTANTIATE_TYPED_TEST_SUITE_P(Segmentation, Contract, SegmentationAdaptors);

} // namespace contract
