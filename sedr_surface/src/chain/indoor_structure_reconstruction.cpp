// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_surface/impl/indoor_structure_reconstruction.hpp>

#include <pcl/impl/instantiate.hpp>
#include <pcl/impl/pcl_base.hpp>
#include <pcl/search/impl/search.hpp>
#include <pcl/surface/impl/reconstruction.hpp>

PCL_INSTANTIATE(IndoorStructureReconstruction, SEDR_POINT_TYPES)
