// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/levels/level_checks.h"

#include "sedr_segmentation/src/planes/floor_reflections.h"
#include <pcl/sedr_segmentation/horizontal_plane_detection.h>

#include <algorithm>
#include <random>
#include <set>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** A furnished room of 6 m x 4 m, 2.6 m high; two tables and a cupboard hide parts of
 * the floor. */
RoomPoints
furnished(double floor = 0)
{
  RoomPoints points;
  points.room(rectangle(0, 0, 6, 4), floor, floor + 2.6);
  for (const auto& [where, height] : {std::make_pair(rectangle(1, 1, 2.5, 2), 0.74),
                                      std::make_pair(rectangle(3, 1, 4.5, 2), 0.74),
                                      std::make_pair(rectangle(5.2, 1, 6, 3), 1.8)}) {
    points.slab(where, floor + height);
    for (const auto& side : where.elements)
      points.wall(side, floor + height - 0.3, floor + height);
  }
  return points;
}

/** Returns the points, and mirrored below the plane z = 0 a `share` of them with noise
 * of 1 cm. */
RoomPoints
mirrored(const RoomPoints& points, double share)
{
  RoomPoints all = points;
  std::mt19937 random(1);
  std::bernoulli_distribution is_seen(share);
  std::normal_distribution<double> noise(0, 0.01);
  for (const int i : points.all())
    if (is_seen(random))
      all.point(points[i].x() + noise(random), points[i].y() + noise(random),
                -points[i].z() + noise(random));
  return all;
}

pcl::HorizontalPlaneDetection<pcl::PointXYZ>
detectionIn(const RoomPoints& points)
{
  pcl::HorizontalPlaneDetection<pcl::PointXYZ> detection;
  detection.setInputCloud(points.cloud());
  return detection;
}

std::vector<double>
heightsOf(LevelKind kind, const std::vector<pcl::HorizontalPlane>& planes)
{
  std::vector<double> heights;
  for (const auto& plane : planes)
    if (plane.kind == kind)
      heights.push_back(plane.height);
  return heights;
}

TEST(FloorReflections, AreThePointsWithTheirLikeAboveAFloorThatMirrors)
{
  const RoomPoints room = furnished();
  const RoomPoints points = mirrored(room, 1);
  const LevelParameters parameters;
  const LevelColumns columns = columnsOf(points.view(), points.all(), parameters);
  std::vector<Level> levels = findLevels(columns, parameters);
  classifyLevels(levels, parameters);
  const std::vector<int> found = findReflections(columns, levels, parameters);
  EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
  const std::set<int> reflections(found.begin(), found.end());
  EXPECT_EQ(reflections.size(), found.size());
  EXPECT_GE(found.front(), static_cast<int>(room.size())) << "none of the room itself";
  std::size_t missed = 0;
  for (const int i : points.all())
    if (points[i].z() < -0.2f && reflections.count(i) == 0)
      ++missed;
  EXPECT_LT(static_cast<double>(missed), 0.02 * static_cast<double>(room.size()));
  EXPECT_TRUE(findReflections(columnsOf(room.view(), room.all(), parameters),
                              levelsOf(room), parameters)
                  .empty());
}

TEST(FloorReflections, ARoomUpsideDownBelowItsFloorIsLeftOut)
{
  const RoomPoints room = furnished();
  for (const double share : {0.1, 0.5, 1.0}) {
    SCOPED_TRACE(share);
    const RoomPoints points = mirrored(room, share);
    auto detection = detectionIn(points);
    std::vector<pcl::HorizontalPlane> planes;
    ASSERT_TRUE(detection.segment(planes));
    const auto floors = heightsOf(LevelKind::Floor, planes);
    ASSERT_EQ(floors.size(), 1u);
    EXPECT_NEAR(floors[0], 0, 0.01);
    ASSERT_FALSE(detection.getReflections().empty());
    // No point of the room itself is one.
    EXPECT_GE(detection.getReflections().front(), static_cast<int>(room.size()));
    for (const auto& plane : planes)
      EXPECT_GT(plane.height, -0.1);
    // Walls, too, except points that are as near to the floor as its noise.
    const auto mirror_images = static_cast<double>(points.size() - room.size());
    EXPECT_GT(static_cast<double>(detection.getReflections().size()),
              0.65 * mirror_images);
  }
}

TEST(FloorReflections, HaveTheirLikeAboveForFourFifthsOfWhatIsBelow)
{
  // The ceiling and the furniture, 29 square metres, and a slab with nothing at its
  // mirrored height.
  for (const double share : {0.88, 0.72}) {
    RoomPoints points = mirrored(furnished(), 1);
    points.slab(rectangle(0.5, 0.2, 5.5, 0.2 + 29 * (1 / share - 1) / 5), -1.5);
    auto detection = detectionIn(points);
    std::vector<pcl::HorizontalPlane> planes;
    ASSERT_TRUE(detection.segment(planes));
    EXPECT_EQ(detection.getReflections().empty(), share < 0.8) << share;
  }
}

TEST(FloorReflections, ARoomAloneHasNone)
{
  auto detection = detectionIn(furnished());
  std::vector<pcl::HorizontalPlane> planes;
  ASSERT_TRUE(detection.segment(planes));
  EXPECT_TRUE(detection.getReflections().empty());
}

TEST(FloorReflections, AStoreyBelowIsNone)
{
  // At the height where the floor is the reflection of the ceiling.
  RoomPoints points = furnished();
  const RoomPoints below = furnished(-2.6);
  for (const int i : below.all())
    if (below[i].z() < -0.25f)
      points.point(below[i].x(), below[i].y(), below[i].z());
  points.slab(rectangle(0, 0, 6, 4), -0.25);
  auto detection = detectionIn(points);
  std::vector<pcl::HorizontalPlane> planes;
  ASSERT_TRUE(detection.segment(planes));
  EXPECT_TRUE(detection.getReflections().empty());
}

TEST(FloorReflections, TheFloorBelowATableHalfWayUpIsNone)
{
  RoomPoints points;
  points.room(rectangle(0, 0, 6, 4), 0, 2.6);
  points.slab(rectangle(1, 1, 4, 3), 1.3);
  auto detection = detectionIn(points);
  std::vector<pcl::HorizontalPlane> planes;
  ASSERT_TRUE(detection.segment(planes));
  EXPECT_TRUE(detection.getReflections().empty());
  const auto floors = heightsOf(LevelKind::Floor, planes);
  ASSERT_FALSE(floors.empty());
  EXPECT_NEAR(floors[0], 0, 0.01);
}

TEST(FloorReflections, SinglePointsBelowTheFloorAreNoLevels)
{
  // One in twelve cells has points every 14 cm of height: more than a level needs.
  RoomPoints points = furnished();
  std::mt19937 random(2);
  std::uniform_real_distribution<double> share(0, 1);
  for (int i = 0; i < 12000; ++i)
    points.point(6 * share(random), 4 * share(random), -0.2 - 2.2 * share(random));
  auto detection = detectionIn(points);
  std::vector<pcl::HorizontalPlane> planes;
  ASSERT_TRUE(detection.segment(planes));
  EXPECT_GT(planes.front().height, -0.1);
}

} // namespace
