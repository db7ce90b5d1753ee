// SPDX-License-Identifier: BSD-3-Clause
#include "room_points.h"

#include <pcl/sedr_segmentation/horizontal_plane_detection.h>

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

constexpr auto Ceiling = LevelKind::Ceiling;
constexpr auto Floor = LevelKind::Floor;
constexpr auto Other = LevelKind::Other;

using Detection = pcl::HorizontalPlaneDetection<pcl::PointXYZ>;

TEST(HorizontalPlaneDetection, GivesThePlanesLowestFirstWithAllTheirFigures)
{
  RoomPoints points;
  points.room(rectangle(0, 0, 4, 3), 0, 2.5);
  const auto table = points.slab(rectangle(1, 1, 2.5, 2), 0.75);
  const auto cloud = points.cloud();
  cloud->header.frame_id = "scan";
  Detection detection;
  detection.setInputCloud(cloud);
  std::vector<pcl::HorizontalPlane> planes(7);
  ASSERT_TRUE(detection.segment(planes)) << detection.getErrorMessage();
  ASSERT_EQ(planes.size(), 3u);
  EXPECT_EQ(planes[0].kind, Floor);
  EXPECT_EQ(planes[1].kind, Other);
  EXPECT_EQ(planes[2].kind, Ceiling);
  const double heights[] = {0, 0.75, 2.5};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& plane = planes[k];
    ASSERT_EQ(plane.coefficients.values.size(), 4u);
    for (const std::size_t c : {0u, 1u})
      EXPECT_NEAR(plane.coefficients.values[c], 0, 1e-5);
    EXPECT_NEAR(plane.coefficients.values[2], 1, 1e-6);
    EXPECT_NEAR(plane.coefficients.values[3], -heights[k], 1e-5);
    EXPECT_NEAR(plane.slab.heightAt({1, 1}), heights[k], 1e-5);
    EXPECT_EQ(plane.inliers.header.frame_id, "scan");
    EXPECT_NEAR(plane.area, static_cast<double>(plane.cells) * 0.0025, 1e-9);
    EXPECT_NEAR(plane.residual, 0, 1e-5);
    EXPECT_TRUE(
        std::is_sorted(plane.inliers.indices.begin(), plane.inliers.indices.end()));
  }
  EXPECT_EQ(planes[1].inliers.indices, *shared(table));
  EXPECT_NEAR(planes[1].area, 1.5, 0.1);
}

TEST(HorizontalPlaneDetection, SaysWhatItLookedForWhereThereIsNone)
{
  RoomPoints points;
  points.wall(segment({0, 0}, {4, 0}), 0, 2.5);
  Detection detection;
  detection.setInputCloud(points.cloud());
  detection.setMinimumArea(2.5);
  std::vector<pcl::HorizontalPlane> planes(7);
  EXPECT_FALSE(detection.segment(planes));
  EXPECT_TRUE(planes.empty());
  EXPECT_NE(detection.getErrorMessage().find("2.5"), std::string::npos);
  EXPECT_NE(detection.getErrorMessage().find("4000"), std::string::npos)
      << detection.getErrorMessage();
}

TEST(HorizontalPlaneDetection, TheTiltLimitTellsATiltedSlabFromARamp)
{
  RoomPoints points;
  points.slab(rectangle(0, 0, 4, 3), 0);
  points.slab(rectangle(0, 0, 4, 3), slabAt(2.5, std::tan(2 * M_PI / 180)));
  Detection detection;
  detection.setInputCloud(points.cloud());
  std::vector<pcl::HorizontalPlane> planes;
  ASSERT_TRUE(detection.segment(planes));
  ASSERT_EQ(planes.size(), 2u);
  EXPECT_NEAR(std::acos(planes[1].slab.plane[2]), 2 * M_PI / 180, 1e-4);
  detection.setMaximumTilt(0.5 * M_PI / 180);
  ASSERT_TRUE(detection.segment(planes));
  for (const auto& plane : planes)
    EXPECT_LE(std::acos(plane.slab.plane[2]), 0.5 * M_PI / 180 + 1e-9);
}

TEST(HorizontalPlaneDetection, AThresholdBelowTheLeastNoiseIsKeptTo)
{
  RoomPoints points;
  points.room(rectangle(0, 0, 4, 3), 0, 2.5);
  for (const double threshold : {0.01, 0.0002}) {
    Detection detection;
    detection.setInputCloud(points.cloud());
    detection.setDistanceThreshold(threshold);
    std::vector<pcl::HorizontalPlane> planes;
    ASSERT_TRUE(detection.segment(planes)) << detection.getErrorMessage();
    ASSERT_EQ(planes.size(), 2u) << threshold;
    EXPECT_NEAR(planes[0].height, 0, 1e-5);
    EXPECT_NEAR(planes[1].height, 2.5, 1e-5);
  }
}

} // namespace
