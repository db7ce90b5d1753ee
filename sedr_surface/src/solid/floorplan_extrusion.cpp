// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_surface/impl/floorplan_extrusion.hpp>

namespace pcl {

template class FloorplanExtrusion<pcl::PointXYZ>;
template class FloorplanExtrusion<pcl::PointNormal>;
template class FloorplanExtrusion<pcl::PointXYZRGBNormal>;
template class FloorplanExtrusion<pcl::PointStructure>;

} // namespace pcl
