// SPDX-License-Identifier: BSD-3-Clause
#include "found_niches.h"
#include "plan_loops.h"
#include "sedr_filters/src/rays/sight_lines.h"
#include "sedr_segmentation/src/openings/opening_search.h"
#include "two_storeys.h"

#include <gtest/gtest.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/sedr_segmentation/opening_detection.h>

#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** A room of 5 m x 4 m, 2.6 m high, with the given recess in the wall x = 5. */
PlanRoom
recessed(double from, double to, double low, double high, double depth)
{
  PlanRoom room = roomOf(rectangle(0, 0, 5, 4), 2.6);
  room.niches = {{rectangle(5, from, 5 + depth, to), slabAt(low), slabAt(high)}};
  return room;
}

/** Expects the niches of a room in its points, and no others. */
void
expectFound(const PlanRoom& room,
            double tolerance,
            double noise = 0,
            double spacing = 0.03)
{
  RoomPoints points(spacing, noise);
  points.room(room);
  const auto niches = nichesOf(points, room);
  ASSERT_EQ(niches.size(), room.niches.size());
  for (std::size_t k = 0; k < niches.size(); ++k) {
    const PlanNiche& found = niches[k];
    const PlanNiche& truth = room.niches[k];
    EXPECT_NEAR(found.boundary.area(), truth.boundary.area(), 4 * tolerance);
    for (const auto& e : truth.boundary.elements)
      EXPECT_LT(found.boundary.distance(e.start), 2 * tolerance) << e.start.transpose();
    EXPECT_NEAR(found.bottom.heightAt({5, 2}), truth.bottom.heightAt({5, 2}),
                tolerance);
    EXPECT_NEAR(found.top.heightAt({5, 2}), truth.top.heightAt({5, 2}), tolerance);
  }
}

/** A room with a partly scanned niche, and pieces of wall in it. */
struct Scene {
  PlanRoom room = recessed(1, 2.4, 0.8, 2.2, 0.3);
  RoomPoints points{0.03};

  explicit Scene(const RoomPoints::InSpace& isSeen) { points.room(room, isSeen); }

  /** Adds a piece of wall at `x`. */
  void wallAt(double x, double from, double to, double low, double high)
  {
    points.wall(segment({x, from}, {x, to}), low, high);
  }

  std::size_t niches() const { return nichesOf(points, room).size(); }
};

std::size_t
nichesFor(const PlanRoom& room)
{
  RoomPoints points(0.03);
  points.room(room);
  return nichesOf(points, room).size();
}

TEST(Niches, AreFoundUnderNoise)
{
  expectFound(recessed(1, 2.2, 0.9, 2.1, 0.3), 0.01, 0.01);
  expectFound(recessed(1, 2.2, 0.9, 2.1, 0.3), 0.015, 0.02, 0.02);
}

TEST(Niches, DepthAndSizeAreThoseOfTheParameters)
{
  EXPECT_EQ(nichesFor(recessed(1, 2.2, 0.9, 2.1, 0.19)), 0u) << "a blind";
  EXPECT_EQ(nichesFor(recessed(1, 2.2, 0.9, 2.1, 0.31)), 1u);
  EXPECT_EQ(nichesFor(recessed(1, 2.2, 0.9, 2.1, 1.06)), 0u) << "a hatch";
  EXPECT_EQ(nichesFor(recessed(1, 1.26, 0.5, 2.1, 0.25)), 0u) << "a slot";
  EXPECT_EQ(nichesFor(recessed(1, 2.2, 0.9, 1.1, 0.25)), 0u) << "a slot";
  EXPECT_EQ(nichesFor(recessed(1, 1.7, 0.9, 1.6, 0.35)), 1u);
}

TEST(Niches, WhatReachesFromFloorToCeilingIsAPartOfTheRoom)
{
  EXPECT_EQ(nichesFor(recessed(1, 2.2, 0.9, 2.5, 0.3)), 1u);
  EXPECT_EQ(nichesFor(recessed(1, 2.2, 0.9, 2.6, 0.3)), 1u);
  EXPECT_EQ(nichesFor(recessed(1, 2.2, 0, 2.1, 0.3)), 1u);
  EXPECT_EQ(nichesFor(recessed(1, 2.2, 0, 2.6, 0.3)), 0u);
}

TEST(Niches, OfWhichThePlanHasABayAreNextToNoOpening)
{
  const PlanRoom room = recessed(0.3, 3.7, 0.5, 2.4, 0.46);
  RoomPoints points(0.03);
  points.room(room);
  Floorplan plan{{roomOf(polygon({{0, 0},
                                  {5, 0},
                                  {5, 0.3},
                                  {5.46, 0.3},
                                  {5.46, 3.7},
                                  {5, 3.7},
                                  {5, 4},
                                  {0, 4}}),
                         2.6)}};
  pcl::OpeningDetection<pcl::PointXYZ> detection;
  detection.setInputCloud(points.cloud());
  ASSERT_TRUE(detection.segment(plan)) << detection.getErrorMessage();
  EXPECT_TRUE(plan.rooms[0].niches.empty());
  ASSERT_EQ(plan.openings.size(), 1u);
  EXPECT_LT(plan.openings[0].confidence, 0.05);
}

TEST(Niches, AShallowOneMayBeAClosedDoorOrABlind)
{
  for (const double head : {2.05, 2.1})
    EXPECT_EQ(nichesFor(recessed(1, 1.9, 0, head, 0.12)), 0u) << head;
  EXPECT_EQ(nichesFor(recessed(1, 2.9, 0.4, 2.1, 0.12)), 0u);
}

TEST(Niches, ABackThroughWhichOneSeesOnIsNotClosed)
{
  // A grating: a fifth of the back, away from its rim, is open.
  const auto isOpen = [](const Eigen::Vector3d& p) {
    return p.y() > 1.35 && p.y() < 2.05 && p.z() > 1.2 && p.z() < 1.8;
  };
  Scene scene([&](const Eigen::Vector3d& p) { return p.x() < 5.29 || !isOpen(p); });
  EXPECT_EQ(scene.niches(), 1u) << "a board from which nothing comes back";
  scene.wallAt(5.5, 1.35, 2.05, 1.2, 1.8);
  EXPECT_EQ(scene.niches(), 0u);
  scene.wallAt(5.3, 1.35, 2.05, 1.2, 1.8);
  EXPECT_EQ(scene.niches(), 0u) << "glass in it";
}

TEST(Niches, OfAnLIsARectangle)
{
  // One of its two rectangles: below the part that is missing.
  for (const auto& [from, low] : {std::pair(1.6, 1.4), {2.1, 1.9}}) {
    Scene scene([from = from, low = low](const Eigen::Vector3d& p) {
      return p.x() < 5.01 || p.y() < from || p.z() < low;
    });
    scene.wallAt(5, from, 2.4, low, 2.2);
    const auto found = nichesOf(scene.points, scene.room);
    ASSERT_EQ(found.size(), 1u) << from;
    const PlanElement& mouth = found[0].boundary.elements.back();
    EXPECT_NEAR(mouth.end.y(), 1, 0.02);
    EXPECT_NEAR(mouth.start.y(), 2.4, 0.02);
    EXPECT_NEAR(found[0].bottom.heightAt({5, 2}), 0.8, 0.02);
    EXPECT_NEAR(found[0].top.heightAt({5, 2}), low, 0.06) << "to a cell";
  }
}

TEST(Niches, HeightsCountFromTheFloor)
{
  PlanRoom room = recessed(1, 2.2, -2.1, -0.9, 0.3);
  room.floor = slabAt(-3);
  room.ceiling = slabAt(-0.4);
  expectFound(room, 0.002);
}

TEST(Niches, AWallHasTwo)
{
  PlanRoom room = recessed(0.5, 1.1, 0.9, 2.1, 0.3);
  room.niches.push_back(recessed(2, 3.4, 0.5, 2.1, 0.4).niches[0]);
  expectFound(room, 0.002);
}

/** Returns how many niches are found in both rooms beside a wall of 24 cm, and expects
 * no openings. */
std::vector<std::size_t>
nichesBeside(const PlanRoom& left, const std::vector<PlanNiche>& of_right)
{
  PlanRoom right = roomOf(rectangle(5.24, 0, 10, 4), 2.6, 2);
  right.niches = of_right;
  RoomPoints points(0.03);
  points.room(left);
  points.room(right);
  Floorplan plan{{left, right}};
  pcl::OpeningDetection<pcl::PointXYZ> detection;
  detection.setInputCloud(points.cloud());
  EXPECT_TRUE(detection.segment(plan)) << detection.getErrorMessage();
  EXPECT_TRUE(plan.openings.empty());
  return {plan.rooms[0].niches.size(), plan.rooms[1].niches.size()};
}

TEST(Niches, OneAsLargeAsADoorHasAWallBehindIt)
{
  EXPECT_EQ(nichesBeside(recessed(1, 1.9, 0, 2.05, 0.1), {}),
            (std::vector<std::size_t>{1, 0}));
}

TEST(Niches, OfTwoRoomsMayLieAboveEachOther)
{
  const PlanNiche upper{rectangle(5.08, 1, 5.24, 2.2), slabAt(1.3), slabAt(2.1)};
  EXPECT_EQ(nichesBeside(recessed(1.2, 2.4, 0, 0.9, 0.15), {upper}),
            (std::vector<std::size_t>{1, 1}));
}

/** A room of 4 x 3 x 2.5 m, scanned every 4 cm. */
class MeasuredWalls : public ::testing::Test {
protected:
  using Place = Eigen::Vector3d;

  /** Adds points of a face between two corners, except where `isMissing` is true. */
  void addFace(
      const Place& origin,
      const Place& u,
      const Place& v,
      const std::function<bool(const Place&)>& isMissing = [](const Place&) {
        return false;
      })
  {
    constexpr double step = 0.04;
    for (double a = step / 2; a < u.norm(); a += step)
      for (double b = step / 2; b < v.norm(); b += step) {
        const Place p = origin + a * u.normalized() + b * v.normalized();
        if (!isMissing(p))
          cloud_.emplace_back(p.x(), p.y(), p.z());
      }
  }

  Floorplan measured(const std::vector<PlanRoom>& rooms,
                     const std::shared_ptr<const SightLines>& sight = nullptr,
                     unsigned threads = 0) const
  {
    Floorplan plan{rooms};
    pcl::OpeningDetection<pcl::PointXYZ> detection;
    detection.setInputCloud(cloud_.makeShared());
    detection.setSightLines(sight);
    detection.setNumberOfThreads(threads);
    EXPECT_TRUE(detection.segment(plan)) << detection.getErrorMessage();
    return plan;
  }

  Floorplan measured(const std::shared_ptr<const SightLines>& sight = nullptr) const
  {
    return measured({roomOf(rectangle(0, 0, 4, 3), 2.5)}, sight);
  }

  static const ElementEvidence&
  wall(const Floorplan& plan, std::size_t i, std::size_t room = 0)
  {
    return plan.rooms[room].boundary.elements[i].evidence;
  }

  pcl::PointCloud<pcl::PointXYZ> cloud_;
};

TEST_F(MeasuredWalls, TellsAWallADoorAndACupboardApart)
{
  const auto isDoor = [](const Place& p) {
    return p.x() > 1 && p.x() < 2 && p.z() < 2;
  };
  const auto isCupboard = [](const Place& p) {
    return p.x() > 1 && p.x() < 3 && p.z() < 1.5;
  };
  addFace({0, 0, 0}, {4, 0, 0}, {0, 3, 0}, // the floor, except below the cupboard
          [&](const Place& p) { return p.y() > 2.5 && isCupboard(p); });
  addFace({0, 0, 0}, {4, 0, 0}, {0, 0, 2.5}, isDoor);
  addFace({4, 0, 0}, {0, 3, 0}, {0, 0, 2.5});
  addFace({0, 3, 0}, {4, 0, 0}, {0, 0, 2.5}, isCupboard);
  addFace({1, 2.5, 0}, {2, 0, 0}, {0, 0, 1.5}); // its front
  addFace({1, 2.5, 1.5}, {2, 0, 0}, {0, 0.5, 0});
  const Floorplan plan = measured();
  // A rim of up to half a cell plus a point's reach counts as seen.
  EXPECT_NEAR(wall(plan, 0).opening, 2.0 / 10, 0.03);
  EXPECT_NEAR(wall(plan, 0).seen, 8.0 / 10, 0.03);
  EXPECT_EQ(wall(plan, 0).hidden, 0);
  EXPECT_NEAR(wall(plan, 1).seen, 1, 1e-9);
  EXPECT_NEAR(wall(plan, 2).hidden, 3.0 / 10, 0.03);
  EXPECT_NEAR(wall(plan, 2).opening, 0, 1e-9);
  // The fourth wall was out of view and has no points.
  EXPECT_LT(wall(plan, 3).seen, 0.05);
  EXPECT_EQ(wall(plan, 3).opening, 0);
  EXPECT_NEAR(wall(plan, 3).seen + wall(plan, 3).hidden, 1, 1e-9);
}

TEST_F(MeasuredWalls, RaysProveAnOpeningBehindWhatStandsBeforeIt)
{
  // The walls y = 0 and y = 3 have a hole each, with a screen 0.5 m in front of it. The
  // scanner is between the first screen and its wall.
  const auto isMiddle = [](const Place& p) {
    return p.x() > 1 && p.x() < 3 && p.z() > 0.5 && p.z() < 2;
  };
  addFace({0, 0, 0}, {4, 0, 0}, {0, 3, 0});
  for (const double y : {0.0, 3.0})
    addFace({0, y, 0}, {4, 0, 0}, {0, 0, 2.5}, isMiddle);
  for (const double y : {0.5, 2.5})
    addFace({0.8, y, 0.3}, {2.4, 0, 0}, {0, 0, 1.9});
  const Place from(2, 0.3, 1.25);
  std::vector<SightLine> lines;
  const auto look = [&](const Place& at, double share) {
    lines.push_back({from.cast<float>(), (from + share * (at - from)).cast<float>()});
  };
  for (double x = 0.02; x < 4; x += 0.04)
    for (double z = 0.02; z < 2.5; z += 0.04) {
      look({x, 0, z}, isMiddle({x, 0, z}) ? 4 : 1);
      look({x, 3, z}, 0.1); // blocked by the screen
    }
  const Floorplan guessed = measured();
  EXPECT_NEAR(wall(guessed, 0).hidden, 0.3, 0.04); // 2 x 1.5 of 4 x 2.5 m
  EXPECT_NEAR(wall(guessed, 2).hidden, 0.3, 0.04);
  const Floorplan proved = measured(std::make_shared<const SightLines>(lines));
  EXPECT_NEAR(wall(proved, 0).opening, 0.3, 0.04);
  EXPECT_LT(wall(proved, 0).hidden, 0.01);
  EXPECT_NEAR(wall(proved, 0).seen, wall(guessed, 0).seen, 0.03) << "to a cell";
  EXPECT_EQ(wall(proved, 2).hidden, wall(guessed, 2).hidden) << "rays that end before";
}

TEST_F(MeasuredWalls, OneThatIsAWindowFromEndToEndIsOpen)
{
  const auto isWindow = [](const Place& p) {
    return p.x() > 0.05 && p.x() < 3.95 && p.z() > 0.05;
  };
  addFace({0, 0, 0}, {4, 0, 0}, {0, 0, 2.5}, isWindow);
  Floorplan plan{{roomOf(rectangle(0, 0, 4, 3), 2.5)}};
  plan.openings.resize(1);
  plan.openings[0].walls = {{1, 0}};
  plan.openings[0].start = {0, 0};
  plan.openings[0].end = {4, 0};
  plan.openings[0].top = 2.5;
  const PointView points(cloud_);
  const OpeningSearch search(plan, points, nullptr, nullptr, OpeningParameters());
  measureEvidence(search, 1, plan);
  EXPECT_LT(wall(plan, 0).seen, 0.05);
  EXPECT_GT(wall(plan, 0).opening, 0.95);
}

TEST_F(MeasuredWalls, RoomsWallToWallAreSeenEachAsAloneForAnyNumberOfThreads)
{
  const std::vector<PlanRoom> rooms{roomOf(rectangle(0, 0, 4, 3), 2.5),
                                    roomOf(rectangle(4.1, 0, 7, 3), 2.5),
                                    roomOf(rectangle(20, 0, 23, 3), 2.5)};
  for (const double x : {0.0, 4.0, 4.1, 7.0, 20.0})
    for (int copies = 0; copies < 5; ++copies) // enough points for several threads
      addFace({x, 0, 0}, {0, 3, 0}, {0, 0, 2.5},
              [&](const Place& p) { return x == 4.1 && p.y() > 1 && p.y() < 2; });
  const Floorplan together = measured(rooms, nullptr, 3);
  const Floorplan by_one = measured(rooms, nullptr, 1);
  for (std::size_t r = 0; r < rooms.size(); ++r) {
    const Floorplan alone = measured({rooms[r]}, nullptr, 1);
    for (std::size_t e = 0; e < 4; ++e) {
      const ElementEvidence& one = wall(alone, e);
      const ElementEvidence& other = wall(together, e, r);
      // What is an opening follows from both faces.
      EXPECT_NEAR(one.seen, other.seen, r == 1 && e == 3 ? 0.1 : 0) << r << ' ' << e;
      const ElementEvidence& again = wall(by_one, e, r);
      EXPECT_EQ(again.seen, other.seen) << r << ' ' << e;
      EXPECT_EQ(again.hidden, other.hidden) << r << ' ' << e;
      EXPECT_EQ(again.opening, other.opening) << r << ' ' << e;
    }
  }
  EXPECT_GT(together.rooms[0].boundary.elements[1].evidence.seen, 0.9);
  EXPECT_LT(together.rooms[1].boundary.elements[3].evidence.seen, 0.8);
}

TEST_F(MeasuredWalls, AreNotSeenWhereOnlyTheStoreyAboveIs)
{
  const Floorplan truth = twoStoreys();
  for (const std::size_t r : {2, 3})
    for (const PlanElement& e : truth.rooms[r].boundary.elements) {
      const double floor = truth.rooms[r].floorAt(e.start);
      addFace({e.start.x(), e.start.y(), floor},
              {e.end.x() - e.start.x(), e.end.y() - e.start.y(), 0}, {0, 0, 2.5});
    }
  const Floorplan plan = measured(truth.rooms);
  for (const PlanElement& e : plan.rooms.front().boundary.elements)
    EXPECT_EQ(e.evidence.seen, 0);
  for (const PlanElement& e : plan.rooms.back().boundary.elements)
    EXPECT_GT(e.evidence.seen, 0.9);
}

} // namespace
