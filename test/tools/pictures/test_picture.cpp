// SPDX-License-Identifier: BSD-3-Clause
#include "pictures.h"
#include "plan_loops.h"
#include "rows_in_pieces.h"
#include "stage_pictures.h"

#include <pcl/point_types.h>
#include <pcl/sedr_filters/point_types.h>

namespace {

using namespace programs;
using Eigen::Vector2d;

constexpr Colour red = 0xff0000;
constexpr Colour blue = 0x0000ff;

Box
box(double x0, double y0, double x1, double y1)
{
  return {Vector2d(x0, y0), Vector2d(x1, y1)};
}

TEST(Panel, CellsSideBySideHaveNoSeam)
{
  for (const double size : {3 + 0.13 * 21, 3 + 0.13 * 31, 3 + 0.13 * 33}) {
    Panel panel("", box(-1.3, -1.3, size - 1.3, size - 1.3));
    panel.addCells({{red, block(-30, 150, -30, 150).keys()}}, 0.05);
    pcl::sedr::Sheet sheet;
    sheet.size = {600, 600};
    panel.draw({0, 0}, 600 / size, sheet);
    const Image image = imageOf(pcl::sedr::sheetPng(sheet));
    for (int y = 2; y < 598; ++y)
      EXPECT_EQ(image.at(300, y), red) << size << ' ' << y;
  }
}

TEST(ViewOf, StrayCellsFarAwayDoNotMakeTheRestSmall)
{
  const auto room = block(0, 99, 0, 79);
  const Box alone = viewOf(room, 0.05);
  EXPECT_TRUE(alone.contains(Box(Vector2d(0, 0), Vector2d(5, 4))));
  EXPECT_LT(alone.sizes().x(), 5.5);
  const Box with_stray = viewOf(unite(room, block(12000, 12000, 3, 3)), 0.05);
  EXPECT_NEAR(with_stray.sizes().x(), alone.sizes().x(), 0.3);
  EXPECT_GE(viewOf(unite(room, block(120, 129, 0, 9)), 0.05).max().x(), 6.5)
      << "what is not far away stays";
  EXPECT_TRUE(viewOf({}, 0.05).isEmpty());
}

TEST(Picture, ShowsItsMapsAtOneScale)
{
  std::vector<Panel> maps{Panel("", box(0, 0, 8, 3)), Panel("", box(5, 5, 7, 8))};
  maps[0].addPoints({{1.5, 1.5}}, red, 1);
  maps[1].addPoints({{6, 6.5}}, blue, 1);
  const Picture picture{"", maps};
  const Image image = imageOf(picture.png());
  const auto count = [&](Colour colour) {
    return static_cast<double>(
        std::count(image.pixels.begin(), image.pixels.end(), colour));
  };
  EXPECT_GT(count(red), 100 * 100);
  EXPECT_NEAR(count(red) / count(blue), 1, 0.03);
}

TEST(Picture, ItsScaleBarIsOneTwoOrFiveTimesAPowerOfTen)
{
  for (const auto& [width, bar] :
       {std::pair(40.0, 5.0), {10.0, 1.0}, {5.0, 0.5}, {3.0, 0.2}}) {
    const Image image = imageOf(Picture{"", {Panel("", box(0, 0, width, 2))}}.png());
    int longest = 0; // run of ink
    int run = 0;
    for (const Colour pixel : image.pixels)
      longest = std::max(longest, run = pixel == colours::ink ? run + 1 : 0);
    EXPECT_NEAR(longest, bar * std::min(1168 / width, 800 / 2.0), 2) << width;
  }
}

TEST(Picture, OfNothingIsStillAPicture)
{
  const Image empty = imageOf(Picture{"an empty map", {Panel("empty", {})}}.png());
  const Image nothing = imageOf(Picture{"nothing"}.png());
  EXPECT_GT(empty.height, nothing.height);
  EXPECT_EQ(nothing.at(0, 0), colours::paper) << "no scale bar";
}

using namespace pcl::sedr;

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
