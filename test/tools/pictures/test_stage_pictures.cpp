// SPDX-License-Identifier: BSD-3-Clause
#include "pictures.h"
#include "plan_loops.h"
#include "rows_in_pieces.h"
#include "stage_pictures.h"

#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <cmath>
#include <pcl/sedr_filters/point_types.h>
#include <utility>

namespace {

using namespace programs;
using namespace pcl::sedr;
using Eigen::Vector2d;

constexpr double cell = label_cell;

/** Returns the middle of a cell. */
Vector2d
at(int x, int y)
{
  return CellGrid(cell).centre({x, y});
}

/** Adds points of a label, before and after a stage, to the cells of a block. */
void
add(CellChanges& changes,
    StructureLabel label,
    const CellSet& cells,
    std::size_t before,
    std::size_t after)
{
  for (const CellKey key : cells.keys()) {
    changes[key][0][static_cast<std::size_t>(label)] += before;
    changes[key][1][static_cast<std::size_t>(label)] += after;
  }
}

TEST(LabelPicture, ShowsWhatCameAndWhatWent)
{
  CellChanges changes;
  add(changes, StructureLabel::Floor, block(5, 24, 0, 29), 2, 2);
  add(changes, StructureLabel::Floor, block(0, 4, 0, 29), 2, 5); // 3 of 5 are new
  add(changes, StructureLabel::Floor, block(45, 59, 0, 9), 2, 0);
  add(changes, StructureLabel::Floor, block(25, 39, 0, 29), 0, 1);
  add(changes, StructureLabel::Other, block(60, 69, 0, 29), 2, 2);
  add(changes, StructureLabel::Wall, block(0, 69, 30, 31), 0, 1);
  add(changes, StructureLabel::Ceiling, block(0, 39, 0, 29), 1, 1);
  const Picture picture = drawLabels(changes);
  EXPECT_EQ(colourAt(picture, 0, at(10, 5)), colours::floor) << "ceilings are the same";
  EXPECT_EQ(colourAt(picture, 0, at(30, 5)), colours::recovered);
  EXPECT_EQ(colourAt(picture, 0, at(50, 5)), colours::removed);
  EXPECT_EQ(colourAt(picture, 0, at(65, 5)), colours::faint) << "of no label";
  EXPECT_EQ(colourAt(picture, 0, at(2, 5)),
            mixed(colours::floor, colours::recovered, 0.6));
  EXPECT_EQ(colourAt(picture, 1, at(10, 30)), colours::wall) << "no wall was there";
}

/** Adds profiles of a room with air from the floor to `ceiling`. */
void
addColumns(BuildingRoom& room, const CellSet& cells, float ceiling, bool is_seen)
{
  for (std::size_t i = 0; i < cells.size(); ++i)
    room.columns.push_back({cells[i], 0, ceiling, is_seen, true});
}

TEST(RoomPicture, ShowsRoomsByStoreyWhatWasHiddenOfThemAndTheirHeights)
{
  Building building;
  building.grid = CellGrid(cell);
  building.rooms.resize(3);
  addColumns(building.rooms[0], block(0, 29, 0, 29), 2.5, true);
  addColumns(building.rooms[1], block(32, 59, 0, 19), 4, true);
  addColumns(building.rooms[1], block(32, 59, 20, 29), 4, false);
  addColumns(building.rooms[2], block(0, 59, 0, 29), 2.5, true);
  const std::uint32_t storeys[] = {1, 1, 2};
  for (std::uint32_t r = 0; r < 3; ++r) {
    building.rooms[r].id = r + 1;
    building.rooms[r].storey = storeys[r];
  }
  for (const std::uint32_t number : {1u, 2u}) {
    PlanStorey storey;
    storey.number = number;
    building.storeys.push_back(storey);
  }
  const Picture picture = drawRooms(building);
  const Colour one = colourAt(picture, 0, at(2, 2));
  const Colour other = colourAt(picture, 0, at(40, 2));
  const Colour hidden = colourAt(picture, 0, at(55, 26));
  EXPECT_NE(one, other);
  EXPECT_EQ(hidden, darkened(other, 0.25));
  EXPECT_EQ(colourAt(picture, 0, at(30, 2)), colours::paper);
  EXPECT_NE(colourAt(picture, 2, at(30, 2)), colours::paper) << "of the upper storey";
  EXPECT_LT(colourAt(picture, 1, at(2, 2)), colourAt(picture, 1, at(40, 2)))
      << "the lower ceiling is darker";
}

TEST(PlanPicture, TellsBoundaryPointsOnAWallFromOthers)
{
  FittedBoundary boundary;
  for (const double support : {1.0, 0.0})
    boundary.samples.push_back(
        {Vector2d(1 + support, 1), Vector2d(1 + support, 1), Vector2d(1, 0), support});
  const Picture picture = drawPlan(
      {{sedr_test::roomOf(sedr_test::rectangle(0, 0, 4, 3), 2.5)}}, {boundary});
  EXPECT_EQ(colourAt(picture, 0, {2, 1}), colours::wall);
  EXPECT_EQ(colourAt(picture, 0, {1, 1}), colours::recovered);
  EXPECT_EQ(colourAt(picture, 1, {2, 0}), colours::ink) << "a segment";
  EXPECT_EQ(colourAt(picture, 1, {3, 1}), colours::paper);
}

} // namespace
