// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room_points.h"

#include <pcl/sedr_segmentation/room_segmentation.h>

#include <cstddef>
#include <string>
#include <vector>

namespace sedr_test {

/** The levels of a scan and the rooms that they are parted into. */
struct SegmentedRooms {
  std::vector<pcl::sedr::Level> levels;
  std::vector<pcl::sedr::RoomRegion> regions;
  std::string problem;

  explicit SegmentedRooms(const RoomPoints& points,
                          const pcl::sedr::RoomParameters& parameters = {})
  {
    const pcl::sedr::LevelParameters level_parameters;
    levels = pcl::sedr::findLevels(points.view(), points.all(), level_parameters);
    pcl::sedr::classifyLevels(levels, level_parameters);
    pcl::sedr::collectInliers(levels, points.view(), points.all(), level_parameters);
    regions = pcl::sedr::segmentRooms(points.view(), points.all(), levels, parameters,
                                      problem);
  }

  double area(std::size_t room) const
  {
    return static_cast<double>(regions.at(room).scope.size()) * 0.0025;
  }

  double ceilingOf(std::size_t room) const
  {
    return levels[regions.at(room).ceiling_level].slab.heightAt({0, 0});
  }

  double floorOf(std::size_t room) const
  {
    return levels[regions.at(room).floor_level].slab.heightAt({0, 0});
  }

  /** Position of the room above a place, -1 for none. */
  int at(double x, double y) const
  {
    for (std::size_t r = 0; r < regions.size(); ++r)
      if (regions[r].scope.contains(pcl::sedr::CellGrid(0.05).at(x, y)))
        return static_cast<int>(r);
    return -1;
  }
};

} // namespace sedr_test
