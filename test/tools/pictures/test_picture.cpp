// SPDX-License-Identifier: BSD-3-Clause
#include "pictures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace programs;
using Eigen::Vector2d;

constexpr Colour red{255, 0, 0};
constexpr Colour blue{0, 0, 255};

TEST(Panel, ShowsACellWhereItIsAndLaterShapesOverEarlier)
{
  Panel panel("");
  panel.addCells(block(0, 9, 0, 9), 0.1, red);
  panel.addCells(unite(block(2, 3, 7, 7), block(-5, -3, -2, -2)), 0.1, blue);
  panel.setView({Vector2d(-1, -1), Vector2d(2, 2)});
  EXPECT_EQ(colourAt(panel, {0.25, 0.75}), blue);
  EXPECT_EQ(colourAt(panel, {0.35, 0.75}), blue);
  EXPECT_EQ(colourAt(panel, {0.45, 0.75}), red);
  EXPECT_EQ(colourAt(panel, {0.25, 0.85}), red);
  EXPECT_EQ(colourAt(panel, {-0.35, -0.15}), blue);
  EXPECT_EQ(colourAt(panel, {1.05, 0.05}), colours::paper);
  EXPECT_EQ(colourAt(panel, {-0.05, 0.05}), colours::paper);
}

TEST(Panel, CellsSideBySideHaveNoSeam)
{
  Panel panel("");
  panel.addCells(block(0, 6, 0, 6), 1, red); // of 85.7 pixels
  panel.setView({Vector2d(0, 0), Vector2d(7, 7)});
  for (int row = 1; row < 7; ++row)
    EXPECT_EQ(colourAt(panel, {3.2, row}), red) << row;
}

TEST(Panel, DrawsSegmentsAndArcsOfALoopEachInItsColour)
{
  pcl::sedr::PlanLoop half_disc;
  pcl::sedr::PlanElement chord;
  chord.start = {-1, 0};
  chord.end = {1, 0};
  pcl::sedr::PlanElement arc;
  arc.start = {1, 0};
  arc.end = {-1, 0};
  arc.radius = 1;
  half_disc.elements = {chord, arc};
  Panel panel("");
  panel.addLoop(half_disc, red, blue, 6);
  panel.setView({Vector2d(-2, -2), Vector2d(2, 2)});
  EXPECT_EQ(colourAt(panel, {0, 0}), red);
  EXPECT_EQ(colourAt(panel, {0, 1}), blue);
  EXPECT_EQ(colourAt(panel, {std::sqrt(0.5), std::sqrt(0.5)}), blue);
  EXPECT_EQ(colourAt(panel, {0, 0.5}), colours::paper);
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

TEST(Picture, IsTheSameEveryTimeAndShowsItsPanels)
{
  Panel map("map");
  map.addCells(block(0, 39, 0, 29), 0.05, colours::ceiling);
  map.addLabel({1, 0.7}, "1");
  Panel other("other");
  other.addBoxes({Box(Vector2d(0, 0), Vector2d(2, 3))}, colours::floor);
  Picture picture("A picture");
  picture.addMaps({map, map, map});
  picture.addMaps({other, map});
  picture.addLegend("ceiling", colours::ceiling);
  EXPECT_EQ(picture.png(), picture.png());
  const Image image = imageOf(picture.png());
  EXPECT_LE(image.width, 1200);
  const auto countOf = [&](Colour colour) {
    return std::count(image.pixels.begin(), image.pixels.end(), colour);
  };
  // Four maps and the legend use the ceiling's colour; only one map uses the floor's.
  EXPECT_GT(countOf(colours::ceiling), 4 * 100 * 100);
  EXPECT_GT(countOf(colours::floor), 50 * 50);
}

TEST(Picture, OfAFlatBuildingHasItsMapsBelowEachOther)
{
  const auto rowsOf = [](const pcl::sedr::CellSet& cells) {
    Panel panel("");
    panel.addCells(cells, 0.05, colours::ceiling);
    Picture picture("");
    picture.addMaps({panel, panel, panel});
    return picture.rows().size();
  };
  EXPECT_EQ(rowsOf(block(0, 799, 0, 39)), 3u);
  EXPECT_EQ(rowsOf(block(0, 39, 0, 399)), 1u);
}

TEST(Picture, OfNothingIsStillAPicture)
{
  Picture empty("an empty map");
  empty.addMaps({Panel("empty")});
  EXPECT_GT(imageOf(empty.png()).height, imageOf(Picture("nothing").png()).height);
}

} // namespace
