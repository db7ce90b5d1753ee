// SPDX-License-Identifier: BSD-3-Clause
#include "pictures.h"

#include <gtest/gtest.h>

#include <cmath>

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

} // namespace
