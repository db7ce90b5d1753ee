// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/impl/structure_refinement.hpp>

#include <pcl/impl/instantiate.hpp>

PCL_INSTANTIATE(StructureRefinement, SEDR_POINT_TYPES)
