// SPDX-License-Identifier: BSD-3-Clause
#include "simulator/check/scene_check.h"
#include "simulator/scan/scan.h"
#include "simulator/scan/scene_surfaces.h"
#include "simulator/scene/furniture.h"
#include "simulator/scene/scenes.h"
#include "simulator/truth/room_regions.h"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

namespace pcl::sedr::sim::test {
namespace {

std::size_t
stationCount(const Scene& scene)
{
  std::size_t count = 0;
  for (const Scanner& scanner : scene.scanners)
    count += scanner.stations.size();
  return count;
}

TEST(Scenes, arePhysicallySane)
{
  for (const Scene& scene : allScenes())
    for (const std::string& problem : problemsOf(scene))
      ADD_FAILURE() << scene.name << ": " << problem;
}

TEST(Scenes, areScannedByOneToFourAndAHalfMillionRays)
{
  for (const Scene& scene : allScenes()) {
    std::size_t rays = 0;
    for (const Scanner& scanner : scene.scanners)
      rays += scanner.stations.size() * scanner.rays_per_station;
    EXPECT_GE(rays, 1'000'000U) << scene.name;
    EXPECT_LE(rays, 4'500'000U) << scene.name;
  }
}

TEST(Scenes, areScannedFromTheHeightOfAPerson)
{
  for (const Scene& scene : allScenes())
    for (const Scanner& scanner : scene.scanners)
      for (const Vec3& station : scanner.stations) {
        const std::uint32_t room = roomAt(scene, station);
        ASSERT_GT(room, 0U) << scene.name;
        const double height =
            station.z - floorBelow(scene.rooms[room - 1], plan(station));
        EXPECT_GE(height, 1.3) << scene.name;
        EXPECT_LE(height, 1.8) << scene.name;
      }
}

TEST(Scenes, showEveryLabelAndRoomTheyHave)
{
  for (const Scene& scene : allScenes()) {
    std::set<std::uint32_t> expected{0, 1, 2, 3};
    for (const Room& room : scene.rooms) {
      if (!room.details.empty() || !room.floor_details.empty() || !room.niches.empty())
        expected.insert(static_cast<std::uint32_t>(Label::Detail));
      if (!room.columns.empty())
        expected.insert(static_cast<std::uint32_t>(Label::Column));
    }
    ScanOptions options;
    options.rays_per_station = 60000 / stationCount(scene);
    std::set<std::uint32_t> labels;
    std::set<std::uint32_t> rooms;
    for (const ScanPoint& point : scan(scene, options).points) {
      labels.insert(point.label);
      rooms.insert(point.room);
    }
    EXPECT_EQ(labels, expected) << scene.name;
    EXPECT_EQ(rooms.size(), scene.rooms.size() + 1) << scene.name;
  }
}

TEST(Scenes, areFoundByNameOnly)
{
  EXPECT_EQ(sceneNamed("hls_hall").name, "hls_hall");
  try {
    sceneNamed("hls_hal");
    FAIL();
  }
  catch (const std::invalid_argument& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("'hls_hal'"), std::string::npos);
    EXPECT_NE(text.find("bls_room, hls_hall, syn_flat"), std::string::npos);
  }
}

TEST(Furniture, standsWithItsBackToTheWall)
{
  const Element wall{{0.0, 4.0}, {0.0, 0.0}, 0.0}; // west wall, the room to its left
  const Spot spot = spotAtWall(wall, 1.0, 0.4, 0.02);
  EXPECT_NEAR(spot.center.x, 0.22, 1e-12);
  EXPECT_NEAR(spot.center.y, 3.0, 1e-12);
  const Vec2 front = rotated({0.0, -1.0}, spot.yaw);
  EXPECT_NEAR(front.x, 1.0, 1e-12);
}

TEST(Furniture, keepsItsCornersClearOfACurvedWall)
{
  const Element wall{{0.0, 0.0}, {0.0, 11.0}, bulgeOf(11.0, 8.0)};
  const Arc arc = arcOf(wall);
  const Spot spot = spotAtWall(wall, 4.0, 0.4, 0.02, 1.2);
  const Vec2 corner = spot.center + rotated({0.6, 0.2}, spot.yaw);
  EXPECT_NEAR(length(corner - arc.center), 8.0 - 0.02, 1e-12);
}

} // namespace
} // namespace pcl::sedr::sim::test
