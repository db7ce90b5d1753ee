// SPDX-License-Identifier: BSD-3-Clause
#include "room_points.h"

#include "sedr_segmentation/src/scan/missing_surfaces.h"
#include "sedr_segmentation/src/scan/scan_check.h"
#include "sedr_segmentation/src/scan/unit_check.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <limits>
#include <random>
#include <utility>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** Points of a room of 6 m x 4 m x 2.5 m, transformed by `change`. */
template <typename Change>
RoomPoints
changed(Change change)
{
  RoomPoints room;
  room.room(rectangle(0, 0, 6, 4), 0, 2.5);
  RoomPoints result;
  for (const int i : room.all()) {
    const Eigen::Vector3d p = change(room[i].cast<double>().eval());
    result.point(p.x(), p.y(), p.z());
  }
  return result;
}

std::string
scanProblemOf(const RoomPoints& points)
{
  const std::vector<int> all = points.all();
  return scanProblem(points.view(), &all);
}

bool
mentions(const std::string& sentence, const std::string& part)
{
  return sentence.find(part) != std::string::npos;
}

TEST(ScanProblem, OfARoomInMetresIsNone)
{
  EXPECT_EQ(scanProblemOf(changed([](auto p) { return p; })), "");
  EXPECT_EQ(scanProblemOf(changed([](auto p) -> Eigen::Vector3d {
              return p + Eigen::Vector3d(500000, -4e6, 120);
            })),
            "")
      << "far from the origin";
}

TEST(ScanProblem, ScansInOtherUnitsAreNamedWithTheirExtent)
{
  for (const auto& [scale, parts] :
       {std::pair(1000.0, std::array{"millimetre", "0.001", "6000 x 4000 x 2500 m"}),
        std::pair(100.0, std::array{"centimetre", "0.01", "600 x 400 x 250 m"}),
        std::pair(0.001, std::array{"too small", "0.00", "0.00"})}) {
    const std::string problem = scanProblemOf(
        changed([&, by = scale](auto p) -> Eigen::Vector3d { return p * by; }));
    for (const char* part : parts)
      EXPECT_TRUE(mentions(problem, part)) << part << ": " << problem;
  }
}

TEST(ScanProblem, AStrayPointKilometresAwayIsNoReason)
{
  RoomPoints points = changed([](auto p) { return p; });
  points.point(9e4, 9e4, 9e4);
  points.point(-9e4, -9e4, -9e4);
  EXPECT_EQ(scanProblemOf(points), "");
}

TEST(ScanProblem, TooFewFinitePointsAreCounted)
{
  RoomPoints points;
  for (int i = 0; i < 999; ++i)
    points.point(0.01 * i, 0.02 * i, 0.003 * i);
  for (int i = 0; i < 5000; ++i)
    points.point(1, 1, std::numeric_limits<double>::quiet_NaN());
  const std::string problem = scanProblemOf(points);
  EXPECT_TRUE(mentions(problem, "999 of 5999")) << problem;
  EXPECT_TRUE(mentions(problem, "1000")) << problem;
  points.point(1, 1, 1);
  EXPECT_EQ(scanProblemOf(points), "");
  EXPECT_TRUE(mentions(scanProblem(PointView()), "0 of 0"));
}

TEST(ScanProblem, LooksAtTheIndexedPointsOnly)
{
  RoomPoints points = changed([](auto p) { return p; });
  const std::vector<int> room = points.all();
  for (int i = 0; i < 20000; ++i)
    points.point(1000.0 * i, 0, 1000.0 * i);
  EXPECT_EQ(scanProblem(points.view(), &room), "");
  EXPECT_NE(scanProblemOf(points), "");
}

/** Rooms of the given heights and equal area, too far apart for walls. */
Floorplan
planOf(const std::vector<double>& heights, double area)
{
  Floorplan plan;
  double x = 0;
  for (const double height : heights) {
    plan.rooms.push_back(roomOf(rectangle(x, 0, x + area / 10, 10), height));
    x += area / 10 + 5;
  }
  return plan;
}

std::string
footReason(const Floorplan& plan,
           const std::vector<RoomLink>& links = {},
           const std::vector<Eigen::Vector3f>& places = {})
{
  return footProblem(plan, links, places).reason;
}

/** A link of the given height. */
std::vector<RoomLink>
linkOf(double height)
{
  RoomLink link;
  link.top = height;
  return {link};
}

TEST(FootProblem, RoomsAsHighAsThoseOfAHomeAreInFeetAreTold)
{
  const std::string problem = footReason(planOf({8, 8.5, 10}, 150));
  EXPECT_TRUE(mentions(problem, "the largest room is 8.0 m high and 150 m2 large"))
      << problem;
  EXPECT_TRUE(mentions(problem, "--unit 0.3048")) << problem;
}

TEST(FootProblem, ASingleRoomAndTheDoorsOfTwoTellItToo)
{
  const std::string alone = footReason(planOf({10.6}, 240));
  EXPECT_TRUE(mentions(alone, "the room is 10.6 m high")) << alone;
  const std::string hall = footReason(planOf({10.6}, 600));
  EXPECT_TRUE(mentions(hall, "--unit 0.3048")) << hall;
  Floorplan two = planOf({8, 8}, 150);
  EXPECT_TRUE(mentions(footReason(two, linkOf(6.7)), "--unit 0.3048"));
  EXPECT_EQ(footReason(two, linkOf(2.1)), "") << "halls with doors of metres";
  EXPECT_EQ(footReason(two, linkOf(4)), "") << "portals, which nobody passes in feet";
  two.rooms[1].boundary = rectangle(16, 0, 31, 10);
  EXPECT_TRUE(mentions(footReason(two, linkOf(6)), "walls 1.00 m thick"));
}

TEST(FootProblem, DoorsAndScannersTellItOfLargeRoomsToo)
{
  const Floorplan halls = planOf({8, 8.5, 10}, 600);
  const std::vector<Eigen::Vector3f> in_feet{{3, 3, 5.2F}, {5, 5, 5.4F}, {3, 3, -2}};
  const std::string problem = footReason(halls, {}, in_feet);
  EXPECT_TRUE(mentions(problem, "the scanner stood 5.")) << problem;
  const Floorplan gym = planOf({21}, 6000);
  EXPECT_TRUE(mentions(footReason(gym), "--unit 0.3048"));
  EXPECT_EQ(footReason(gym, {}, {{3, 3, 1.6F}}), "");
  const std::string by_doors = footReason(gym, linkOf(6.7));
  EXPECT_TRUE(mentions(by_doors, "6000 m2 large, doors are 6.7 m high")) << by_doors;
  EXPECT_EQ(footReason(gym, linkOf(6.7), {{3, 3, 1.6F}}), "") << "gates, not doors";
}

TEST(FootProblem, AScannerAsHighAsADoorOfMetresTellsMetres)
{
  const Floorplan hall = planOf({10.6}, 240);
  EXPECT_EQ(footReason(hall, {}, {{3, 3, 1.6F}}), "");
  EXPECT_NE(footReason(hall, {}, {{3, 3, 9.5F}}), "") << "a camera below the ceiling";
}

TEST(FootProblem, HallsAndRoomsInMetresAreNone)
{
  EXPECT_EQ(footReason(planOf({2.5, 2.4, 3}, 15)), "");
  EXPECT_EQ(footReason(planOf({8, 8, 2.6}, 150)), "") << "halls and a room beside them";
  EXPECT_EQ(footReason(planOf({4, 6, 6.5}, 600)), "") << "three large halls";
  for (const double area : {60, 100, 200, 400})
    EXPECT_EQ(footReason(planOf({6}, area)), "") << "one hits one's head in feet";
  EXPECT_EQ(footReason(Floorplan()), "");
}

TEST(InchProblem, IsToldByTheHeightOfTheStoreysThatWereFound)
{
  const RoomPoints points = changed([](auto p) -> Eigen::Vector3d { return 40 * p; });
  const std::string problem = inchProblem(points.view(), 1);
  EXPECT_TRUE(mentions(problem, "--unit 0.0254")) << problem;
  EXPECT_EQ(inchProblem(points.view(), 0), problem);
  EXPECT_EQ(inchProblem(points.view(), 20), "") << "a tower";
  EXPECT_EQ(inchProblem(changed([](auto p) { return p; }).view(), 1), "");
  EXPECT_EQ(inchProblem(PointView(), 0), "");
}

/** Tells what is missing of the points of that room for which `is_seen` holds, moved by
 * as much as `scatter`. */
MissingSurfaces
missingOf(const std::function<bool(const Eigen::Vector3d&)>& is_seen,
          double scatter = 0,
          double spacing = 0.05)
{
  RoomPoints room(spacing);
  room.room(rectangle(0, 0, 6, 4), 0, 2.5);
  RoomPoints result;
  std::mt19937 random(1);
  std::normal_distribution<double> normal(0, scatter);
  for (const int i : room.all())
    if (const Eigen::Vector3d p = room[i].cast<double>(); is_seen(p))
      result.point(p.x() + normal(random), p.y() + normal(random),
                   p.z() + normal(random));
  return missingSurfaces(result.view(), result.all(), 1);
}

TEST(MissingSurfaces, AreNamed)
{
  const auto all = [](const Eigen::Vector3d&) { return true; };
  EXPECT_EQ(missingOf(all).reason, "");
  const std::pair<double, const char*> levels[] = {{0, "a ceiling was seen"},
                                                   {2.5, "a floor was seen"}};
  for (const auto& [level, sentence] : levels)
    EXPECT_TRUE(mentions(missingOf([&, z = level](const Eigen::Vector3d& p) {
                           return std::abs(p.z() - z) > 0.01;
                         }).reason,
                         sentence));
  EXPECT_TRUE(mentions(missingOf([](const Eigen::Vector3d& p) {
                         return std::abs(p.z() - 1.25) < 1.2;
                       }).reason,
                       "neither a floor nor a ceiling"));
  EXPECT_TRUE(mentions(missingOf(all, 0, 0.25).reason, "too sparse"));
}

TEST(MissingSurfaces, OfStrewnOrNoisyPointsAreAllOfThem)
{
  const auto all = [](const Eigen::Vector3d&) { return true; };
  EXPECT_FALSE(missingOf(all, 0.01).is_noisy);
  const MissingSurfaces noisy = missingOf(all, 0.06);
  EXPECT_TRUE(noisy.is_noisy);
  EXPECT_TRUE(mentions(noisy.reason, "too noisy, or its points are strewn"));
  EXPECT_TRUE(missingOf(all, 0.5, 0.02).is_noisy);
}

} // namespace
