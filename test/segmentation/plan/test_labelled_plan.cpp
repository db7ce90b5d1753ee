// SPDX-License-Identifier: BSD-3-Clause
// What one labelling of a storey makes of beams, shelves and faces that nobody saw.
#include "room_evidence.h"

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
