// SPDX-License-Identifier: BSD-3-Clause
// What shows the edges of an opening, and how well they are known.
#include "opening_scenes.h"

#include <pcl/sedr_segmentation/opening_detection.h>

#include <gtest/gtest.h>

#include <cstddef>

namespace pcl::sedr {
namespace {

TEST(OpeningDetection, TellsHowEachEdgeWasSeen)
{
  TwoRooms scene(0.005);
  scene.scanMiddleWall({door});
  const PlanOpening of_reveals = openingOf(scene, OpeningKind::Door);
  for (const std::size_t k : {0, 1, 3})
    EXPECT_EQ(of_reveals.edges[k].seen, EdgeSeen::Reveal) << k;
  EXPECT_LT(of_reveals.widthError(), 0.003);
  const Cut small{2, 2.5, 1.5, 2};
  TwoRooms no_reveals(0.005);
  no_reveals.scanOuterWall({}, {small});
  const PlanOpening of_rims = openingOf(no_reveals, OpeningKind::Window);
  for (const OpeningEdge& edge : of_rims.edges) {
    EXPECT_EQ(edge.seen, EdgeSeen::Rim);
    EXPECT_GT(edge.error, 0.01) << "a frame may cover so much";
  }
  EXPECT_GT(of_rims.residual, 0.01);
}

TEST(OpeningDetection, APaneIsNoReveal)
{
  for (const double depth : {0.06, 0.08}) {
    TwoRooms scene(0.005);
    scene.scanOuterWall({window});
    scene.scanSheet(window, -depth);
    const PlanOpening found = openingOf(scene, OpeningKind::Window);
    expectEdges(found, window, -0.1, 0.003);
    for (const OpeningEdge& edge : found.edges)
      EXPECT_EQ(edge.seen, EdgeSeen::Reveal) << depth;
    TwoRooms half(0.005); // no jamb was seen
    half.scanFace({0, 5, 0, 2.5}, 0, {window});
    half.scanSheet(window, -depth);
    for (const OpeningEdge& edge : openingOf(half, OpeningKind::Window).edges)
      EXPECT_NE(edge.seen, EdgeSeen::Reveal) << depth;
  }
}

} // namespace
} // namespace pcl::sedr
