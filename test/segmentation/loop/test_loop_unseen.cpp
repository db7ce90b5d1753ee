// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/loop/loop_unseen.h"

#include "loop_scenes.h"

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** Returns links along the sides of a polygon. */
LoopChain
chainAlong(const Corners& corners)
{
  LoopChain chain;
  chain.corners = corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector2d& next = corners[(i + 1) % corners.size()];
    chain.links.emplace_back();
    chain.links.back().curve.point = corners[i];
    chain.links.back().curve.direction = (next - corners[i]).normalized();
  }
  return chain;
}

/** Returns the corners rotated by `by` places. */
Corners
rotated(Corners corners, std::size_t by)
{
  std::rotate(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(by),
              corners.end());
  return corners;
}

TEST(SquareUnseenLinks, AStepThatIsHardlySeenGivesWay)
{
  // The end of a passage: an oblique link that was not scanned, and a short one, a
  // third of which was. They come in either order, with any start of the chain.
  const Corners after{{0, 0},     {6, 0},   {6, 2.6}, {4, 2.6}, {4, 4},
                      {3.3, 3.8}, {3, 3.8}, {3, 2.6}, {0, 2.6}};
  const Corners before{{0, 0},     {6, 0}, {6, 2.6}, {4, 2.6}, {4, 3.8},
                       {3.7, 3.8}, {3, 4}, {3, 2.6}, {0, 2.6}};
  const PlanLoop truth = polygon(
      {{0, 0}, {6, 0}, {6, 2.6}, {4, 2.6}, {4, 3.9}, {3, 3.9}, {3, 2.6}, {0, 2.6}});
  for (const Corners& corners : {after, before})
    for (const double share : {0.3, 1.0})
      for (std::size_t by = 0; by < corners.size(); ++by) {
        std::vector<Vector2d> points = wallPoints(
            polygon(corners), 0, [](const Vector2d& p) { return p.y() < 3.7; });
        const double step = corners[5].x() > 3.5 ? 3.7 : 3;
        for (double x = step + 0.025; x < step + 0.3; x += 0.05)
          for (int k = 0; k < 20 * share; ++k)
            points.emplace_back(x, 3.8);
        LoopChain chain = chainAlong(rotated(corners, by));
        squareUnseenLinks(chain, {}, PlanPoints(std::move(points), 0.1), {});
        if (share < 1)
          expectLoop(chain.loop(), truth, 0.01);
        else
          EXPECT_EQ(chain.size(), corners.size()) << "a step that was seen stays";
      }
}

TEST(SquareUnseenLinks, WallsMeetInACornerThatAWardrobeAcrossItHides)
{
  // The ceiling was scanned up to the shadow of the wardrobe, which starts a little
  // before one of the walls.
  const PlanLoop truth = rectangle(0, 0, 5, 4);
  for (const double hidden : {0.9, 1.5}) {
    const Corners straight{{hidden, 0}, {5, 0}, {5, 4}, {0, 4}, {0, hidden}};
    const Corners stepped{{hidden, 0.08}, {hidden, 0}, {5, 0},
                          {5, 4},         {0, 4},      {0, hidden}};
    for (const Corners& corners : {straight, stepped})
      for (std::size_t by = 0; by < corners.size(); ++by) {
        LoopChain chain = chainAlong(rotated(corners, by));
        std::vector<Vector2d> points = wallPoints(truth, 0, [&](const Vector2d& p) {
          return p.x() > hidden + 0.1 || p.y() > hidden + 0.1;
        });
        squareUnseenLinks(chain, {}, PlanPoints(std::move(points), 0.1), {});
        expectLoop(chain.loop(), truth, 0.01);
      }
  }
}

TEST(SquareUnseenLinks, AnArcOfWhichOnlyAStraightPieceWasSeenIsStraight)
{
  // A circle of 16 m radius through (6, 0) and (6, 4), a room to the left of it.
  const double radius = 16;
  const Vector2d centre{6 - std::sqrt(radius * radius - 4), 2};
  PlanLoop bulging = rectangle(0, 0, 6, 4);
  bulging.elements[1].centre = centre;
  bulging.elements[1].radius = radius;
  const auto fittedTo = [&](const PlanLoop& wall, const Where& isSeen) {
    LoopChain chain = chainAlong({{0, 0}, {6, 0}, {6, 4}, {0, 4}});
    chain.links[1].curve = carrierOf(bulging.elements[1]);
    std::vector<Vector2d> points = wallPoints(wall, 0, [&](const Vector2d& p) {
      return p.x() < 5.9 || (p.y() > 0.1 && p.y() < 3.9 && isSeen(p));
    });
    squareUnseenLinks(chain, {}, PlanPoints(std::move(points), 0.1), {});
    return chain.loop();
  };
  const Where inOnePlace = [](const Vector2d& p) { return p.y() > 0.2 && p.y() < 1.6; };
  const Where atBothEnds = [](const Vector2d& p) { return std::abs(p.y() - 2) > 1.2; };
  const PlanLoop straight = rectangle(0, 0, 6.03, 4);
  expectLoop(fittedTo(straight, inOnePlace), straight, 0.01);
  EXPECT_TRUE(fittedTo(bulging, atBothEnds).elements[1].isArc());
  EXPECT_TRUE(fittedTo(bulging, everywhere).elements[1].isArc());
}

} // namespace
