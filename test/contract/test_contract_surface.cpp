// SPDX-License-Identifier: BSD-3-Clause
#include "contract/adaptors/floorplan_extrusion.h"
#include "contract/adaptors/indoor_structure_reconstruction.h"
#include "contract/adaptors/structural_poisson.h"
#include "contract_suite.h"

namespace contract {

using SurfaceAdaptors = ::testing::Types<StructuralPoissonAdaptor,
                                         FloorplanExtrusionAdaptor,
                                         IndoorStructureReconstructionAdaptor>;
INSTANTIATE_TYPED_TEST_SUITE_P(Surface, Contract, SurfaceAdaptors);

} // namespace contract
