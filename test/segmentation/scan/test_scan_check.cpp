// SPDX-License-Identifier: BSD-3-Clause
// What programs and the chain show of a scan's faults by one case each.
#include "room_points.h"

#include "sedr_segmentation/src/scan/scan_check.h"

#include <gtest/gtest.h>

#include <string>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** A plan of rooms of equal area, too far apart for walls unless there are two. */
struct UnitCase {
  std::vector<double> heights;
  double area;
  const char* told; ///< empty: the unit is the metre
  double door = 0;  ///< height of a link, 0: none
  std::vector<float> scanners{};
  double apart = 5; ///< of rooms
};

TEST(FootProblem, IsToldByRoomsDoorsWallsAndScanners)
{
  for (const UnitCase& c : std::vector<UnitCase>{
           {{8, 8.5, 10}, 150, "the largest room is 8.0 m high and 150 m2 large"},
           {{8, 8.5, 10}, 150, "--unit 0.3048"},
           {{10.6}, 240, "the room is 10.6 m high"},
           {{10.6}, 600, "--unit 0.3048"},
           {{8, 8}, 150, "--unit 0.3048", 6.7},
           {{8, 8}, 150, "", 2.1}, // halls with doors of metres
           {{8, 8}, 150, "", 4},   // portals, which nobody passes in feet
           {{8, 8}, 150, "walls 1.00 m thick", 6, {}, 1},
           {{8, 8.5, 10}, 600, "the scanner stood 5.", 0, {5.2F, 5.4F, -2}},
           {{21}, 6000, "--unit 0.3048"},
           {{21}, 6000, "", 0, {1.6F}},
           {{21}, 6000, "6000 m2 large, doors are 6.7 m high", 6.7},
           {{21}, 6000, "", 6.7, {1.6F}},             // gates, not doors
           {{10.6}, 240, "", 0, {1.6F}},              // as high as a door of metres
           {{10.6}, 240, "--unit 0.3048", 0, {9.5F}}, // a camera below the ceiling
           {{2.5, 2.4, 3}, 15, ""},
           {{8, 8, 2.6}, 150, ""}, // halls and a room beside them
           {{4, 6, 6.5}, 600, ""}, // three large halls
           {{6}, 60, ""},          // one hits one's head in feet
           {{6}, 400, ""},
           {{}, 0, ""}}) {
    Floorplan plan;
    double x = 0;
    for (const double height : c.heights) {
      plan.rooms.push_back(roomOf(rectangle(x, 0, x + c.area / 10, 10), height));
      x += c.area / 10 + c.apart;
    }
    std::vector<RoomLink> links(c.door > 0 ? 1 : 0);
    for (RoomLink& link : links)
      link.top = c.door;
    std::vector<Eigen::Vector3f> places;
    for (const float z : c.scanners)
      places.emplace_back(3, 3, z);
    const std::string told = footProblem(plan, links, places).reason;
    SCOPED_TRACE(testing::Message() << plan.rooms.size() << " rooms, " << c.area
                                    << " m2, " << c.told << ": " << told);
    EXPECT_EQ(told.empty(), *c.told == 0);
    EXPECT_NE(told.find(c.told), std::string::npos);
  }
}

TEST(MissingSurfaces, OfNoisyOrStrewnPointsAreAllOfThemAndSparseOnesAreTold)
{
  const auto missingOf = [](double scatter, double spacing) {
    RoomPoints room(spacing);
    room.room(rectangle(0, 0, 6, 4), 0, 2.5);
    RoomPoints result;
    std::mt19937 random(1);
    std::normal_distribution<double> off(0, scatter);
    for (const int i : room.all())
      result.point(room[i].x() + off(random), room[i].y() + off(random),
                   room[i].z() + off(random));
    return missingSurfaces(result.view(), result.all(), 1);
  };
  EXPECT_EQ(missingOf(0, 0.05).reason, "");
  EXPECT_NE(missingOf(0, 0.25).reason.find("too sparse"), std::string::npos);
  EXPECT_FALSE(missingOf(0.01, 0.05).is_noisy);
  EXPECT_TRUE(missingOf(0.5, 0.02).is_noisy);
  const MissingSurfaces noisy = missingOf(0.06, 0.05);
  EXPECT_TRUE(noisy.is_noisy);
  EXPECT_NE(noisy.reason.find("too noisy, or its points are strewn"),
            std::string::npos);
}

/** Returns the cells of 5 cm with points of a ceiling of 6 m x 5 m from x0 on,
 * scattered independently at `density` per square metre. */
CellSet
scattered(double density, double x0)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> x(x0, x0 + 6);
  std::uniform_real_distribution<double> y(-1, 4);
  const CellGrid grid(0.05);
  std::vector<CellKey> keys;
  for (int i = 0; i < static_cast<int>(30 * density); ++i) {
    const double px = x(random);
    keys.push_back(keyOf(grid.at(px, y(random))));
  }
  return CellSet(std::move(keys));
}

TEST(CellSize, GrowsForASparseThirdOfAScanOnlyWhereTheRestIsNotFilled)
{
  // 1000 points per square metre fill 92 % of the cells of 5 cm, 2200 fill 99.6 %.
  for (const double rest : {1000.0, 2200.0}) {
    const std::vector<CellSet> ceilings{scattered(rest, -2), scattered(rest, 20),
                                        scattered(400, 40)};
    const double expected = rest < 1500 ? std::sqrt(-std::log(0.03) / 400) : 0.05;
    EXPECT_NEAR(expected, cellSizeFor(ceilings, 0.05), 0.02) << rest;
  }
}

} // namespace
