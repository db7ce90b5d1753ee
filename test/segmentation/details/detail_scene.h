// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room_points.h"

#include "sedr_segmentation/src/details/slice_detail.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <vector>

/** @file Rooms with details, whose points are known. */

namespace sedr_test {

inline constexpr double height = 2.5;

/** 5 m x 4 m x 2.5 m. */
inline pcl::sedr::PlanRoom
plainRoom()
{
  return roomOf(rectangle(0.01, 0.01, 5.01, 4.01), height);
}

/** The plain room with a soffit 0.6 m wide along two walls. */
inline pcl::sedr::PlanRoom
soffitRoom(double drop)
{
  pcl::sedr::PlanRoom room = plainRoom();
  room.details = {detailOf(polygon({{0.01, 0.01},
                                    {5.01, 0.01},
                                    {5.01, 0.61},
                                    {0.61, 0.61},
                                    {0.61, 4.01},
                                    {0.01, 4.01}}),
                           height - drop)};
  return room;
}

/** The points of a room and the result of the analysis. */
struct DetailScene {
  RoomPoints points;
  RoomParts parts;

  explicit DetailScene(const pcl::sedr::PlanRoom& room, double noise = 0)
      : points(0.05, noise)
  {
    parts = points.room(room);
  }

  DetailScene(const pcl::sedr::PlanRoom& room, const RoomPoints::InSpace& keep)
  {
    parts = points.room(room, keep);
  }

  pcl::sedr::SliceDetails find(const pcl::sedr::SliceParameters& parameters = {}) const
  {
    std::string problem;
    const pcl::sedr::SliceDetails details =
        pcl::sedr::findSliceDetails(points.view(), points.all(), parts.ceiling,
                                    slabAt(height), 0, parameters, problem);
    EXPECT_EQ(problem, "");
    return details;
  }

  /** Returns the detail points in cells without wall and main ceiling. */
  std::vector<int> clearDetails() const
  {
    const pcl::sedr::CellGrid grid(0.05);
    const pcl::sedr::CellSet others =
        pcl::sedr::CellSet(grid, points.view(), joined(parts.walls, parts.ceiling));
    std::vector<int> clear;
    for (const int i : parts.details)
      if (!others.contains(grid.at(points[i].x(), points[i].y())))
        clear.push_back(i);
    return clear;
  }
};

/** Expects that all clear detail points but a share `missing` were found, and nothing
 * else except wall points above the room's middle. */
inline void
expectFound(const DetailScene& scene,
            const pcl::sedr::SliceDetails& details,
            double missing = 0.005)
{
  const auto clear = scene.clearDetails();
  ASSERT_GT(clear.size(), 1000u);
  std::vector<int> missed;
  std::set_difference(clear.begin(), clear.end(), details.indices.begin(),
                      details.indices.end(), std::back_inserter(missed));
  EXPECT_LE(static_cast<double>(missed.size()),
            missing * static_cast<double>(clear.size()));
  const std::set<int> truth(scene.parts.details.begin(), scene.parts.details.end());
  for (const int i : details.indices)
    if (!truth.count(i)) {
      EXPECT_GT(scene.points[i].z(), height / 2);
      EXPECT_LT(scene.points[i].z(), height - 0.07) << "not the main ceiling";
    }
  EXPECT_EQ(details.region.size(), details.indices.size());
  EXPECT_TRUE(std::is_sorted(details.indices.begin(), details.indices.end()));
}

} // namespace sedr_test
