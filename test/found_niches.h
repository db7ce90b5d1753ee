// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room_points.h"

#include <pcl/sedr_segmentation/opening_detection.h>

#include <gtest/gtest.h>

namespace sedr_test {

using namespace pcl::sedr;

/** Returns the niches found in a room that is known except for them. */
inline std::vector<PlanNiche>
nichesOf(const RoomPoints& points, PlanRoom room)
{
  room.niches.clear();
  Floorplan plan{{room}};
  pcl::OpeningDetection<pcl::PointXYZ> detection;
  detection.setInputCloud(points.cloud());
  EXPECT_TRUE(detection.segment(plan)) << detection.getErrorMessage();
  return plan.rooms[0].niches;
}

} // namespace sedr_test
