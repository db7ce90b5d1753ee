// SPDX-License-Identifier: BSD-3-Clause
// Positions of a scanner that the scan contradicts.
#include "cast_rays.h"
#include "sedr_filters/src/rays/sight_lines.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace {

using namespace sedr_test;

/** Both rooms, scanned from the middle of each.
 * @param returned share of the rays that the pane returns; 1: a wall
 * @param untrue number of scans of both rooms before these that are told to be taken
 * from places outside */
GlazedRooms
twoRooms(double returned, int untrue = 0)
{
  GlazedRooms rooms(false);
  rooms.returned = returned;
  for (int k = 0; k <= untrue; ++k)
    for (const double x : {3., 9.2}) {
      rooms.scanFrom({x, 2.4, 1.5}, 50000);
      if (k < untrue)
        rooms.positions.back().place = Vector3f(static_cast<float>(3 * k), -20, 1.5F);
    }
  return rooms;
}

TEST(TruePlaces, TheCornerOfARoomIsNone)
{
  constexpr float voxel = 0.05F;
  const GlazedRooms rooms = twoRooms(1);
  for (const Vector3f& corner : {Vector3f(0, 0, 0), Vector3f(0.04F, 0.05F, 0)}) {
    ScanPositions positions = rooms.positions;
    positions[0].place = corner;
    const MirroredPoints found = rooms.found(positions, voxel);
    ASSERT_EQ(found.untrue.size(), 1u);
    EXPECT_EQ(found.untrue[0], corner);
  }
}

TEST(TruePlaces, AreToldFromOthersInVoxelsOfOneDecimetreToo)
{
  constexpr float voxel = 0.1F;
  for (const double returned : {0.05, 0.2, 1.})
    EXPECT_TRUE(
        twoRooms(returned).found(twoRooms(returned).positions, voxel).untrue.empty())
        << returned;
  const GlazedRooms rooms = twoRooms(1);
  EXPECT_EQ(rooms.found({rooms.positions[0]}, voxel).untrue.size(), 1u);
}

TEST(TruePlaces, UntrueOnesDoNotTakeTheRaysOfTrueOnesThatFollow)
{
  // As many as count in a cube of 10 cm.
  const GlazedRooms rooms = twoRooms(1, 4);
  const MirroredPoints found = rooms.found(rooms.positions);
  EXPECT_EQ(found.untrue.size(), 4u);
  const GlazedRooms alone = twoRooms(1);
  const std::size_t expected = alone.found(alone.positions).rays;
  EXPECT_GT(found.rays, expected * 9 / 10);
}

TEST(TruePlaces, ThoseOfOtherScansAndThoseOutsideAreUntrueOneByOne)
{
  const GlazedRooms rooms = twoRooms(1);
  ScanPositions swapped = rooms.positions;
  std::swap(swapped[0].place, swapped[1].place);
  EXPECT_EQ(rooms.found(swapped).untrue.size(), 2u);
  ScanPositions outside = rooms.positions;
  outside[1].place = Vector3f(9, -20, 1.5F);
  const MirroredPoints found = rooms.found(outside);
  ASSERT_EQ(found.untrue.size(), 1u);
  EXPECT_EQ(found.untrue[0], outside[1].place);
  EXPECT_GT(found.rays, 1000u); // those of the other
}

TEST(TruePlaces, AreBelowAGlassRoofInAScanThatWasCutToIt)
{
  // Steps of a third of a degree in both angles, below a roof of 5.6 m x 4.6 m that
  // returns a tenth of the rays, and another 3 m above it.
  const Eigen::AlignedBox3d room(Vector3d(0, 0, 0), Vector3d(6, 5, 2.6));
  const Eigen::AlignedBox3d whole(Vector3d(0, 0, 0), Vector3d(6, 5, 5.6));
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<Vector3f> rows;
  ScanPositions positions;
  for (const Vector3d& place : {Vector3d(2, 2.4, 1.5), Vector3d(4.2, 2.7, 1.5)}) {
    positions.push_back({rows.size(), place.cast<float>()});
    const double step = M_PI / 540;
    for (double up = M_PI / 6; up < M_PI / 2; up += step)
      for (double around = -M_PI / 4; around < M_PI / 4; around += step) {
        const Vector3d direction(std::cos(up) * std::cos(around),
                                 std::cos(up) * std::sin(around), std::sin(up));
        Vector3d hit = place + crossingsOf(room, place, direction).second * direction;
        const bool is_pane = hit.z() > 2.59 && std::abs(hit.x() - 3) < 2.8 &&
                             std::abs(hit.y() - 2.5) < 2.3;
        if (is_pane && uniform(random) > 0.1)
          hit = place + crossingsOf(whole, place, direction).second * direction;
        rows.push_back(hit.cast<float>());
      }
  }
  const PointView view(rows.data(), sizeof(Vector3f), rows.size());
  EXPECT_TRUE(findMirroredPoints(view, view, 1, positions, 2).untrue.empty());
}

TEST(TruePlaces, OneFarAwayIsUntrue)
{
  const MirroredPoints found = twoRooms(1).found({{0, {691600, 5336000, 500}}}, 0.05F);
  EXPECT_EQ(found.untrue.size(), 1u);
  EXPECT_TRUE(found.lines.empty());
}

using pcl::sedr::Levelling;
using pcl::sedr::SightLine;
using pcl::sedr::SightLines;

/** Rays from some places to points all around. */
std::vector<SightLine>
randomLines(std::size_t n)
{
  std::mt19937 random(5);
  std::normal_distribution<float> normal;
  std::uniform_real_distribution<float> range(0.3F, 8);
  const std::vector<Vector3f> places{{0, 0, 0}, {2, 1, 0.5F}, {-3, 4, 1}};
  std::vector<SightLine> lines;
  for (std::size_t i = 0; i < n; ++i) {
    const Vector3f from = places[i % places.size()];
    const Vector3f way(normal(random), normal(random), normal(random));
    lines.push_back({from, from + range(random) * way.normalized()});
  }
  return lines;
}

/** Returns whether a ray goes through, ray by ray. */
bool
pierced(const std::vector<SightLine>& lines,
        const Vector3d& place,
        const Vector3d& normal,
        double radius)
{
  return std::any_of(lines.begin(), lines.end(), [&](const SightLine& line) {
    const Vector3d from = line.from.cast<double>();
    const Vector3d to = line.to.cast<double>();
    const double start = (from - place).dot(normal);
    const double end = (to - place).dot(normal);
    if (std::abs(start) <= 0.15 || std::abs(end) <= 0.15 || start * end > 0)
      return false;
    const double share = start / (start - end);
    return (from + share * (to - from) - place).norm() <= radius;
  });
}

TEST(SightLines, PierceAsRayByRayInEveryDirection)
{
  const std::vector<SightLine> lines = randomLines(30000);
  const SightLines sight(lines);
  EXPECT_EQ(sight.size(), lines.size());
  std::mt19937 random(6);
  std::normal_distribution<double> normal;
  int through = 0;
  for (int i = 0; i < 300; ++i) {
    Vector3d place(3 * normal(random), 3 * normal(random), 2 * normal(random));
    if (i % 10 == 0)
      place.head<2>() = Eigen::Vector2d(0.01 * normal(random), 0); // above a place
    const Vector3d across =
        Vector3d(normal(random), normal(random), normal(random)).normalized();
    const bool expected = pierced(lines, place, across, 0.05);
    EXPECT_EQ(sight.across(place, across, 0.05).through > 0, expected)
        << place.transpose();
    through += expected ? 1 : 0;
  }
  EXPECT_GT(through, 30);
  EXPECT_LT(through, 270);
}

TEST(SightLines, WithoutRaysAndOfNaNTellNothing)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const SightLines sight({{{0, 0, nan}, {1, 1, 1}}, {{1, 1, 1}, {1, 1, 1}}});
  EXPECT_EQ(sight.size(), 0u);
  EXPECT_EQ(sight.across({1, 1, 1}, Vector3d::UnitX(), 1).through, 0u);
}

} // namespace
