// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/point_types.h>

#include <pcl/filters/impl/filter_indices.hpp>
#include <pcl/impl/instantiate.hpp>
#include <pcl/impl/pcl_base.hpp>

// Base classes that PCL, or sedr_filters for PointStructure, has compiled: only those
// of other point types are made where they are used.
#ifndef PCL_ONLY_CORE_POINT_TYPES
#define PCL_INSTANTIATE_CompiledBases(T)                                               \
  extern template class pcl::PCLBase<T>;                                               \
  extern template class pcl::FilterIndices<T>;
PCL_INSTANTIATE(CompiledBases, SEDR_POINT_TYPES)
#endif
