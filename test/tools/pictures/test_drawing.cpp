// SPDX-License-Identifier: BSD-3-Clause
#include "pictures.h"
#include "scale.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace programs;
using Eigen::Vector2d;

constexpr Colour red{255, 0, 0};
constexpr Colour blue{0, 0, 255};

std::size_t
countOf(const Image& image, Colour colour)
{
  return static_cast<std::size_t>(
      std::count(image.pixels.begin(), image.pixels.end(), colour));
}

TEST(Canvas, ABoxCoversItsPixelsAndNoOthers)
{
  Canvas canvas(20, 10);
  canvas.fillBox({{3, 2}, {7, 5}}, red);
  const Image image = canvas.image();
  EXPECT_EQ(image.width, 20);
  EXPECT_EQ(image.height, 10);
  for (int y = 0; y < 10; ++y)
    for (int x = 0; x < 20; ++x)
      EXPECT_EQ(image.at(x, y),
                x >= 3 && x < 7 && y >= 2 && y < 5 ? red : colours::paper)
          << x << ' ' << y;
}

TEST(Canvas, TheEdgeOfAShapeIsMixedWithTheGround)
{
  Canvas canvas(4, 4);
  canvas.fillBox({{0, 0}, {4.0 / 3, 4}}, red); // a third of the second column
  EXPECT_EQ(canvas.image().at(0, 1), red);
  EXPECT_EQ(canvas.image().at(1, 1), (Colour{255, 170, 170}));
  EXPECT_EQ(canvas.image().at(2, 1), colours::paper);
}

TEST(Canvas, ABoxOfNoWidthStillShows)
{
  Canvas canvas(4, 4);
  canvas.fillBox({{2.5, 1.5}, {2.5, 1.5}}, red);
  EXPECT_NE(canvas.image().at(2, 1), colours::paper);
}

TEST(Canvas, DiscsAndLinesHaveTheAreaThatTheyShould)
{
  Canvas disc(100, 100);
  disc.drawDisc({50, 50}, 30, red);
  EXPECT_NEAR(static_cast<double>(countOf(disc.image(), red)), M_PI * 900, 120);
  EXPECT_EQ(disc.image().at(50, 21), red);
  EXPECT_EQ(disc.image().at(50, 18), colours::paper);

  Canvas line(100, 100);
  line.drawLine({20, 20}, {80, 80}, 6, blue);
  const Image image = line.image();
  const double area = std::hypot(60, 60) * 6 + M_PI * 9;
  EXPECT_NEAR(static_cast<double>(countOf(image, blue)), area, 0.25 * area);
  EXPECT_EQ(image.at(50, 50), blue);
  EXPECT_EQ(image.at(55, 44), colours::paper);
}

TEST(Canvas, NothingShowsBeyondTheClip)
{
  Canvas canvas(20, 20);
  canvas.setClip({{5, 5}, {10, 10}});
  canvas.fillBox({{-100, -100}, {100, 100}}, red);
  canvas.drawDisc({0, 0}, 1000, blue);
  EXPECT_EQ(countOf(canvas.image(), blue), 25u);
  EXPECT_EQ(countOf(canvas.image(), colours::paper), 375u);
}

TEST(Canvas, TheNearerTriangleHidesTheFartherInAnyOrder)
{
  const std::array<Eigen::Vector3d, 3> near{Eigen::Vector3d(0, 0, 1),
                                            {20, 0, 1},
                                            {0, 20, 1}};
  std::array<Eigen::Vector3d, 3> far = near;
  for (auto& corner : far)
    corner.z() = 2;
  for (const bool near_first : {true, false}) {
    Canvas canvas(20, 20);
    canvas.fillTriangle(near_first ? near : far, near_first ? red : blue);
    canvas.fillTriangle(near_first ? far : near, near_first ? blue : red);
    EXPECT_EQ(canvas.image().at(4, 4), red);
    EXPECT_EQ(canvas.image().at(18, 18), colours::paper);
  }
}

TEST(Canvas, TrianglesThatShareAnEdgeLeaveNoGap)
{
  Canvas canvas(30, 30);
  const Eigen::Vector3d a(1.3, 2.1, 0), b(28.7, 1.2, 0), c(27.9, 28.4, 0),
      d(2.2, 27.6, 0);
  canvas.fillTriangle({a, b, c}, red);
  canvas.fillTriangle({a, c, d}, red);
  for (int k = 4; k < 27; ++k)
    EXPECT_EQ(canvas.image().at(k, k), red) << k;
}

TEST(Text, IsAsWideAsItsLettersAndStandsAtItsAnchor)
{
  Text text;
  text.line = "mmmm";
  const int four = widthOf(text);
  text.line = "mmmmmmmm";
  EXPECT_NEAR(widthOf(text), 2 * four, 4);
  EXPECT_GT(four, 20);
  for (const Anchor anchor : {Anchor::Left, Anchor::Middle, Anchor::Right}) {
    text.x = 150;
    text.y = 20;
    text.anchor = anchor;
    Image image(300, 40, colours::paper);
    drawText(text, image);
    int left = 300;
    int right = 0;
    for (int y = 0; y < 40; ++y)
      for (int x = 0; x < 300; ++x)
        if (image.at(x, y) != colours::paper) {
          left = std::min(left, x);
          right = std::max(right, x);
        }
    const double at = anchor == Anchor::Left    ? left
                      : anchor == Anchor::Right ? right
                                                : (left + right) / 2.0;
    EXPECT_NEAR(at, 150, 3);
  }
}

TEST(Panel, ShowsACellWhereItIsAndLaterShapesOverEarlier)
{
  Panel panel("");
  panel.addCells(block(0, 9, 0, 9), 0.1, red);
  panel.addCells(block(2, 3, 7, 7), 0.1, blue);
  panel.setView({{-1, -1}, {2, 2}});
  EXPECT_EQ(colourAt(panel, 0.25, 0.75), blue);
  EXPECT_EQ(colourAt(panel, 0.35, 0.75), blue);
  EXPECT_EQ(colourAt(panel, 0.45, 0.75), red);
  EXPECT_EQ(colourAt(panel, 0.25, 0.85), red);
  EXPECT_EQ(colourAt(panel, 0.95, 0.05), red);
  EXPECT_EQ(colourAt(panel, 1.05, 0.05), colours::paper);
  EXPECT_EQ(colourAt(panel, -0.05, 0.05), colours::paper);
}

TEST(Panel, CellsOfNegativeColumnsAndOfTwoRowsStayApart)
{
  Panel panel("");
  panel.addCells(unite(block(-5, -3, -2, -2), block(4, 6, -1, -1)), 1, red);
  panel.setView({{-8, -8}, {8, 8}});
  EXPECT_EQ(colourAt(panel, -3.5, -1.5), red);
  EXPECT_EQ(colourAt(panel, 4.5, -0.5), red);
  for (const double x : {-6.5, -1.5, 2.5, 7.5}) {
    EXPECT_EQ(colourAt(panel, x, -1.5), colours::paper) << x;
    EXPECT_EQ(colourAt(panel, x, -0.5), colours::paper) << x;
  }
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
  EXPECT_EQ(colourAt(panel, 0, 0), red);
  EXPECT_EQ(colourAt(panel, 0, 1), blue);
  EXPECT_EQ(colourAt(panel, std::sqrt(0.5), std::sqrt(0.5)), blue);
  EXPECT_EQ(colourAt(panel, 0, 0.5), colours::paper);
}

TEST(Panel, ViewsEveryShapeWithAMargin)
{
  Panel panel("");
  EXPECT_TRUE((panel.view().size().array() > 0).all()) << "of nothing too";
  panel.addPoints({Vector2d(-3, 5)}, red);
  EXPECT_TRUE((panel.view().size().array() > 0).all()) << "of one point too";
  panel.addPath({Vector2d(4, 1), Vector2d(2, 2)}, red);
  const Box view = panel.view();
  EXPECT_LT(view.low.x(), -3);
  EXPECT_LT(view.low.y(), 1);
  EXPECT_GT(view.high.x(), 4);
  EXPECT_GT(view.high.y(), 5);
  EXPECT_LT(view.size().x(), 8);
}

TEST(ViewOf, StrayCellsFarAwayDoNotMakeTheRestSmall)
{
  const auto room = block(0, 99, 0, 79);
  const Box alone = viewOf(room, 0.05);
  EXPECT_LE(alone.low.x(), 0);
  EXPECT_GE(alone.high.x(), 5);
  EXPECT_LT(alone.size().x(), 5.5);
  const Box with_stray = viewOf(unite(room, block(12000, 12000, 3, 3)), 0.05);
  EXPECT_NEAR(with_stray.size().x(), alone.size().x(), 0.2);
  const Box with_piece = viewOf(unite(room, block(120, 129, 0, 9)), 0.05);
  EXPECT_GE(with_piece.high.x(), 130 * 0.05) << "what is not far away stays";
  const Box large = viewOfPieces(unite(room, block(120, 129, 0, 9)), 0.05, 200);
  EXPECT_LT(large.high.x(), 120 * 0.05) << "but is no large piece";
  EXPECT_TRUE(viewOf({}, 0.05).isEmpty());
}

TEST(Scale, LengthsAreRound)
{
  EXPECT_NEAR(roundStep(7.3), 5, 1e-12);
  EXPECT_NEAR(roundStep(4.99), 2, 1e-12);
  EXPECT_NEAR(roundStep(0.0019), 0.001, 1e-15);
  EXPECT_NEAR(roundStep(1000), 1000, 1e-9);
  EXPECT_EQ(lengthText(5), "5 m");
  EXPECT_EQ(lengthText(0.2), "20 cm");
  EXPECT_EQ(lengthText(0.002), "2 mm");
  EXPECT_EQ(fixedText(-0.0001, 2), "0.00");
  EXPECT_EQ(fixedText(-1.005, 1), "-1.0");
  EXPECT_EQ(digitsOf(0.05), 2);
  EXPECT_EQ(digitsOf(20), 0);
}

Picture
samplePicture()
{
  Panel map("map");
  map.addCells(block(0, 39, 0, 29), 0.05, colours::ceiling);
  map.addLabel({1, 0.7}, "1");
  Panel chart("chart");
  chart.setAxis("x, m");
  chart.addBoxes({{{0, 0}, {2, 3}}}, colours::floor);
  Picture picture("A picture");
  picture.addMaps({map, map, map});
  picture.addRow({chart, map});
  picture.addLegend("ceiling", colours::ceiling);
  picture.addNote("a note");
  return picture;
}

TEST(Picture, DecodesToWhatWasDrawnAndIsTheSameEveryTime)
{
  const Image drawn = samplePicture().draw();
  const std::string png = pngOf(drawn);
  EXPECT_EQ(png.substr(1, 3), "PNG");
  const Image decoded = imageOf(png);
  ASSERT_EQ(decoded.width, drawn.width);
  ASSERT_EQ(decoded.height, drawn.height);
  EXPECT_TRUE(decoded.pixels == drawn.pixels);
  EXPECT_EQ(pngOf(samplePicture().draw()), png);
  EXPECT_LE(drawn.width, 1200);
  // Four maps and the legend use the ceiling's colour; only the chart uses the floor's.
  EXPECT_GT(countOf(drawn, colours::ceiling), 4u * 100u * 100u);
  EXPECT_GT(countOf(drawn, colours::floor), 50u * 50u);
}

TEST(Picture, OfAFlatBuildingHasItsMapsBelowEachOther)
{
  Panel corridor("corridor");
  corridor.addCells(block(0, 799, 0, 39), 0.05, colours::ceiling);
  Picture flat("flat");
  flat.addMaps({corridor, corridor, corridor});
  EXPECT_EQ(flat.rows().size(), 3u);
  Panel tower("tower");
  tower.addCells(block(0, 39, 0, 399), 0.05, colours::ceiling);
  Picture tall("tall");
  tall.addMaps({tower, tower, tower});
  EXPECT_EQ(tall.rows().size(), 1u);
}

TEST(Picture, OfNothingIsStillAPicture)
{
  const Image image = Picture("nothing").draw();
  EXPECT_GT(image.width, 100);
  EXPECT_GT(image.height, 20);
  Picture empty("an empty map");
  empty.addMaps({Panel("empty")});
  EXPECT_GT(empty.draw().height, image.height);
}

} // namespace
