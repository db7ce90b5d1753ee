// SPDX-License-Identifier: BSD-3-Clause
#include "cast_rays.h"

#include <gtest/gtest.h>

namespace {

using namespace sedr_test;

constexpr int rays = 150000;

/** The furnished rooms, of which the pane mirrors a quarter of the rays and lets none
 * through. */
GlazedRooms
mirroringRoom()
{
  GlazedRooms room(true);
  room.mirrored = 0.25;
  room.has_second = false;
  room.scanFrom({2.8, 2.4, 1.5}, rays);
  return room;
}

std::size_t
countOf(const std::vector<std::uint8_t>& flags)
{
  return static_cast<std::size_t>(std::count(flags.begin(), flags.end(), 1));
}

TEST(MirroredPoints, WhatAPaneShowsASecondTimeIsFoundAndNothingElse)
{
  GlazedRooms room = mirroringRoom();
  room.scanFrom({1.1, 1.2, 1.4}, rays);
  const MirroredPoints found = room.found();
  EXPECT_GE(found.mirrors, 1u);
  std::size_t images = 0;
  std::size_t missed = 0;
  for (std::size_t i = 0; i < room.rows.size(); ++i) {
    if (!room.is_image[i])
      EXPECT_EQ(found.of_rows[i], 0) << room.rows[i].transpose();
    else if (room.rows[i].x() > 6.5F) {
      ++images;
      missed += found.of_rows[i] == 0 ? 1 : 0;
    }
  }
  EXPECT_GT(images, 1500u);
  EXPECT_LT(missed, images / 8);
  EXPECT_EQ(found.of_thinned, found.of_rows); // all points are retained here
}

TEST(MirroredPoints,
     WhatIsSeenThroughGlassThatDoesNotMirrorStaysIsMarkedAndItsRaysAreKept)
{
  GlazedRooms room(true);
  room.scanFrom({2.8, 2.4, 1.5}, rays);
  const MirroredPoints found = room.found();
  ASSERT_EQ(found.behind.size(), room.rows.size());
  EXPECT_GT(found.rays, 1000u);
  EXPECT_EQ(found.lines.size(), found.rays);
  EXPECT_EQ(found.mirrors, 0u);
  EXPECT_EQ(countOf(found.of_rows), 0u);
  std::size_t behind = 0;
  std::size_t marked = 0;
  for (std::size_t i = 0; i < room.rows.size(); ++i) {
    if (room.rows[i].x() < 6.001F)
      EXPECT_EQ(found.behind[i], 0) << room.rows[i].transpose();
    else if (room.rows[i].x() > 6.5F) {
      ++behind;
      marked += found.behind[i];
    }
  }
  EXPECT_GT(behind, 5000u);
  EXPECT_GT(marked, behind * 9 / 10);
}

TEST(MirroredPoints, RaysThatMeetReflectionsAreNoLinesOfSight)
{
  GlazedRooms room = mirroringRoom();
  const MirroredPoints found = room.found();
  std::size_t beyond = 0;
  for (const pcl::sedr::SightLine& line : found.lines)
    beyond += line.to.x() > 6.5F ? 1 : 0;
  EXPECT_GT(found.rays - found.lines.size(), 100u);
  EXPECT_LT(beyond, (found.rays - found.lines.size()) / 5);
}

TEST(MirroredPoints, WhatIsSeenFreelyTooStays)
{
  GlazedRooms room = mirroringRoom();
  const std::size_t mirrored = countOf(room.found().of_rows);
  ASSERT_GT(mirrored, 300u);
  // The same points again, seen from a position behind the pane with nothing between.
  const std::size_t rows = room.rows.size();
  room.positions.push_back({rows, Eigen::Vector3f(9, 2.4F, 1.5F)});
  for (std::size_t i = 0; i < rows; ++i)
    if (room.is_image[i]) {
      room.rows.push_back(room.rows[i]);
      room.is_image.push_back(false);
    }
  EXPECT_LT(countOf(room.found().of_rows), mirrored / 20);
}

TEST(MirroredPoints, WithoutKnownPositionsNothingIsLeftOut)
{
  GlazedRooms room = mirroringRoom();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const ScanPositions& positions :
       {ScanPositions(), ScanPositions{{0, Eigen::Vector3f::Constant(nan)}},
        ScanPositions{{room.rows.size(), Eigen::Vector3f::Zero()}}}) {
    const MirroredPoints found = room.found(positions);
    EXPECT_EQ(found.rays, 0u);
    EXPECT_EQ(countOf(found.of_rows), 0u);
  }
}

} // namespace
