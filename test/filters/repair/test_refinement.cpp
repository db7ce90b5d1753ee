// SPDX-License-Identifier: BSD-3-Clause
#include "room_points.h"

#include <pcl/sedr_filters/impl/refinement.h>
#include <pcl/sedr_filters/vertical_hole_repair.h>

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <random>
#include <set>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

constexpr auto ceiling = static_cast<std::uint32_t>(StructureLabel::Ceiling);
constexpr auto ground = static_cast<std::uint32_t>(StructureLabel::Floor);
constexpr auto wall = static_cast<std::uint32_t>(StructureLabel::Wall);

/** Two rooms of 2 m x 1.5 m with 10 cm of wall between them, as points with errors of 1
 * cm and as a plan. */
struct TwoRooms {
  RoomPoints points{0.05, 0.01};
  Floorplan plan;
  std::vector<std::uint32_t> labels;
  std::vector<std::uint32_t> rooms;

  TwoRooms()
  {
    add(rectangle(0, 0, 2, 1.5), 2.4, 1);
    add(rectangle(2.1, 0, 4.1, 1.5), 2.7, 2);
  }

private:
  void add(const PlanLoop& loop, double height, std::uint32_t id)
  {
    const RoomParts parts = points.room(loop, 0, height);
    plan.rooms.push_back(roomOf(loop, height, id));
    labels.resize(points.size());
    rooms.resize(points.size(), id);
    for (const int i : parts.floor)
      labels[static_cast<std::size_t>(i)] = ground;
    for (const int i : parts.ceiling)
      labels[static_cast<std::size_t>(i)] = ceiling;
    for (const int i : parts.walls)
      labels[static_cast<std::size_t>(i)] = wall;
  }
};

Refinement
refine(const TwoRooms& scene, double farthest = 0.1, unsigned threads = 1)
{
  return refineToPlan(scene.points.view(), scene.points.all(), scene.labels,
                      scene.rooms, scene.plan, farthest, threads);
}

TEST(RefineToPlan, PutsEveryPointOnItsRoomExactly)
{
  const TwoRooms scene;
  const Refinement result = refine(scene);
  // Noise moves some slab points outside the plan of a room, but no wall points.
  EXPECT_EQ(result.sources.size(), scene.points.size());
  ASSERT_EQ(result.points.size(), result.sources.size());
  for (std::size_t k = 0; k < result.points.size(); ++k) {
    const SurfacePoint& p = result.points[k];
    const auto i = static_cast<std::size_t>(result.sources[k]);
    const PlanRoom& room = scene.plan.rooms[p.room - 1];
    ASSERT_EQ(p.room, scene.rooms[i]);
    ASSERT_EQ(static_cast<std::uint32_t>(p.label), scene.labels[i]);
    const Eigen::Vector3d from = scene.points[result.sources[k]].cast<double>();
    if (p.label == StructureLabel::Wall) {
      ASSERT_NEAR(room.boundary.distance(p.position.head<2>()), 0, 1e-12);
      ASSERT_EQ(p.position.z(), from.z());
    }
    else {
      const double z = p.label == StructureLabel::Floor ? 0 : p.room == 1 ? 2.4 : 2.7;
      ASSERT_NEAR(p.position.z(), z, 1e-12);
      ASSERT_EQ(p.position.head<2>(), from.head<2>());
    }
    ASSERT_LT((p.position - from).norm(), 0.06);
  }
}

TEST(RefineToPlan, KeepsThePartitionsTwoFacesApart)
{
  const TwoRooms scene;
  std::set<double> faces;
  for (const auto& p : refine(scene).points)
    if (p.label == StructureLabel::Wall && p.position.x() > 1.9 &&
        p.position.x() < 2.2 && p.position.y() > 0.01 && p.position.y() < 1.49)
      faces.insert(p.position.x());
  EXPECT_EQ(faces, (std::set<double>{2, 2.1}));
}

TEST(RefineToPlan, LeavesOutWhatIsNoStructure)
{
  TwoRooms scene;
  const auto unlabelled = scene.points.point(1, 0, 1);
  const auto roomless = scene.points.point(1, 0, 1);
  const auto elsewhere = scene.points.point(1, 0, 1);
  const auto lost = scene.points.point(1, 0, std::numeric_limits<double>::quiet_NaN());
  const auto far = scene.points.point(1, 0.2, 1);
  const auto good = scene.points.point(1, 0.02, 1);
  for (const std::uint32_t label : {0u, wall, wall, wall, wall, wall})
    scene.labels.push_back(label);
  for (const std::uint32_t room : {1u, 0u, 9u, 1u, 1u, 1u})
    scene.rooms.push_back(room);
  const Refinement result = refine(scene);
  const std::set<int> kept(result.sources.begin(), result.sources.end());
  for (const int i : {unlabelled, roomless, elsewhere, lost, far})
    EXPECT_EQ(kept.count(i), 0u) << i;
  EXPECT_EQ(kept.count(good), 1u);
}

TEST(RefineToPlan, TakesTheIndexedPointsInTheirOrder)
{
  const TwoRooms scene;
  const std::vector<int> indices{500, 3, 1700, 4};
  const Refinement result = refineToPlan(scene.points.view(), indices, scene.labels,
                                         scene.rooms, scene.plan, 0.1, 1);
  EXPECT_EQ(result.sources, indices);
  const Refinement whole = refine(scene);
  ASSERT_EQ(whole.sources, scene.points.all());
  for (std::size_t k = 0; k < indices.size(); ++k) {
    EXPECT_EQ(result.points[k].position,
              whole.points[static_cast<std::size_t>(indices[k])].position);
  }
}

TEST(RefineToPlan, IsTheSameForAnyNumberOfThreads)
{
  const TwoRooms scene;
  ASSERT_GT(scene.points.size(), 8192u) << "more than a block for each thread";
  const Refinement one = refine(scene, 0.02, 1);
  ASSERT_LT(one.sources.size(), scene.points.size());
  for (const unsigned threads : {2u, 5u, 0u}) {
    const Refinement many = refine(scene, 0.02, threads);
    ASSERT_EQ(many.sources, one.sources) << threads;
    for (std::size_t k = 0; k < one.points.size(); ++k) {
      ASSERT_EQ(many.points[k].position, one.points[k].position);
      ASSERT_EQ(many.points[k].normal, one.points[k].normal);
    }
  }
}

TEST(RepairHoles, GivesOnePointForEveryCellOfEveryRoom)
{
  const TwoRooms scene;
  const Refinement refined = refine(scene);
  const std::vector<RepairedPoint> repaired =
      repairHoles(refined.points, scene.plan, 0.05);
  // Both rooms divide into 5 cm squares without remainder.
  const double area = 2 * 2 * 3.0 + 7 * 2.4 + 7 * 2.7;
  EXPECT_EQ(repaired.size(), std::lround(area / 0.0025));
  for (std::size_t k = 1; k < repaired.size(); ++k)
    ASSERT_LE(repaired[k - 1].point.room, repaired[k].point.room) << "room by room";
  std::set<int> sources;
  for (const auto& p : repaired) {
    if (p.source < 0)
      continue;
    ASSERT_TRUE(sources.insert(p.source).second) << "a point stands for one cell";
    ASSERT_EQ(p.point.position,
              refined.points[static_cast<std::size_t>(p.source)].position);
  }
  EXPECT_GT(sources.size(), repaired.size() * 9 / 10);
}

TEST(RepairHoles, WithoutPointsMakesTheWholeRoom)
{
  Floorplan plan;
  plan.rooms.push_back(roomOf(rectangle(0, 0, 2, 1), 2, 5));
  const auto repaired = repairHoles({}, plan, 0.1);
  EXPECT_EQ(repaired.size(), 2u * 200u + 60u * 20u);
  for (const auto& p : repaired) {
    ASSERT_EQ(p.source, -1);
    ASSERT_EQ(p.point.room, 5u);
  }
  EXPECT_TRUE(repairHoles({}, Floorplan(), 0.1).empty());
}

/** Random points on all surfaces of a room of 6 m x 4 m x 2.5 m, `density` per square
 * metre. With `is_open`, the walls x = 0 and y = 0 have none. */
std::vector<SurfacePoint>
scattered(const PlanRoom& room, double density, bool is_open)
{
  std::mt19937 random(5);
  std::vector<SurfacePoint> points;
  const std::vector<SurfacePoint> all = [&] {
    std::vector<SurfacePoint> fine;
    for (const auto& p : repairHoles({}, Floorplan{{room}}, 0.02))
      fine.push_back(p.point);
    return fine;
  }();
  std::bernoulli_distribution is_hit(density * 0.02 * 0.02);
  for (const auto& p : all)
    if (is_hit(random) && !(is_open && std::abs(p.normal.z()) < 0.5 &&
                            (p.position.x() < 0.01 || p.position.y() < 0.01)))
      points.push_back(p);
  return points;
}

TEST(RepairHoles, WhatASparseScanCoversEvenlyIsSeenAndWhatItLacksIsNot)
{
  const PlanRoom room = roomOf(rectangle(0, 0, 6, 4), 2.5);
  for (const double spacing : {0.04, 0.1, 0.15}) {
    SCOPED_TRACE(spacing);
    const double density = 1 / (spacing * spacing);
    std::map<std::uint32_t, UnseenShares> unseen;
    repairHoles(scattered(room, density, false), Floorplan{{room}}, 0.05, nullptr,
                &unseen);
    EXPECT_LT(unseen.at(1).surface, 0.23);
    EXPECT_EQ(unseen.at(1).walls, 0);
    repairHoles(scattered(room, density, true), Floorplan{{room}}, 0.05, nullptr,
                &unseen);
    EXPECT_NEAR(unseen.at(1).walls, 0.5, 0.03);
    EXPECT_GT(unseen.at(1).surface, 0.25);
  }
  std::map<std::uint32_t, UnseenShares> unseen;
  repairHoles({}, Floorplan{{room}}, 0.05, nullptr, &unseen);
  EXPECT_EQ(unseen.at(1).walls, 1);
  EXPECT_EQ(unseen.at(1).surface, 1);
}

} // namespace
