// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_surface/impl/mesh_reconstruction.hpp>

namespace pcl {
namespace sedr {

template class MeshReconstruction<pcl::PointXYZ>;
template class MeshReconstruction<pcl::PointNormal>;
template class MeshReconstruction<pcl::PointXYZRGBNormal>;
template class MeshReconstruction<pcl::PointStructure>;

} // namespace sedr
} // namespace pcl
