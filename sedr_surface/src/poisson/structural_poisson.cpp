// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_surface/impl/structural_poisson.hpp>

namespace pcl {

template class StructuralPoisson<pcl::PointNormal>;
template class StructuralPoisson<pcl::PointXYZRGBNormal>;
template class StructuralPoisson<pcl::PointStructure>;

} // namespace pcl
