// SPDX-License-Identifier: BSD-3-Clause
// What one labelling of a storey makes of beams, shelves and faces that nobody saw.
#include "../plan/two_rooms.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** Expects one room with the elements and corners of the truth. */
void
expectOutline(const RoomPoints& points,
              const PlanEvidence& evidence,
              const PlanLoop& truth,
              double tolerance)
{
  const Floorplan plan = planOf(points, evidence);
  ASSERT_EQ(plan.rooms.size(), 1U);
  const PlanLoop& loop = plan.rooms[0].boundary;
  EXPECT_EQ(loop.elements.size(), truth.elements.size());
  EXPECT_LT(cornerError(loop, truth), tolerance);
  EXPECT_NEAR(loop.area(), truth.area(), tolerance * truth.length());
}

/** Expects the outline of points on all of a room. */
void
expectOutline(const PlanLoop& truth, double noise, double tolerance)
{
  RoomPoints points(0.05, noise);
  const RoomParts parts = points.room(truth, 0, 2.5);
  expectOutline(points, evidenceOf(points, parts), truth, tolerance);
}

TEST(LabelledPlan, APilasterIsPartOfTheOutline)
{
  expectOutline(
      polygon({{0, 0}, {5, 0}, {5, 1.5}, {4.7, 1.5}, {4.7, 2}, {5, 2}, {5, 4}, {0, 4}}),
      0.003, 0.004);
}

TEST(LabelledPlan, WallsThatAreNotSquare)
{
  expectOutline(polygon({{0, 0}, {6, 0}, {6, 2.5}, {4, 4}, {0, 4}}), 0.003, 0.004);
}

TEST(LabelledPlan, AWallGoesStraightOnBehindShelvesThatStandOffIt)
{
  // Shelves 2.1 m high, 5 cm before the wall, which is seen above and beside them.
  const PlanLoop truth = rectangle(0.01, 0.01, 5.01, 4.01);
  RoomPoints points(0.05, 0.003);
  const auto isHidden = [](const Eigen::Vector3d& p) {
    return p.y() > 3.97 && p.x() > 1 && p.x() < 3 && p.z() < 2.1;
  };
  const RoomParts parts = points.room(
      roomOf(truth, 2.5), [&](const Eigen::Vector3d& p) { return !isHidden(p); });
  PlanEvidence evidence = evidenceOf(points, parts);
  const std::vector<int> shelves = points.wall(segment({1, 3.96}, {3, 3.96}), 0, 2.1);
  evidence.all = joined(evidence.all, shelves);
  evidence.walls = joined(evidence.walls, shelves);
  expectOutline(points, evidence, truth, 0.004);
}

TEST(LabelledPlan, ABeamPartsNoRoom)
{
  for (const double width : {0.02, 0.12, 0.3}) {
    PlanRoom truth = roomOf(rectangle(0.01, 0.01, 9.01, 5.01), 2.8);
    truth.details = {detailOf(rectangle(5, 0.01, 5 + width, 5.01), 2.45)};
    RoomPoints points(0.05, 0.003);
    const RoomParts parts = points.room(truth);
    PlanEvidence evidence = evidenceOf(points, parts);
    evidence.walls = joined(evidence.walls, evidence.details); // as wall growing may
    const Floorplan plan = planOf(points, evidence);
    ASSERT_EQ(plan.rooms.size(), 1U);
    EXPECT_EQ(plan.rooms[0].boundary.elements.size(), 4U) << width;
    EXPECT_NEAR(plan.rooms[0].area(), 45, 0.1) << width;
  }
}

TEST(LabelledPlan, WallsMeetInACornerThatIsHiddenFarAlongBoth)
{
  const PlanLoop truth = rectangle(0.01, 0.01, 8.01, 6.01);
  RoomPoints points(0.05, 0.003);
  const RoomParts parts = points.room(roomOf(truth, 2.5), [](const Eigen::Vector3d& p) {
    return p.x() < 5 || p.y() < 3; // 3 m of each
  });
  expectOutline(points, evidenceOf(points, parts), truth, 0.004);
}

TEST(LabelledPlan, AWallEndsMidwayBetweenTheEndsOfItsFaces)
{
  // Of a wall of 0.12 m that ends in the room the end itself was not seen.
  RoomPoints points(0.05, 0.003);
  RoomParts parts = points.room(rectangle(0.01, 0.01, 6.01, 5.01), 0, 2.5);
  for (const auto& face :
       {segment({0.01, 2.5}, {3, 2.5}), segment({3.06, 2.62}, {0.01, 2.62})})
    parts.walls = joined(parts.walls, points.wall(face, 0, 2.5));
  const auto outside = [](const std::vector<int>& of, const RoomPoints& all) {
    std::vector<int> kept;
    for (const int i : of)
      if (const Eigen::Vector3f p = all.view()[static_cast<std::size_t>(i)];
          !(p.x() < 3.03 && p.y() > 2.5 && p.y() < 2.62))
        kept.push_back(i);
    return kept;
  };
  parts.floor = outside(parts.floor, points);
  parts.ceiling = outside(parts.ceiling, points);
  const Floorplan plan = planOf(points, evidenceOf(points, parts));
  ASSERT_EQ(plan.rooms.size(), 1U);
  double end = 0;
  for (const auto& e : plan.rooms[0].boundary.elements)
    if (e.start.x() < 4 && e.start.x() > 2)
      end = std::max(end, e.start.x());
  EXPECT_NEAR(end, 3.03, 0.03);
}

TEST(LabelledPlan, EndsWhereTheAirEndsThatWasSeen)
{
  // Nobody saw the wall at x = 5, nor anything beyond it.
  const PlanLoop truth = rectangle(0.01, 0.01, 5.01, 4.01);
  RoomPoints points(0.05, 0.003);
  const RoomParts parts = points.room(
      roomOf(truth, 2.5), [](const Eigen::Vector3d& p) { return p.x() < 4.9; });
  const Floorplan plan = planOf(points, evidenceOf(points, parts));
  ASSERT_EQ(plan.rooms.size(), 1U);
  EXPECT_EQ(plan.rooms[0].boundary.elements.size(), 4U);
  EXPECT_NEAR(plan.rooms[0].area(), 4.95 * 4, 0.21);
}

} // namespace
