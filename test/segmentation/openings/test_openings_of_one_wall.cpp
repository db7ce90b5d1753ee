// SPDX-License-Identifier: BSD-3-Clause
// Several openings and niches in one wall, parted by little of it.
#include "opening_scenes.h"

#include <pcl/sedr_segmentation/opening_detection.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

namespace pcl::sedr {
namespace {

TEST(OpeningsOfOneWall, SeveralBesideEachOther)
{
  TwoRooms scene(0.005);
  scene.scanOuterWall({{0.5, 1.3, 0.9, 2.1}, {1.7, 2.5, 0.9, 2.1}, {3.2, 4.1, 0, 2.1}});
  EXPECT_EQ(openingsOf(scene).size(), 3u);
}

TEST(OpeningsOfOneWall, AboveEachOther)
{
  TwoRooms scene(0.005);
  const Cut light{1.5, 2.4, 1.95, 2.45};
  scene.scanOuterWall({{1.5, 2.4, 0, 1.8}, light, {3, 4, 0.4, 1}, {3, 4, 1.3, 2.1}});
  const auto found = openingsOf(scene);
  ASSERT_EQ(found.size(), 4u);
  const auto highest = std::max_element(
      found.begin(), found.end(),
      [](const PlanOpening& a, const PlanOpening& b) { return a.bottom < b.bottom; });
  expectEdges(*highest, light, -0.1, 0.02);
}

TEST(OpeningsOfOneWall, ABarPartsAnArchFromAWindow)
{
  for (const double bar : {0.1, 0.12, 0.15})
    for (const double rise : {0.0, 0.2}) {
      TwoRooms scene(0.005);
      const Cut lower{1, 2.5, 0.3, 1.4, rise};
      const Cut upper{1, 2.5, 1.4 + bar, 2.2};
      scene.scanOuterWall({lower, upper});
      auto found = openingsOf(scene);
      ASSERT_EQ(found.size(), 2u) << bar << ' ' << rise;
      if (found[0].bottom > found[1].bottom)
        std::swap(found[0], found[1]);
      expectEdges(found[0], lower, -0.1, 0.03);
      expectEdges(found[1], upper, -0.1, 0.03);
    }
}

/** Scans a window and a niche in the outer wall, and expects both to 2 cm.
 * @param head accuracy of the head of the niche */
void
expectWindowAndNiche(const Cut& cut, const Cut& niche, double depth, double head = 0.02)
{
  TwoRooms scene(0.002);
  scene.scanFace({0, 5, 0, 2.5}, 0, {cut, niche});
  scene.reveals(cut, -0.3, 0);
  scene.reveals(niche, -depth, 0);
  scene.scanSheet(niche, -depth);
  scene.scanSheet(cut, -0.2, 30);
  pcl::OpeningDetection<pcl::PointXYZ> detection;
  detection.setInputCloud(scene.cloud);
  Floorplan plan = scene.plan;
  ASSERT_TRUE(detection.segment(plan)) << detection.getErrorMessage();
  ASSERT_EQ(plan.openings.size(), 1u);
  expectEdges(plan.openings[0], cut, -plan.openings[0].depth / 2, 0.02);
  ASSERT_EQ(plan.rooms[0].niches.size(), 1u);
  const PlanNiche& found = plan.rooms[0].niches[0];
  const PlanElement& mouth = found.boundary.elements.back();
  EXPECT_NEAR(mouth.start.x(), niche.to, 0.02);
  EXPECT_NEAR(mouth.end.x(), niche.from, 0.02);
  EXPECT_NEAR(found.bottom.heightAt({2, 0}), niche.bottom, 0.02);
  EXPECT_NEAR(found.top.heightAt({2, 0}), niche.top, head);
}

TEST(OpeningsOfOneWall, WindowAboveANicheAndABar)
{
  for (const double depth : {0.1, 0.15})
    for (const double bar : {0.06, 0.08, 0.1, 0.12}) {
      SCOPED_TRACE(std::to_string(depth) + ' ' + std::to_string(bar));
      expectWindowAndNiche({1, 3, 0.8 + bar, 2.1}, {1, 3, 0, 0.8}, depth);
    }
}

TEST(OpeningsOfOneWall, WindowBesideANiche)
{
  for (const double depth : {0.1, 0.15, 0.2})
    expectWindowAndNiche({1, 2, 0.9, 2.1}, {2.1, 3, 0, 1.4}, depth);
}

TEST(OpeningsOfOneWall, WindowOnTheHeadOfANiche)
{
  for (const double board : {0.0, 0.02})
    for (const double depth : {0.1, 0.15, 0.2})
      for (const double inset : {0.0, 0.2}) {
        SCOPED_TRACE(std::to_string(depth) + ' ' + std::to_string(board));
        expectWindowAndNiche({1 + inset, 2 - inset, 0.8 + board, 2.1}, {1, 2, 0, 0.8},
                             depth, 0.04);
      }
}

} // namespace
} // namespace pcl::sedr
