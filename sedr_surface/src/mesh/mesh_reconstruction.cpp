// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/impl/instantiate.hpp>
#include <pcl/sedr_filters/point_types.h>
#include <pcl/sedr_surface/impl/mesh_reconstruction.hpp>

PCL_INSTANTIATE(MeshReconstruction, SEDR_POINT_TYPES)
