// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contract/contract.h"

#include <pcl/sedr_segmentation/room_segmentation.h>

namespace contract {

/** The size is the number of points of all ceilings and floors. Not applicable: it
 * writes no cloud and removes no points. */
class RoomSegmentationAdaptor : public AdaptorDefaults {
public:
  static constexpr bool finds_in_one_point = false;
  static constexpr int spoils = 14;

  void setInput(const Cloud::ConstPtr& cloud) { segmentation_.setInputCloud(cloud); }

  void setIndices(const pcl::IndicesPtr& indices) { segmentation_.setIndices(indices); }

  void setThreads(unsigned threads) { segmentation_.setNumberOfThreads(threads); }

  void mend()
  {
    segmentation_.setGridSize(0.05);
    segmentation_.setMinimumArea(1);
    segmentation_.setHeadroom(1.8);
    segmentation_.setMinimumEnclosure(0.4);
    segmentation_.setWidestDoor(1.6);
    segmentation_.setWidestPassage(4);
    segmentation_.setStoreyStep(1.6);
  }

  void spoil(int which)
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double inf = std::numeric_limits<double>::infinity();
    const double values[] = {0,    nan, -1, inf, 0,   nan, -0.1,
                             1.01, 0,   5,  1.5, inf, 0,   -1.6};
    const double value = values[which];
    switch (which / 2) {
    case 0:
      return segmentation_.setGridSize(value);
    case 1:
      return segmentation_.setMinimumArea(value);
    case 2:
      return segmentation_.setHeadroom(value);
    case 3:
      return segmentation_.setMinimumEnclosure(value);
    case 4:
      return segmentation_.setWidestDoor(value); // wider than a passage
    case 5:
      return segmentation_.setWidestPassage(value); // narrower than a door
    default:
      return segmentation_.setStoreyStep(value);
    }
  }

  Outcome run()
  {
    std::vector<pcl::PointIndices> rooms(3);
    segmentation_.segment(rooms);
    const pcl::sedr::Building& building = segmentation_.getBuilding();
    Outcome outcome;
    outcome.error = segmentation_.getErrorMessage();
    for (const auto& room : rooms) {
      outcome.size += room.indices.size();
      append(outcome.all, room.indices);
      if (segmentation_.getInputCloud())
        append(outcome.geometry, Cloud(*segmentation_.getInputCloud(), room.indices));
    }
    append(outcome.geometry, building.storeys.size());
    for (const auto& room : building.rooms) {
      for (const double value : {room.floor, room.ceiling, room.area, room.enclosure})
        append(outcome.geometry, value);
      append(outcome.geometry, room.id);
      append(outcome.geometry, room.storey);
      append(outcome.geometry, room.columns.size());
    }
    append(outcome.all, building.room_of);
    append(outcome.all, building.label_of);
    outcome.all += outcome.geometry;
    return outcome;
  }

private:
  pcl::RoomSegmentation<pcl::PointXYZ> segmentation_;
};

} // namespace contract
