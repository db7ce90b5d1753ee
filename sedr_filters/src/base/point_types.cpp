// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/point_types.h>

#include <pcl/filters/impl/filter.hpp>
#include <pcl/filters/impl/filter_indices.hpp>
#include <pcl/impl/pcl_base.hpp>

// PCL has compiled base classes only for its own point types.
template class PCL_EXPORTS pcl::PCLBase<pcl::PointStructure>;
template class PCL_EXPORTS pcl::Filter<pcl::PointStructure>;
template class PCL_EXPORTS pcl::FilterIndices<pcl::PointStructure>;
