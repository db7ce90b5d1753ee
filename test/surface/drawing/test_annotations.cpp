// SPDX-License-Identifier: BSD-3-Clause
#include "plan_loops.h"

#include "sedr_surface/src/drawing/level_notes.h"
#include "sedr_surface/src/drawing/plan_annotations.h"
#include "sedr_surface/src/sheet/sheet_layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

Floorplan
onePlan(const PlanLoop& boundary)
{
  return {{roomOf(boundary, 2.5)}};
}

PlanAnnotations
annotationsAt(const Floorplan& plan, double scale)
{
  const std::vector<CeilingLines> ceilings = ceilingsOf(plan, 0.01);
  return annotationsOf(plan, drawnElements(plan, ceilings), ceilings,
                       layoutOf(plan, scale, PaperSize::A3).frame, 0.6);
}

bool
hasName(const std::vector<SheetText>& texts)
{
  return std::any_of(texts.begin(), texts.end(),
                     [](const SheetText& text) { return text.look == "name"; });
}

PlanDetail
facetOf(const PlanLoop& loop, const PlanSlab& slab)
{
  PlanDetail detail = detailOf(loop, 0);
  detail.slab = slab;
  detail.is_facet = true;
  return detail;
}

TEST(Annotations, EveryDimensionOfARowHasItsLength)
{
  // Pilasters of 0.6 m every 1.2 m along both long walls: at 1:500 no length fits.
  Corners corners;
  for (int k = 0; k < 20; ++k)
    for (const Eigen::Vector2d& p :
         {Eigen::Vector2d(0, 0), Eigen::Vector2d(0.6, 0), Eigen::Vector2d(0.6, 0.3),
          Eigen::Vector2d(1.2, 0.3)})
      corners.emplace_back(p.x() + 1.2 * k, p.y());
  corners.emplace_back(24, 10);
  corners.emplace_back(0, 10);
  for (const double scale : {50.0, 200.0, 500.0}) {
    const PlanAnnotations annotations = annotationsAt(onePlan(polygon(corners)), scale);
    ASSERT_GE(annotations.rows.size(), 2u);
    for (const std::vector<PlacedDimension>& row : annotations.rows) {
      double whole = 0;
      for (const PlacedDimension& dimension : row) {
        EXPECT_TRUE(dimension.text) << "1:" << scale;
        whole += dimension.length;
      }
      EXPECT_NEAR(whole, row.front().start.x() == row.front().end.x() ? 10 : 24, 0.31);
    }
  }
}

TEST(Annotations, TextsKeepOffRidges)
{
  // The ridge runs through the middle, where the room's text would be.
  Floorplan plan = onePlan(rectangle(0, 0, 8, 4));
  plan.rooms[0].details = {facetOf(rectangle(0, 0, 8, 2), slabAt(1, 0, 1)),
                           facetOf(rectangle(0, 2, 8, 4), slabAt(5, 0, -1))};
  const SheetLayout layout = layoutOf(plan, 50, PaperSize::A3);
  const double ridge = layout.frame(Eigen::Vector2d(4, 2)).y();
  const std::vector<SheetText> texts = annotationsAt(plan, 50).texts;
  EXPECT_TRUE(hasName(texts));
  for (const SheetText& text : texts) {
    if (text.degrees == 0) {
      EXPECT_GT(std::abs(text.place.y() - ridge), 0.6 * text.font) << text.text;
    }
  }
}

TEST(Annotations, TextsCrossALineWhereThereIsNoOtherPlace)
{
  // A closet of 1 m below a ridge: at 1:50 its three lines do not fit beside it.
  Floorplan plan = onePlan(rectangle(0, 0, 1, 0.6));
  plan.rooms[0].details = {facetOf(rectangle(0, 0, 1, 0.3), slabAt(2, 0, 1)),
                           facetOf(rectangle(0, 0.3, 1, 0.6), slabAt(2.6, 0, -1))};
  EXPECT_TRUE(hasName(annotationsAt(plan, 50).texts));
}

TEST(Annotations, ALevelIsWithinItsPart)
{
  // The middle of a hall is raised: the room's name is there, and so is the level. The
  // other part goes on behind the wall.
  Floorplan plan = onePlan(rectangle(0, 0, 20, 20));
  plan.rooms[0].details = {facetOf(rectangle(8, 8, 12, 12), slabAt(3)),
                           facetOf(rectangle(19.4, -5, 30, 25), slabAt(2))};
  const SheetLayout layout = layoutOf(plan, 100, PaperSize::A3);
  const auto texts = annotationsAt(plan, 100).texts;
  const auto levelBetween = [&](const std::string& level, double from, double to) {
    return std::any_of(texts.begin(), texts.end(), [&](const SheetText& text) {
      const double x = text.place.x();
      return text.text == level && x > layout.frame(Eigen::Vector2d(from, 0)).x() &&
             x < layout.frame(Eigen::Vector2d(to, 0)).x();
    });
  };
  EXPECT_TRUE(hasName(texts));
  EXPECT_TRUE(levelBetween("3.00", 8.3, 11.7));
  EXPECT_FALSE(levelBetween("2.00", 20, 40));
}

TEST(Annotations, ASlopeOfMoreThanFourDegreesHasNoLevel)
{
  for (const double degrees : {3.8, 4.2}) {
    const double slope = std::tan(degrees * M_PI / 180);
    PlanRoom room = roomOf(rectangle(0, 0, 9, 4), 2.5);
    room.details = {facetOf(rectangle(0, 0, 3, 4), slabAt(2, slope))};
    EXPECT_EQ(levelNotes(room, ceilingLines(room, 0.05), {{8, 2}, 0.5}).empty(),
              degrees > 4)
        << degrees;
    room.details.clear();
    room.ceiling = slabAt(2, slope);
    EXPECT_EQ(room.hasFacets(), degrees > 4) << degrees;
  }
}

TEST(Annotations, WhereACeilingGoesOnNothingIsDrawn)
{
  // Two level facets side by side below a ceiling of 2.5 m.
  const auto planWith = [](double first, double second) {
    Floorplan plan = onePlan(rectangle(0, 0, 9, 4));
    plan.rooms[0].details = {facetOf(rectangle(0, 0, 3, 4), slabAt(first)),
                             facetOf(rectangle(3, 0, 6, 4), slabAt(second))};
    return plan;
  };
  const auto borders = [&](double first, double second) {
    const Floorplan plan = planWith(first, second);
    const auto drawn = drawnElements(plan, ceilingsOf(plan, 0.01));
    return std::count_if(drawn.begin(), drawn.end(), [](const DrawnElement& e) {
      return e.layer == DrawnLayer::Detail;
    });
  };
  EXPECT_EQ(borders(2.2, 2.35), 2) << "steps";
  EXPECT_EQ(borders(2.2, 2.21), 1) << "of a centimetre between them nothing is seen";
  EXPECT_EQ(borders(2.49, 2.51), 0);
  const auto notes = [&](double first, double second) {
    const Floorplan plan = planWith(first, second);
    std::string texts;
    for (const LevelNote& note :
         levelNotes(plan.rooms[0], ceilingLines(plan.rooms[0], 0.05), {{8, 2}, 0.5}))
      texts += note.text + " ";
    return texts;
  };
  EXPECT_EQ(notes(2.2, 2.35), "2.20 2.35 ");
  EXPECT_EQ(notes(2.2, 2.21), "2.20 ") << "one of both";
  EXPECT_EQ(notes(2.49, 2.51), "") << "the room's own height";
}

} // namespace
