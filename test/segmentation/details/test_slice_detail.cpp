// SPDX-License-Identifier: BSD-3-Clause
#include "detail_scene.h"

#include "sedr_segmentation/src/details/slice_detail.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;
using Scene = DetailScene;

TEST(SliceDetails, OfAPlainRoomAreNone)
{
  for (const double noise : {0.0, 0.02}) {
    const SliceDetails details = Scene(plainRoom(), noise).find();
    EXPECT_TRUE(details.indices.empty());
    EXPECT_TRUE(details.sizes.empty());
    EXPECT_TRUE(details.cells.empty());
    EXPECT_EQ(details.trial, 0);
    EXPECT_TRUE(std::isnan(details.slice_height));
  }
}

TEST(SliceDetails, ASoffitAlongTwoWallsIsOneInTheFirstTrial)
{
  const Scene scene(soffitRoom(0.3));
  const SliceDetails details = scene.find();
  expectFound(scene, details);
  EXPECT_EQ(details.trial, 1);
  ASSERT_EQ(details.sizes.size(), 1u);
  EXPECT_NEAR(static_cast<double>(details.sizes[0]) * 0.0025, 0.6 * (5 + 3.4), 0.6);
  EXPECT_EQ(details.cells.size(), details.sizes[0]);
  EXPECT_NEAR(details.slice_height, height - 0.3 - 0.05, 0.02);
  for (const auto region : details.region)
    EXPECT_EQ(region, 0u);
}

/** A room with a soffit 0.6 m wide, below which cupboards hide the floor: they are 0.9
 * m high and `depth` deep. */
Scene
kitchenWithSoffit(double depth, double noise)
{
  const PlanLoop loop = plainRoom().boundary;
  Scene scene(plainRoom(), noise);
  RoomPoints& points = scene.points = RoomPoints(0.05, noise);
  const auto isBeside = [&](double, double y) { return y > depth; };
  scene.parts.floor = points.slab(loop, 0, isBeside);
  points.slab(rectangle(0.01, 0.01, 5.01, depth), 0.9);
  points.wall(segment({5.01, depth}, {0.01, depth}), 0, 0.9);
  scene.parts.ceiling =
      points.slab(loop, height, [](double, double y) { return y > 0.61; });
  scene.parts.details = points.slab(rectangle(0.01, 0.01, 5.01, 0.61), 2.2);
  scene.parts.details =
      joined(scene.parts.details,
             points.wall(segment({5.01, 0.61}, {0.01, 0.61}), 2.2, height));
  scene.parts.walls.clear();
  for (std::size_t e = 0; e < 4; ++e)
    scene.parts.walls =
        joined(scene.parts.walls,
               points.wall(loop.elements[e], 0, height, [&](double s, double z) {
                 const double y = loop.elements[e].pointAt(s).y();
                 return (y > 0.61 || z < 2.2) && (y > depth || z > 0.9);
               }));
  return scene;
}

TEST(SliceDetails, ASoffitOverCupboardsThatHideTheFloorBelowItIsFound)
{
  for (const double noise : {0.0, 0.02}) {
    const Scene scene = kitchenWithSoffit(0.86, noise);
    expectFound(scene, scene.find(), 0.1);
  }
}

TEST(SliceDetails, TheHeadOfARecessAboveASillIsNone)
{
  // The cupboards below it are in line with its front.
  EXPECT_TRUE(kitchenWithSoffit(0.61, 0).find().indices.empty());
}

TEST(SliceDetails, TheSliceLiesBelowAllThatWasFound)
{
  for (const double drop : {0.2, 0.5}) {
    const Scene scene(soffitRoom(drop), 0.01);
    const SliceDetails details = scene.find();
    expectFound(scene, details, 0.1); // noise mixes the risers' cells with others
    for (const int i : details.indices)
      ASSERT_GT(scene.points[i].z(), details.slice_height);
  }
}

TEST(SliceDetails, ASoffitBelowAQuarterOfTheHeightIsFoundInTheSecondTrial)
{
  const Scene scene(soffitRoom(0.8));
  expectFound(scene, scene.find());
  EXPECT_EQ(scene.find().trial, 2);
  SliceParameters once;
  once.trials = 1;
  EXPECT_EQ(scene.find(once).trial, 0);
}

TEST(SliceDetails, TellWhatEveryTrialSaw)
{
  const Scene scene(soffitRoom(0.8));
  const SliceDetails details = scene.find();
  EXPECT_EQ(details.ceiling.keys(),
            CellSet(CellGrid(0.05), scene.points.view(), scene.parts.ceiling).keys());
  ASSERT_EQ(details.trials.size(), 2u);
  const double heights[] = {0.75 * height, 0.5 * height};
  for (std::size_t t = 0; t < 2; ++t) {
    const SliceTrial& trial = details.trials[t];
    EXPECT_EQ(trial.number, static_cast<int>(t + 1));
    ASSERT_EQ(trial.heights.size(), 1u);
    EXPECT_NEAR(trial.heights[0], heights[t], 1e-9);
    std::size_t cells = 0;
    for (const auto* regions : {&trial.accepted, &trial.rejected})
      for (const CellSet& region : *regions)
        cells += region.size();
    EXPECT_EQ(trial.enclosed.size(), cells) << "every region is one or the other";
  }
  EXPECT_TRUE(details.trials[0].accepted.empty());
  // At half the height the walls run along the whole outline.
  EXPECT_TRUE(details.trials[1].slice.contains(CellGrid(0.05).at(0.02, 2)));
  EXPECT_FALSE(details.trials[1].slice.contains(CellGrid(0.05).at(2, 2)));
  ASSERT_EQ(details.trials[1].accepted.size(), 1u);
  EXPECT_NEAR(static_cast<double>(details.trials[1].accepted[0].size()) * 0.0025,
              0.6 * (5 + 3.4), 1.2);
  EXPECT_TRUE(details.refused.empty());
}

TEST(SliceDetails, TellThatWhatATrialEnclosesIsTooSmall)
{
  SliceParameters parameters;
  parameters.minimum_cells = 5000;
  const SliceDetails details = Scene(soffitRoom(0.3)).find(parameters);
  ASSERT_EQ(details.trials.size(), 3u);
  EXPECT_TRUE(details.trials[0].accepted.empty());
  ASSERT_GE(details.trials[0].rejected.size(), 1u);
  EXPECT_GT(details.trials[0].rejected[0].size(), 1500u);
}

TEST(SliceDetails, BehindARibbonOfWindowsItIsFoundInTheThirdTrial)
{
  // There is no wall at a quarter (1.875 m) or half of the height (1.25 m).
  const Scene scene(soffitRoom(0.2), [](const Eigen::Vector3d& p) {
    return p.y() > 0.02 || p.z() < 1.1 || p.z() > 2.0;
  });
  expectFound(scene, scene.find());
  EXPECT_EQ(scene.find().trial, 3);
  SliceParameters twice;
  twice.trials = 2;
  EXPECT_EQ(scene.find(twice).trial, 0);
}

TEST(SliceDetails, ARecessIsFoundThoughNoSliceEnclosesIt)
{
  PlanRoom room = plainRoom();
  room.details = {detailOf(rectangle(1.51, 1.01, 3.51, 2.51), 2.7)};
  const Scene scene(room);
  const SliceDetails details = scene.find();
  EXPECT_EQ(details.trial, 0);
  ASSERT_EQ(details.sizes.size(), 1u);
  EXPECT_NEAR(static_cast<double>(details.sizes[0]) * 0.0025, 3, 0.3);
  const std::set<int> found(details.indices.begin(), details.indices.end());
  std::size_t missed = 0;
  for (const int i : scene.clearDetails())
    missed += found.count(i) ? 0 : 1;
  EXPECT_LE(missed, 10u);
}

TEST(SliceDetails, SeveralComeLargestFirst)
{
  PlanRoom room = plainRoom();
  room.details = {detailOf(rectangle(0.81, 0.81, 1.81, 1.81), 2.75),
                  detailOf(rectangle(2.51, 0.81, 4.51, 2.31), 2.75),
                  detailOf(rectangle(0.81, 2.51, 2.01, 3.51), 2.75)};
  const SliceDetails details = Scene(room).find();
  ASSERT_EQ(details.sizes.size(), 3u);
  EXPECT_NEAR(static_cast<double>(details.sizes[0]) * 0.0025, 3, 0.3);
  EXPECT_NEAR(static_cast<double>(details.sizes[1]) * 0.0025, 1.2, 0.2);
  EXPECT_NEAR(static_cast<double>(details.sizes[2]) * 0.0025, 1, 0.2);
  std::vector<std::size_t> count(3, 0);
  for (const auto region : details.region)
    ++count.at(region);
  EXPECT_GT(count[0], count[1]);
  EXPECT_GT(count[2], 0u);
}

TEST(SliceDetails, ALampIsNone)
{
  for (const double size : {0.5, 1.0}) {
    const PlanRoom room = plainRoom();
    Scene scene(room);
    const PlanLoop lamp = rectangle(2.01, 1.51, 2.01 + size, 1.51 + size);
    // It hides the ceiling above it, and is not attached.
    scene.parts.ceiling.erase(
        std::remove_if(scene.parts.ceiling.begin(), scene.parts.ceiling.end(),
                       [&](int i) {
                         return lamp.contains(scene.points[i].head<2>().cast<double>());
                       }),
        scene.parts.ceiling.end());
    const auto underside = scene.points.slab(lamp, 2.1);
    std::vector<int> seen = scene.parts.ceiling;
    for (const auto& part : {scene.parts.floor, scene.parts.walls, underside})
      seen = joined(seen, part);
    std::string problem;
    const SliceDetails details = findSliceDetails(
        scene.points.view(), seen, scene.parts.ceiling, slabAt(height), 0, {}, problem);
    EXPECT_TRUE(details.indices.empty()) << size;
    const CellGrid grid(0.05);
    EXPECT_TRUE(details.refused.contains(grid.at(2.26, 1.76)));
    EXPECT_NEAR(static_cast<double>(details.refused.size()) * 0.0025, size * size,
                0.1 * (size + 1) * 2);
    EXPECT_FALSE(details.refused.contains(grid.at(1.9, 1.76)));
  }
}

/** An opening in the wall at y = 0.01, with a reveal outwards. */
struct Opening {
  double from, to, sill, head, depth;
};

/** A room with openings. */
Scene
sceneWith(const PlanRoom& room, const std::vector<Opening>& openings)
{
  Scene scene(room, [&](const Eigen::Vector3d& p) {
    return p.y() > 0.02 ||
           std::none_of(openings.begin(), openings.end(), [&](const Opening& o) {
             return p.x() > o.from && p.x() < o.to && p.z() > o.sill && p.z() < o.head;
           });
  });
  for (const Opening& o : openings) {
    const PlanLoop reveal = rectangle(o.from, 0.01 - o.depth, o.to, 0.01);
    scene.points.slab(reveal, o.sill);
    scene.points.slab(reveal, o.head);
    scene.points.wall(reveal.elements[1], o.sill, o.head);
    scene.points.wall(reveal.elements[3], o.sill, o.head);
  }
  return scene;
}

TEST(SliceDetails, HeadsOfDoorsAndWindowsAreNone)
{
  const Scene scene =
      sceneWith(plainRoom(), {{0.5, 1.4, 0, 2.0, 0.15}, {2.2, 4.2, 0.9, 2.1, 0.3}});
  const SliceDetails details = scene.find();
  EXPECT_TRUE(details.indices.empty()) << details.indices.size();
}

TEST(SliceDetails, TheHeadOfAWindowJustBelowASoffitIsNoneOfIt)
{
  PlanRoom room = plainRoom();
  room.details = {detailOf(rectangle(0.01, 0.01, 5.01, 0.61), height - 0.3)};
  for (const double step : {0.03, 0.05, 0.1}) {
    const Scene scene = sceneWith(room, {{0.5, 4.5, 0.8, height - 0.3 - step, 0.35}});
    const SliceDetails details = scene.find();
    EXPECT_GT(details.indices.size(), 500u) << "the soffit";
    for (const int i : details.indices)
      EXPECT_GT(scene.points[i].y(), -0.06) << step;
  }
}

TEST(SliceDetails, ATableAndAShelfAreNone)
{
  Scene scene(plainRoom());
  scene.points.slab(rectangle(1, 1, 2.5, 2), 0.75);
  scene.points.slab(rectangle(0.01, 1, 0.31, 3), 1.9); // below the ceiling
  EXPECT_TRUE(scene.find().indices.empty());
}

TEST(SliceDetails, ATableBelowAnUnseenPartOfTheCeilingIsNone)
{
  const PlanLoop table = rectangle(4.01, 0.01, 5.01, 4.01);
  Scene scene(plainRoom());
  scene.parts.ceiling.erase(
      std::remove_if(scene.parts.ceiling.begin(), scene.parts.ceiling.end(),
                     [&](int i) { return scene.points[i].x() > 4.01f; }),
      scene.parts.ceiling.end());
  const auto top = scene.points.slab(table, 0.9);
  std::vector<int> seen = joined(scene.parts.ceiling, scene.parts.floor);
  seen = joined(joined(seen, scene.parts.walls), top);
  std::string problem;
  const SliceDetails details = findSliceDetails(
      scene.points.view(), seen, scene.parts.ceiling, slabAt(height), 0, {}, problem);
  EXPECT_EQ(problem, "");
  EXPECT_TRUE(details.indices.empty()) << details.indices.size();
}

TEST(SliceDetails, OfFewerThanTheMinimumOfCellsAreNone)
{
  PlanRoom room = plainRoom();
  room.details = {detailOf(rectangle(4.01, 0.01, 5.01, 4.01), 2.2),
                  detailOf(rectangle(0.01, 0.01, 1.01, 1.01), 2.2)};
  const Scene scene(room);
  ASSERT_EQ(scene.find().sizes.size(), 2u);
  SliceParameters parameters;
  parameters.minimum_cells = 600;
  const SliceDetails details = scene.find(parameters);
  ASSERT_EQ(details.sizes.size(), 1u);
  EXPECT_GE(details.sizes[0], 600u);
  parameters.minimum_cells = 2000;
  EXPECT_TRUE(scene.find(parameters).indices.empty());
}

TEST(SliceDetails, AStrayPointFarAwayChangesNothing)
{
  Scene scene(soffitRoom(0.3));
  const SliceDetails truth = scene.find();
  scene.points.point(9e6, -9e6, 1);
  const SliceDetails details = scene.find();
  EXPECT_EQ(details.indices, truth.indices);
  EXPECT_EQ(details.sizes, truth.sizes);
}

TEST(SliceDetails, TooLargeACeilingIsRefusedWithItsNumberOfCells)
{
  Scene scene(soffitRoom(0.3));
  scene.parts.ceiling.push_back(scene.points.point(9e6, -9e6, height));
  std::string problem;
  const SliceDetails details =
      findSliceDetails(scene.points.view(), scene.points.all(), scene.parts.ceiling,
                       slabAt(height), 0, {}, problem);
  EXPECT_NE(problem.find("cells"), std::string::npos) << problem;
  EXPECT_TRUE(details.indices.empty());
}

} // namespace
