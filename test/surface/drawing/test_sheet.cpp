// SPDX-License-Identifier: BSD-3-Clause
#include "plan_loops.h"

#include "sedr_surface/src/sheet/sheet.h"
#include "sedr_surface/src/sheet/text_places.h"

#include <gtest/gtest.h>

#include <string>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

bool
hasPart(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

/** A disc and a text on a card. */
Sheet
card()
{
  Sheet sheet;
  sheet.size = {80, 50};
  sheet.title = "Card & more";
  sheet.add(SheetGroup{"disc"});
  sheet.add(SheetPath{{0xff0000}, {circle({20, 30}, 10)}, true});
  sheet.add(SheetGroup{"words"});
  sheet.add(SheetText{ink, {60, 10}, 5, "Ø < 2", 90});
  return sheet;
}

TEST(Sheet, OfAnyFormatIsTheSameEveryTime)
{
  EXPECT_EQ(sheetSvg(card()), sheetSvg(card()));
  EXPECT_EQ(sheetPdf(card()), sheetPdf(card()));
  EXPECT_EQ(sheetPng(card()), sheetPng(card()));
  EXPECT_EQ(sheetPdf(card()).substr(0, 5), "%PDF-");
  EXPECT_FALSE(hasPart(sheetPdf(card()), "CreationDate"));
}

TEST(Sheet, IsToScale)
{
  EXPECT_TRUE(hasPart(sheetSvg(card()), "width=\"80mm\" height=\"50mm\" "
                                        "viewBox=\"0 0 80 50\""));
  EXPECT_TRUE(hasPart(sheetPdf(card()), "/MediaBox [ 0 0 226.771"));
  const std::string png = sheetPng(card(), 3);
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(png[k]); };
  EXPECT_EQ(byte(18) * 256 + byte(19), 240) << "pixels";
  EXPECT_EQ(byte(22) * 256 + byte(23), 150);
}

TEST(Sheet, HasNamedGroupsAndTextsInSvg)
{
  const std::string svg = sheetSvg(card());
  EXPECT_TRUE(hasPart(svg, "<title>Card &amp; more</title>"));
  const std::size_t words = svg.find("<g id=\"words\">");
  EXPECT_LT(svg.find("<g id=\"disc\">"), svg.find("fill:rgb(100%,0%,0%)"));
  EXPECT_LT(svg.find("fill:rgb(100%,0%,0%)"), words);
  EXPECT_TRUE(hasPart(svg.substr(words),
                      "<text x=\"60\" y=\"40\" dy=\"0.35em\" font-size=\"5\" "
                      "text-anchor=\"middle\" fill=\"#111111\" "
                      "transform=\"rotate(-90 60 40)\">Ø &lt; 2</text>"));
  EXPECT_FALSE(hasPart(svg, "surface")) << "numbers that count up";
}

TEST(TextPlaces, TheFirstFreeBoxIsTaken)
{
  const TextBox box{{0, 0}, {2, 1}, 0};
  const TextBox beside{{3.9, 0}, {2, 1}, 0};
  const TextBox off{{4.1, 0}, {2, 1}, 0};
  TextPlaces places;
  EXPECT_TRUE(places.takeFirst({box}));
  EXPECT_FALSE(places.takeFirst({beside}));
  EXPECT_EQ(places.takeFirst({beside, off})->middle.x(), 4.1);
  places.keepOff(Eigen::Vector2d(-9, 5), Eigen::Vector2d(9, 5));
  EXPECT_FALSE(places.takeFirst({{{0, 5.9}, {2, 1}, 0}}));
  EXPECT_TRUE(places.takeFirst({{{0, 6.1}, {2, 1}, 0}}));
  // Aslant beside each other, though the boxes around them meet.
  EXPECT_TRUE(places.takeFirst({{{20, 0}, {2, 1}, 45}}));
  EXPECT_TRUE(places.takeFirst({{{21.5, -1.5}, {2, 1}, 45}}));
}

TEST(TextPlaces, ALineToAvoidIsCrossedWhereThereIsNoOtherPlace)
{
  const TextBox on{{0, 0}, {2, 1}, 0};
  const TextBox off{{0, 3}, {2, 1}, 0};
  TextPlaces places;
  places.avoid(segment({-9, 0}, {9, 0}));
  EXPECT_EQ(places.takeFirst({on, off})->middle.y(), 3);
  EXPECT_EQ(places.takeFirst({on, off})->middle.y(), 0);
}

TEST(TextPlaces, TextsAreReadFromBelowOrFromTheRight)
{
  EXPECT_NEAR(readableAngle({-1, 0.1}), -5.7, 0.1);
  EXPECT_NEAR(readableAngle({0, -1}), 90, 1e-9);
  EXPECT_NEAR(readableAngle({0.1, -1}), 95.7, 0.1) << "a wall that is slightly aslant";
  EXPECT_NEAR(readableAngle({1, -1}), -45, 1e-9);
}

TEST(TextWidth, IsTheSumOfItsLetters)
{
  EXPECT_NEAR(textWidth("mmmmmmmm"), 2 * textWidth("mmmm"), 0.01);
  EXPECT_NEAR(textWidth("0000"), 4 * textWidth("1"), 0.01) << "digits are alike";
  EXPECT_GT(textWidth("m"), 2 * textWidth("i"));
}

} // namespace
