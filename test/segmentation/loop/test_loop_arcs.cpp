// SPDX-License-Identifier: BSD-3-Clause
#include "loop_scenes.h"

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** Expects the elements of the truth, and arcs of its radius within a share. */
void
expectArcs(const PlanLoop& truth, double radius, double noise, double share)
{
  const PlanLoop loop = fitted(contourIn(truth), wallPoints(truth, noise));
  EXPECT_EQ(loop.elements.size(), truth.elements.size());
  std::size_t arcs = 0;
  for (const auto& e : truth.elements)
    arcs += e.isArc() ? 1 : 0;
  for (const auto& e : loop.elements)
    if (e.isArc()) {
      --arcs;
      EXPECT_NEAR(e.radius / radius, 1, share);
    }
  EXPECT_EQ(arcs, 0u);
}

/** A room whose lower wall turns by `degrees` along an arc tangent to both parts. */
PlanLoop
bentWall(double radius, double degrees)
{
  const double a = degrees * M_PI / 180;
  const Vector2d centre(3, radius);
  const Vector2d end = centre + radius * Vector2d(std::sin(a), -std::cos(a));
  const Vector2d far = end + 2 * Vector2d(std::cos(a), std::sin(a));
  return {{segment({0, 0}, {3, 0}), arc(centre, radius, -90, degrees - 90),
           segment(end, far), segment(far, {far.x(), 5}), segment({far.x(), 5}, {0, 5}),
           segment({0, 5}, {0, 0})}};
}

TEST(FitLoop, RoundRoomsBaysAndCornersAreArcsAtAnyNoise)
{
  for (const double radius : {0.8, 1.1, 1.6})
    for (const double noise : {0.002, 0.006, 0.02}) {
      SCOPED_TRACE(testing::Message() << radius << " m, noise " << noise);
      expectArcs(placed(circle({0, 0}, radius), 0, {3.02, 1.01}), radius, noise, 0.01);
      expectArcs(placed(stadium(3, radius), 33, {0.02, 0.01}), radius, noise, 0.02);
      expectArcs(placed(bittenRectangle(6, 4, radius), 20, {0.02, 0.01}), radius, noise,
                 0.02);
    }
}

TEST(FitLoop, AWallThatTurnsOverAShortArcIsNotCutIntoStraightPieces)
{
  for (const double radius : {1.1, 1.3, 1.5})
    for (const double turn : {45.0, 60.0})
      for (const double degrees : {0.0, 33.0}) {
        SCOPED_TRACE(testing::Message()
                     << radius << " m over " << turn << " at " << degrees);
        const PlanLoop truth = placed(bentWall(radius, turn), degrees, {0.017, 0.023});
        expectArcs(truth, radius, 0.002, 0.02);
      }
}

TEST(FitLoop, ChamfersStayStraightAtAnyNoise)
{
  for (const double cut : {0.5, 0.9})
    for (const double noise : {0.002, 0.006, 0.02}) {
      SCOPED_TRACE(testing::Message() << cut << " m, noise " << noise);
      const PlanLoop truth =
          placed(polygon({{cut, 0}, {5 - cut, 0}, {5, cut}, {5, 4}, {0, 4}, {0, cut}}),
                 17, {0.02, 0.01});
      expectArcs(truth, 1, noise, 0);
    }
}

} // namespace
