// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/impl/pcl_bases.hpp>
#include <pcl/sedr_segmentation/room_segmentation.h>

#include <string>

namespace pcl {

template <typename PointT>
bool
RoomSegmentation<PointT>::segment(std::vector<PointIndices>& rooms)
{
  rooms.clear();
  building_ = sedr::Building();
  this->clearError();
  if (!this->initCompute())
    return fail("RoomSegmentation", "no input cloud was set");
  std::string problem = sedr::problemOf(parameters_);
  if (problem.empty())
    problem = sedr::indicesProblem(*indices_, input_->size());
  if (problem.empty() && indices_->empty())
    problem = "there are no points";
  if (problem.empty())
    building_ = sedr::findBuilding(sedr::PointView(*input_), *indices_, parameters_,
                                   problem, behind_);
  if (problem.empty()) {
    rooms.resize(building_.rooms.size());
    for (PointIndices& room : rooms)
      room.header = input_->header;
    for (std::size_t i = 0; i < building_.room_of.size(); ++i)
      if (building_.room_of[i] != 0)
        rooms[building_.room_of[i] - 1].indices.push_back(static_cast<index_t>(i));
  }
  this->deinitCompute();
  return problem.empty() || fail("RoomSegmentation", problem);
}

} // namespace pcl

#define PCL_INSTANTIATE_RoomSegmentation(T)                                            \
  template class PCL_EXPORTS pcl::RoomSegmentation<T>;
