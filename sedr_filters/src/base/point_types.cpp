// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/point_types.h>

#include <pcl/filters/impl/filter.hpp>
#include <pcl/filters/impl/filter_indices.hpp>
#include <pcl/impl/pcl_base.hpp>
#include <pcl/kdtree/impl/kdtree_flann.hpp>
#include <pcl/search/impl/kdtree.hpp>
#include <pcl/search/impl/organized.hpp>
#include <pcl/search/impl/search.hpp>

// PCL has compiled base classes and searches only for its own point types.
template class PCL_EXPORTS pcl::PCLBase<pcl::PointStructure>;
template class PCL_EXPORTS pcl::Filter<pcl::PointStructure>;
template class PCL_EXPORTS pcl::FilterIndices<pcl::PointStructure>;
template class PCL_EXPORTS pcl::KdTreeFLANN<pcl::PointStructure>;
template class PCL_EXPORTS pcl::search::Search<pcl::PointStructure>;
template class PCL_EXPORTS pcl::search::KdTree<pcl::PointStructure>;
template class PCL_EXPORTS pcl::search::OrganizedNeighbor<pcl::PointStructure>;
