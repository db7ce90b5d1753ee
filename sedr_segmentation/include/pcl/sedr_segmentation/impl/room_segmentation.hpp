// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_segmentation/room_segmentation.h>

#include <cmath>
#include <string>

namespace pcl {

template <typename PointT>
bool
RoomSegmentation<PointT>::validate()
{
  constexpr const char* name = "RoomSegmentation";
  const auto isPositive = [&](const char* what, double value, const char* unit) {
    return (value > 0 && std::isfinite(value)) ||
           fail(name, std::string(what) + " must be above 0 " + unit + ", it is " +
                          std::to_string(value));
  };
  const auto& p = parameters_;
  if (!isPositive("the grid size", p.cell_size, "m") ||
      !isPositive("the minimum area", p.minimum_area, "square metres") ||
      !isPositive("the headroom", p.headroom, "m") ||
      !isPositive("the widest door", p.widest_door, "m") ||
      !isPositive("the storey step", p.storey_step, "m"))
    return false;
  if (!(p.minimum_enclosure >= 0 && p.minimum_enclosure <= 1))
    return fail(name, "the minimum enclosure must be within 0 and 1, it is " +
                          std::to_string(p.minimum_enclosure));
  if (!(p.widest_passage >= p.widest_door) || !std::isfinite(p.widest_passage))
    return fail(name, "the widest passage, " + std::to_string(p.widest_passage) +
                          " m, must not be narrower than the widest door, " +
                          std::to_string(p.widest_door) + " m");
  const std::string problem = sedr::indicesProblem(*indices_, input_->size());
  return problem.empty() || fail(name, problem);
}

template <typename PointT>
bool
RoomSegmentation<PointT>::run()
{
  if (!validate())
    return false;
  if (indices_->empty())
    return fail("RoomSegmentation", "there are no points");
  std::string problem;
  building_ =
      sedr::findBuilding(sedr::PointView(*input_), *indices_, parameters_, problem);
  return problem.empty() || fail("RoomSegmentation", problem);
}

template <typename PointT>
bool
RoomSegmentation<PointT>::segment(std::vector<PointIndices>& rooms)
{
  rooms.clear();
  building_ = sedr::Building();
  this->clearError();
  if (!this->initCompute())
    return fail("RoomSegmentation", "no input cloud was set");
  const bool is_done = run();
  if (is_done) {
    rooms.resize(building_.rooms.size());
    for (PointIndices& room : rooms)
      room.header = input_->header;
    for (std::size_t i = 0; i < building_.room_of.size(); ++i)
      if (building_.room_of[i] != 0)
        rooms[building_.room_of[i] - 1].indices.push_back(static_cast<index_t>(i));
  }
  this->deinitCompute();
  return is_done;
}

} // namespace pcl

#define PCL_INSTANTIATE_RoomSegmentation(T)                                            \
  template class PCL_EXPORTS pcl::RoomSegmentation<T>;
