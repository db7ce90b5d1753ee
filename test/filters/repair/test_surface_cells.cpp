// SPDX-License-Identifier: BSD-3-Clause
#include "plan_loops.h"

#include "sedr_filters/src/repair/surface_cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;
using Eigen::Vector3d;

/** An L-shaped room with every kind of surface: a curved wall, two columns, a soffit
 * around with a beam on it, a recess, a platform in a corner, a pit and a niche. */
PlanRoom
richRoom()
{
  PlanRoom room =
      roomOf({{segment({0, 0}, {5, 0}), segment({5, 0}, {5, 2}), arc({4, 2}, 1, 0, 90),
               segment({4, 3}, {2, 3}), segment({2, 3}, {2, 4.5}),
               segment({2, 4.5}, {0, 4.5}), segment({0, 4.5}, {0, 0})}},
             2.6);
  room.columns = {reversed(rectangle(1, 2, 1.3, 2.3)),
                  reversed(circle({3.5, 1}, 0.25))};
  room.details = {detailOf(rectangle(0, 0, 5, 0.8), 2.3),
                  detailOf(rectangle(2.2, 0, 2.6, 3), 2.0),
                  detailOf(rectangle(0.4, 3.2, 1.6, 4.1), 2.9)};
  room.floor_details = {detailOf(rectangle(0, 3.5, 1, 4.5), 0.35),
                        detailOf(rectangle(2.2, 1.2, 3, 2.5), -0.4)};
  room.niches = {{rectangle(-0.3, 1, 0, 2.2), slabAt(0.8), slabAt(1.9)}};
  return room;
}

std::map<StructureLabel, std::size_t>
countsOf(const SurfaceCells& cells)
{
  std::map<StructureLabel, std::size_t> counts;
  for (const auto& cell : cells.cells())
    ++counts[cell.centre.label];
  return counts;
}

/** Returns true if `p` is in the air of the room. */
bool
isAir(const PlanRoom& room, const Vector3d& p)
{
  const Eigen::Vector2d place = p.head<2>();
  const int n = room.nicheAt(place);
  if (n >= 0 && !room.boundary.contains(place))
    return p.z() > room.niches[n].bottom.heightAt(place) &&
           p.z() < room.niches[n].top.heightAt(place);
  return room.contains(place) && p.z() > room.floorAt(place) &&
         p.z() < room.ceilingAt(place);
}

TEST(SurfaceCells, OfAnyRoomAreNearlyAsManyAsItsAreaHolds)
{
  const PlanRoom room = richRoom();
  const double size = 0.05;
  auto counts = countsOf(SurfaceCells(room, size));
  EXPECT_NEAR(static_cast<double>(counts[StructureLabel::Floor]) * size * size,
              room.area() - 1 - 0.8 * 1.3, 0.01 * room.area()); // platform and pit
  const double around = 4 * 0.3 * 2.6 + M_PI / 2 * (2.6 + 2.3) / 2;
  // Half of the round column is below the soffit: its lower edge is at y = 0.75.
  EXPECT_NEAR(static_cast<double>(counts[StructureLabel::Column]) * size * size, around,
              0.08 * around);
}

TEST(SurfaceCells, LieOnTheStructureWithNormalsIntoTheRoom)
{
  const PlanRoom room = richRoom();
  const SurfaceCells cells(room, 0.05);
  for (const auto& cell : cells.cells()) {
    const SurfacePoint& c = cell.centre;
    ASSERT_NEAR(c.normal.norm(), 1, 1e-9);
    ASSERT_TRUE(isAir(room, c.position + 0.005 * c.normal))
        << c.position.transpose() << " towards " << c.normal.transpose() << ", "
        << toString(c.label);
    ASSERT_FALSE(isAir(room, c.position - 0.005 * c.normal))
        << c.position.transpose() << " towards " << c.normal.transpose() << ", "
        << toString(c.label);
  }
}

TEST(SurfaceCells, ThePointNearestToTheCentreStandsForItsCell)
{
  const PlanRoom room = roomOf(rectangle(0, 0, 4, 3), 2.5);
  SurfaceCells cells(room, 0.1);
  const SurfacePoint centre = cells.cells()[0].centre;
  for (const double off : {0.03, 0.01, 0.02}) {
    SurfacePoint p = centre;
    p.position.z() += off;
    EXPECT_TRUE(cells.occupy(p, static_cast<std::size_t>(off * 1000 + 0.5)));
  }
  EXPECT_EQ(cells.cells()[0].source, 10u);
  EXPECT_NEAR(cells.cells()[0].distance, 0.01, 1e-12);
  EXPECT_FALSE(cells.cells()[1].is_occupied);
}

} // namespace
