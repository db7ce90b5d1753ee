// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/impl/instantiate.hpp>
#include <pcl/sedr_filters/point_types.h>
#include <pcl/sedr_segmentation/impl/room_segmentation.hpp>

#include <cmath>

namespace pcl::sedr {

std::string
problemOf(const BuildingParameters& parameters)
{
  struct {
    const char* what;
    double value;
    const char* unit;
  } const positive[] = {
      {"the grid size", parameters.cell_size, "m"},
      {"the minimum area", parameters.minimum_area, "square metres"},
      {"the headroom", parameters.headroom, "m"},
      {"the storey step", parameters.storey_step, "m"},
  };
  for (const auto& p : positive)
    if (!(p.value > 0) || !std::isfinite(p.value))
      return std::string(p.what) + " must be above 0 " + p.unit + ", it is " +
             std::to_string(p.value);
  if (!(parameters.minimum_enclosure >= 0 && parameters.minimum_enclosure <= 1))
    return "the minimum enclosure must be within 0 and 1, it is " +
           std::to_string(parameters.minimum_enclosure);
  return {};
}

} // namespace pcl::sedr

PCL_INSTANTIATE(RoomSegmentation, SEDR_POINT_TYPES)
