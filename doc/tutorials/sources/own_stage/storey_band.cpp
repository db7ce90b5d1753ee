// SPDX-License-Identifier: BSD-3-Clause
#include "impl/storey_band.hpp"

#include <pcl/impl/instantiate.hpp>
#include <pcl/impl/pcl_base.hpp>
#include <pcl/sedr_filters/point_types.h>

PCL_INSTANTIATE(StoreyBand, SEDR_POINT_TYPES)
