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

TEST(SurfaceCells, OfABoxAreAsManyAsItsAreaHolds)
{
  const PlanRoom room = roomOf(rectangle(-1, -1, 3, 2), 2.5, 4);
  for (const double size : {0.05, 0.1, 0.25}) {
    const SurfaceCells cells(room, size);
    auto counts = countsOf(cells);
    EXPECT_EQ(counts[StructureLabel::Floor], std::lround(12 / (size * size)));
    EXPECT_EQ(counts[StructureLabel::Ceiling], std::lround(12 / (size * size)));
    EXPECT_EQ(counts[StructureLabel::Wall], std::lround(14 * 2.5 / (size * size)));
    EXPECT_EQ(counts.size(), 3u);
    for (const auto& cell : cells.cells()) {
      ASSERT_EQ(cell.centre.room, 4u);
      ASSERT_FALSE(cell.is_occupied);
    }
  }
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

TEST(SurfaceCells, OfAPlatformAndANicheAreAsManyAsTheirAreasHold)
{
  PlanRoom room = roomOf(rectangle(0, 0, 4, 3), 2.5);
  const double size = 0.05;
  const double cell = size * size;
  room.floor_details = {detailOf(rectangle(0, 0, 1, 2), 0.4)};
  room.niches = {{rectangle(4, 1, 4.3, 2), slabAt(1), slabAt(2)}};
  auto counts = countsOf(SurfaceCells(room, size));
  EXPECT_EQ(counts[StructureLabel::Floor], std::lround(10 / cell));
  EXPECT_EQ(counts[StructureLabel::Ceiling], std::lround(12 / cell));
  EXPECT_EQ(counts[StructureLabel::Wall], std::lround((14 * 2.5 - 3 * 0.4 - 1) / cell));
  const double platform = 1 * 2 + 3 * 0.4;
  const double niche = 1.0 * 1.6 + 2 * 0.3;
  EXPECT_EQ(counts[StructureLabel::Detail], std::lround((platform + niche) / cell));
}

TEST(SurfaceCells, CoverTheStructureEvenly)
{
  const double size = 0.2;
  const SurfaceCells cells(roomOf(rectangle(0, 0, 3, 2), 2), size);
  for (const auto& a : cells.cells()) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& b : cells.cells())
      if (&a != &b)
        nearest = std::min(nearest, (a.centre.position - b.centre.position).norm());
    ASSERT_GE(nearest, 0.7 * size); // across an edge: each half a cell from it
    ASSERT_LE(nearest, 1.001 * size);
  }
}

TEST(SurfaceCells, StripsHaveEqualPartsOfNearlyTheSize)
{
  // 1.13 m x 0.93 m in 5 cm: 23 columns of 4.91 cm, 19 rows of 4.89 cm.
  const SurfaceCells cells(roomOf(rectangle(0, 0, 1.13, 1.13), 0.93), 0.05);
  EXPECT_EQ(countsOf(cells)[StructureLabel::Wall], 4u * 23u * 19u);
  EXPECT_NEAR(cells.cells()[0].centre.position.z(), 0.93 / 38, 1e-12);
  EXPECT_NEAR(cells.cells()[0].centre.position.x(), 1.13 / 46, 1e-12);
}

TEST(SurfaceCells, ARiserOfLessThanACentimetreIsNone)
{
  PlanRoom room = roomOf(rectangle(0, 0, 4, 3), 2.5);
  room.details = {detailOf(rectangle(2, 0, 4, 3), 2.492)};
  const auto isRiser = [](const SurfaceCell& cell) {
    return cell.centre.label == StructureLabel::Detail && cell.centre.normal.z() == 0;
  };
  const SurfaceCells flat(room, 0.05);
  EXPECT_TRUE(std::none_of(flat.cells().begin(), flat.cells().end(), isRiser));
  room.details[0].slab = slabAt(2.48);
  const SurfaceCells stepped(room, 0.05);
  EXPECT_EQ(std::count_if(stepped.cells().begin(), stepped.cells().end(), isRiser), 60)
      << "one row along 3 m";
}

TEST(SurfaceCells, EveryCellIsFoundByItsOwnCentreOnce)
{
  const PlanRoom room = richRoom();
  SurfaceCells cells(room, 0.05);
  const std::vector<SurfaceCell> empty = cells.cells();
  for (std::size_t i = 0; i < empty.size(); ++i)
    ASSERT_TRUE(cells.occupy(empty[i].centre, i)) << i;
  for (std::size_t i = 0; i < empty.size(); ++i) {
    ASSERT_TRUE(cells.cells()[i].is_occupied) << i;
    ASSERT_EQ(cells.cells()[i].source, i);
    ASSERT_NEAR(cells.cells()[i].distance, 0, 1e-12);
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

TEST(SurfaceCells, ThePointsOfAnUndersideAndOfItsRiserDoNotMix)
{
  PlanRoom room = roomOf(rectangle(0, 0, 4, 3), 2.5);
  room.details = {detailOf(rectangle(3, 0, 4, 3), 2.1)};
  SurfaceCells cells(room, 0.1);
  SurfacePoint p;
  p.label = StructureLabel::Detail;
  p.position = {3.001, 1.45, 2.101};
  p.normal = {0, 0, -1};
  EXPECT_TRUE(cells.occupy(p, 1));
  p.normal = {-1, 0, 0};
  EXPECT_TRUE(cells.occupy(p, 2));
  for (const auto& cell : cells.cells())
    if (cell.is_occupied) {
      EXPECT_EQ(cell.source, cell.centre.normal.z() < 0 ? 1u : 2u);
    }
}

TEST(SurfaceCells, WhatIsOnNoSurfaceIsRefused)
{
  const PlanRoom room = roomOf(rectangle(0, 0, 4, 3), 2.5);
  SurfaceCells cells(room, 0.1);
  SurfacePoint p;
  p.label = StructureLabel::Floor;
  p.normal = {0, 0, 1};
  p.position = {5, 1, 0};
  EXPECT_FALSE(cells.occupy(p, 1)) << "beside the room";
  p.position = {-0.01, 1, 0};
  EXPECT_FALSE(cells.occupy(p, 1));
  p.label = StructureLabel::Column;
  p.normal = {1, 0, 0};
  p.position = {4, 1, 1};
  EXPECT_FALSE(cells.occupy(p, 1)) << "no column there";
  p.label = StructureLabel::Wall;
  p.position = {4, 1, 2.6};
  EXPECT_FALSE(cells.occupy(p, 1)) << "above the wall";
  for (const auto& cell : cells.cells())
    EXPECT_FALSE(cell.is_occupied);
}

TEST(SurfaceCells, ARoomWithoutAnOutlineHasNone)
{
  EXPECT_TRUE(SurfaceCells(PlanRoom(), 0.05).cells().empty());
}

} // namespace
