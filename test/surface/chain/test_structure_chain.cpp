// SPDX-License-Identifier: BSD-3-Clause
#include "room_points.h"
#include "says.h"

#include <gtest/gtest.h>
#include <pcl/sedr_surface/indoor_structure_reconstruction.h>

#include <string>
#include <tuple>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

const RoomPoints::InSpace everywhere = [](const Eigen::Vector3d&) { return true; };

/** A chain that must find a plan. */
struct Modelled : StructureChain {
  explicit Modelled(const Cloud::ConstPtr& scan, const ScanAssumptions& known = {})
  {
    setAssumptions(known);
    EXPECT_TRUE(findStructure(scan)) << getModel().problem;
  }

  explicit Modelled(const RoomPoints& points, const ScanAssumptions& known = {})
      : Modelled(points.cloud(), known)
  {}

  const std::vector<PlanRoom>& rooms() const { return getModel().plan->rooms; }

  const std::vector<PlanWarning>& warnings() const { return getModel().warnings; }

  std::ptrdiff_t countTold(const std::string& words) const
  {
    return std::count_if(warnings().begin(), warnings().end(), [&](const auto& w) {
      return sentenceOf(w).find(words) != std::string::npos;
    });
  }
};

/** A room of `length` x `width` metres with a point every `spacing` metres. */
StructureChain::Cloud::Ptr
roomScannedEvery(double spacing, double length = 4, double width = 3)
{
  RoomPoints points(spacing);
  points.room(rectangle(0.01, 0.01, length + 0.01, width + 0.01), 0, 2.5);
  return points.cloud();
}

TEST(StructureChain, TakesLargerCellsForASparseScanAndTheOldOnesForTheNext)
{
  Modelled chain(roomScannedEvery(0.1));
  EXPECT_GT(chain.getGridSize(), 0.09);
  ASSERT_EQ(chain.warnings().size(), 1u);
  EXPECT_EQ(chain.countTold("too sparse for cells of 0.05 m"), 1);
  ASSERT_EQ(chain.rooms().size(), 1u);
  EXPECT_NEAR(chain.rooms()[0].area(), 12, 0.1);

  ASSERT_TRUE(chain.findStructure(roomScannedEvery(0.04))) << chain.getModel().problem;
  EXPECT_EQ(chain.getGridSize(), 0.05);
  EXPECT_EQ(chain.getStages().hole_repair.getGridSize(), 0.05);
  EXPECT_NEAR(chain.getStages().wall_growing.getDistanceThreshold(), 0.15, 1e-12);
  EXPECT_TRUE(chain.warnings().empty());
}

TEST(StructureChain, TheCeilingBetweenADuctAndTheWallBehindItIsOfTheRoom)
{
  // A strip of 0.9 square metres, 0.65 m from the rest, beside that of a larger room.
  RoomPoints points;
  points.room(roomOf(rectangle(0.01, 0.01, 3.01, 5.01), 2.6), everywhere,
              [](double, double y) { return y < 4.05 || y > 4.7; });
  points.room(rectangle(3.11, 0.01, 9.11, 5.01), 0, 2.6);
  const Modelled chain(points);
  ASSERT_EQ(chain.rooms().size(), 2u);
  EXPECT_NEAR(chain.rooms()[1].area(), 15, 0.1);
}

TEST(StructureChain, WhatAFloorReflectsIsOfNoRoomAndTold)
{
  const auto scan = roomScannedEvery(0.04);
  const std::size_t size = scan->size();
  for (std::size_t i = 0; i < size; ++i)
    if ((*scan)[i].z > 0.3F) {
      scan->push_back((*scan)[i]);
      scan->back().z *= -1;
    }
  const Modelled chain(scan);
  ASSERT_EQ(chain.rooms().size(), 1u);
  EXPECT_NEAR(chain.rooms()[0].floor.heightAt({1, 1}), 0, 0.01);
  for (std::size_t i = size; i < scan->size(); ++i)
    if ((*scan)[i].z < -0.5F) {
      ASSERT_EQ(chain.getModel().labels[i], 0u) << (*scan)[i].z;
    }
  EXPECT_EQ(chain.countTold("mirrors"), 1);
}

TEST(StructureChain, WhatCeilingAndFloorHideAreCellsOfThemAndNoPoints)
{
  RoomPoints points;
  points.room(
      roomOf(rectangle(0.01, 0.01, 4.01, 3.01), 2.5), everywhere,
      [](double x, double y) { return x > 1 || y > 0.8; },
      [](double x, double y) { return x < 2.5 || y > 1; });
  const auto scan = points.cloud();
  const Modelled chain(scan);
  EXPECT_EQ(chain.getModel().cloud->size(), scan->size());
  ASSERT_EQ(chain.rooms().size(), 1u);
  const PlanRoom& room = chain.rooms()[0];
  EXPECT_NEAR(room.area(), 12, 0.05);
  EXPECT_NEAR(room.ceiling.inferred, 0.8 / 12, 0.02);
  EXPECT_NEAR(room.floor.inferred, 1.5 / 12, 0.02);
  for (std::size_t i = 0; i < scan->size(); ++i)
    if (const float z = (*scan)[i].z; z > 0.2F && z < 2.3F) {
      ASSERT_EQ(chain.getModel().labels[i], 3u) << (*scan)[i];
    }
  const auto isFilled = [](const pcl::PointStructure& p) {
    return p.x > 0.3F && p.x < 0.5F && p.y > 0.3F && p.y < 0.5F && p.z > 2.49F;
  };
  EXPECT_GE(std::count_if(chain.getModel().structure->begin(),
                          chain.getModel().structure->end(), isFilled),
            9);
}

TEST(StructureChain, TheHighestRowOfASlopingCeilingIsNoLintel)
{
  for (const auto& [degrees, spacing, noise] :
       {std::tuple(30.0, 0.034, 0.01), {40.0, 0.05, 0.003}, {50.0, 0.034, 0.01}}) {
    PlanRoom room = roomOf(rectangle(0.01, 0.01, 4.01, 5.01), 0);
    room.ceiling = slabAt(1.5, std::tan(degrees * M_PI / 180));
    RoomPoints points(spacing, noise);
    points.room(room, [](const Eigen::Vector3d& p) {
      return p.x() < 3.99 || p.y() < 0.5 || p.y() > 4.5;
    });
    const Modelled chain(points, {false, true});
    ASSERT_EQ(chain.rooms().size(), 1u);
    EXPECT_NEAR(chain.rooms()[0].area(), 20, 0.05) << degrees << ' ' << spacing;
    EXPECT_TRUE(chain.rooms()[0].ceiling.accuracy.isKnown());
    EXPECT_EQ(chain.rooms()[0].boundary.elements.size(), 4u)
        << degrees << ' ' << spacing;
  }
}

TEST(StructureChain, WarnsOfRoomsOfWhichMuchWasNotSeen)
{
  // A high room with points of the upper parts of its walls only.
  RoomPoints points;
  points.room(roomOf(rectangle(0.01, 0.01, 4.01, 3.01), 5),
              [](const Eigen::Vector3d& p) { return p.z() > 3; });
  const Modelled chain(points, {true, true});
  ASSERT_EQ(chain.warnings().size(), 2u);
  EXPECT_EQ(chain.warnings()[0].kind, WarningKind::Open);
  EXPECT_EQ(chain.warnings()[1].kind, WarningKind::FilledIn);
  EXPECT_EQ(chain.warnings()[1].room, 1u);
  EXPECT_EQ(chain.countTold("not measured"), 1);
  EXPECT_TRUE(Modelled(roomScannedEvery(0.04)).warnings().empty());
}

TEST(StructureChain, WarnsOfAMeshOfAnotherVolumeThanItsSolidButNotOfRoundedEdges)
{
  Modelled chain(roomScannedEvery(0.04));
  ASSERT_TRUE(chain.makeMesh()) << chain.getModel().problem;
  EXPECT_TRUE(chain.warnings().empty());
  for (auto& point : *chain.getModel().structure)
    point.z *= 0.98F;
  ASSERT_TRUE(chain.makeMesh()) << chain.getModel().problem;
  ASSERT_EQ(chain.warnings().size(), 1u);
  EXPECT_EQ(sentenceOf(chain.warnings()[0]),
            "room 1: its mesh holds 29.40 m3, but its solid 30.00 m3");
  Modelled small(roomScannedEvery(0.04, 1.2, 1.1));
  const std::size_t before = small.warnings().size();
  for (auto& point : *small.getModel().structure)
    point.z *= 0.985F;
  ASSERT_TRUE(small.makeMesh()) << small.getModel().problem;
  EXPECT_EQ(small.warnings().size(), before) << sentenceOf(small.warnings().back());
}

TEST(StructureChain, ARoomThatWasLookedIntoThroughADoorIsARoom)
{
  // A hall behind a door; the hall's side of the wall with the door was not scanned.
  const auto isDoor = [](const Eigen::Vector3d& p) {
    return p.y() > 1 && p.y() < 2 && p.z() < 2;
  };
  RoomPoints points;
  points.room(roomOf(rectangle(0, 0, 4, 3), 2.5),
              [&](const Eigen::Vector3d& p) { return !(p.x() > 3.99 && isDoor(p)); });
  points.room(roomOf(rectangle(4.15, 0, 6.65, 3), 2.5),
              [](const Eigen::Vector3d& p) { return p.x() > 4.16; });
  const Modelled chain(points);
  ASSERT_EQ(chain.rooms().size(), 2u);
  EXPECT_NEAR(chain.rooms()[0].area(), 12, 0.1);
  EXPECT_NEAR(chain.rooms()[1].area(), 7.5, 0.35);
  for (std::size_t i = 0; i < chain.getModel().cloud->size(); ++i)
    EXPECT_EQ(chain.getModel().labels[i] == 0, chain.getModel().rooms[i] == 0);
}

TEST(StructureChain, AGalleryOwnsItsWallsThoughAHallIsAsHigh)
{
  // A hall of 9 x 6 m, 6 m high but for a gallery over a third of it.
  RoomPoints points;
  points.room(roomOf(rectangle(0.01, 0.01, 9.01, 6.01), 6),
              [](const Eigen::Vector3d& p) {
                return p.x() < 6.01 || p.z() < 2.8 || p.z() > 3.1;
              });
  for (const double z : {2.8, 3.1})
    points.slab(rectangle(6.01, 0.01, 9.01, 6.01), z);
  points.wall(segment({6.01, 0.01}, {6.01, 6.01}), 2.8, 3.1); // the edge of its slab
  const Modelled chain(points);
  ASSERT_EQ(chain.rooms().size(), 2u);
  EXPECT_NEAR(chain.rooms()[0].area(), 9 * 6, 0.1);
  EXPECT_NEAR(chain.rooms()[1].area(), 3 * 6, 0.6) << "its edge is open";
  for (const PlanElement& wall : chain.rooms()[1].boundary.elements)
    if (std::max(wall.start.x(), wall.end.x()) > 7) {
      EXPECT_GT(wall.evidence.seen, 0.9);
    }
}

TEST(StructureChain, RefusesPriorsThatAreOutOfTheirRange)
{
  StructureChain chain;
  Priors priors;
  priors.max_wall = 0;
  chain.setPriors(priors);
  EXPECT_FALSE(chain.findStructure(roomScannedEvery(0.1)));
  EXPECT_EQ(chain.getModel().failed_stage, "input");
  EXPECT_TRUE(says(chain.getModel().problem, "max_wall"));
  chain.setPriors(Priors());
  EXPECT_TRUE(chain.findStructure(roomScannedEvery(0.1))) << chain.getModel().problem;
}

TEST(StructureChain, ARoomIsWholeThoughItsFarCeilingWasSeenInLinesOnly)
{
  RoomPoints points;
  points.room(roomOf(rectangle(0.01, 0.01, 10.01, 4.01), 2.5), everywhere,
              [](double x, double) { return x < 4 || std::fmod(x, 0.4) < 0.05; });
  const Modelled chain(points);
  ASSERT_EQ(chain.rooms().size(), 1u);
  EXPECT_NEAR(chain.rooms()[0].area(), 40, 0.1);
  EXPECT_EQ(chain.getModel().labels.size(), chain.getModel().cloud->size());
}

/** A corner of 12 m x 8 m is hidden from (3, 4) behind a pier at x = 6. */
TEST(StructureChain, AHiddenCornerIsOfTheRoomAndAWarningTellsHowMuchNobodySaw)
{
  const auto isSeen = [](double x, double y) {
    const double angle = std::atan2(y - 4, x - 3);
    return x < 6 || angle < 0.26 || angle > 0.58;
  };
  RoomPoints points;
  points.room(
      roomOf(rectangle(0.01, 0.01, 12.01, 8.01), 3),
      [&](const Eigen::Vector3d& p) { return isSeen(p.x(), p.y()); }, isSeen, isSeen);
  points.wall(segment({6.01, 4.8}, {6.01, 5.96}), 0, 3);
  const Modelled chain(points);
  ASSERT_EQ(chain.rooms().size(), 1u);
  EXPECT_EQ(chain.rooms()[0].boundary.elements.size(), 4u);
  EXPECT_NEAR(chain.rooms()[0].area(), 96, 0.3);
  EXPECT_GT(chain.countTold("m2 were not seen"), 0);
}

} // namespace
