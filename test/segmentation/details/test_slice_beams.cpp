// SPDX-License-Identifier: BSD-3-Clause
#include "detail_scene.h"

#include "sedr_segmentation/src/details/slice_detail.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;
using Scene = DetailScene;

TEST(SliceDetails, ABeamAcrossTheRoomIsFound)
{
  PlanRoom room = plainRoom();
  room.details = {detailOf(rectangle(2.21, 0.01, 2.61, 4.01), 2.15)};
  const Scene scene(room);
  const SliceDetails details = scene.find();
  expectFound(scene, details);
  EXPECT_EQ(details.sizes.size(), 1u);
}

TEST(SliceDetails, BeamsOfTwelveCentimetresAreFound)
{
  PlanRoom room = plainRoom();
  for (const double y : {0.71, 1.52, 2.33, 3.14})
    room.details.push_back(detailOf(rectangle(0.01, y, 5.01, y + 0.12), height - 0.15));
  const Scene scene(room);
  const SliceDetails details = scene.find();
  EXPECT_EQ(details.sizes.size(), room.details.size());
  const std::set<int> found(details.indices.begin(), details.indices.end());
  const std::vector<int> clear = scene.clearDetails();
  ASSERT_GT(clear.size(), 4 * 100u);
  for (const int i : clear) {
    const double x = scene.points[i].x();
    const bool is_beside_wall = x < 0.15 || x > 4.85;
    EXPECT_TRUE(is_beside_wall || found.count(i)) << scene.points[i].transpose();
  }
}

TEST(SliceDetails, SoAreNarrowOnesAcrossTheGridInNoise)
{
  for (const double x : {2.2, 2.213, 2.231, 2.247}) {
    PlanRoom room = plainRoom();
    room.details = {detailOf(rectangle(x, 0.01, x + 0.15, 4.01), height - 0.2)};
    room.boundary = placed(room.boundary, 45, {0, 0});
    room.details[0].boundary = placed(room.details[0].boundary, 45, {0, 0});
    const Scene scene(room, 0.02);
    const SliceDetails details = scene.find();
    const std::set<int> found(details.indices.begin(), details.indices.end());
    double seen = 0;
    double all = 0;
    for (const int i : scene.parts.details)
      if (scene.points[i].z() < height - 0.14) {
        seen += found.count(i) ? 1 : 0;
        ++all;
      }
    EXPECT_GT(seen, 0.5 * all) << x;
  }
}

TEST(SliceDetails, SoIsOneThatHidesTheCeilingBesideIt)
{
  for (const double hidden : {0.0, 0.1, 0.25}) { // on each side: up to 8 cells in all
    PlanRoom room = plainRoom();
    room.details = {detailOf(rectangle(2.21, 0.01, 2.36, 4.01), height - 0.3)};
    Scene scene(room);
    const auto isHidden = [&](int i) {
      const double x = scene.points[i].x();
      return x > 2.21 - hidden && x < 2.36 + hidden;
    };
    auto& ceiling = scene.parts.ceiling;
    ceiling.erase(std::remove_if(ceiling.begin(), ceiling.end(), isHidden),
                  ceiling.end());
    const std::vector<int> seen =
        joined(joined(scene.parts.floor, ceiling),
               joined(scene.parts.walls, scene.parts.details));
    std::string problem;
    const SliceDetails details = findSliceDetails(scene.points.view(), seen, ceiling,
                                                  slabAt(height), 0, {}, problem);
    EXPECT_EQ(details.sizes.size(), hidden < 0.2 ? 1u : 0u) << hidden;
  }
}

} // namespace
