// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_surface/impl/indoor_structure_reconstruction.hpp>

#include <pcl/impl/instantiate.hpp>

PCL_INSTANTIATE(IndoorStructureReconstruction, SEDR_POINT_TYPES)
