// SPDX-License-Identifier: BSD-3-Clause
#include "shaken_plans.h"

namespace {

using namespace sedr_test;

TEST(AdjustPlan, ARoomWithNoiseIsMet)
{
  // A wall of 20,000 points: 0.07 mm in its middle at 1 cm of noise.
  for (const double noise : {0.0, 0.003, 0.01, 0.02})
    for (const unsigned seed : {1u, 2u, 3u, 4u}) {
      RoomPoints raw(0.02, noise, seed);
      raw.room(plainRoom());
      Floorplan plan = offPlan(plainRoom(), 0.03, seed);
      const AdjustmentReport report = adjustPlan(plan, raw.view(), {}, ofCoarsePlans());
      const PlanRoom& room = plan.rooms[0];
      const double bar = 1e-5 + 0.06 * noise;
      EXPECT_EQ(report.walls, 4u);
      EXPECT_EQ(report.slabs, 2u);
      EXPECT_NEAR(report.noise, std::max(noise, 0.0003), 0.1 * noise + 0.0003);
      EXPECT_LT(report.waviness, 0.0001 + 0.1 * noise);
      EXPECT_LT(cornerErrorInOrder(room.boundary, rectangle(0, 0, 4, 3)), bar) << noise;
      for (const Vector2d& p : {Vector2d(0, 0), Vector2d(4, 0), Vector2d(4, 3)}) {
        EXPECT_NEAR(room.floor.heightAt(p), 0, bar);
        EXPECT_NEAR(room.ceiling.heightAt(p), 2.6, bar);
      }
      for (const auto& e : room.boundary.elements)
        EXPECT_NEAR(e.residual, noise, 0.1 * noise + 1e-6);
    }
}

TEST(AdjustPlan, BothFacesOfAPartitionAreMet)
{
  for (const double thickness : {0.06, 0.1, 0.2})
    for (const unsigned seed : {1u, 2u}) {
      const PlanLoop left = rectangle(0, 0, 3, 4);
      const PlanLoop right = rectangle(3 + thickness, 0, 7, 4);
      RoomPoints raw(0.03, 0.005, seed);
      raw.room(left, 0, 2.5);
      raw.room(right, 0, 2.5);
      Floorplan plan = offPlan(roomOf(left, 2.5), 0.01, seed);
      plan.rooms.push_back(roomOf(shaken(right, 0.01, seed + 7), 2.5));
      adjustPlan(plan, raw.view());
      EXPECT_LT(cornerErrorInOrder(plan.rooms[0].boundary, left), 0.0005) << thickness;
      EXPECT_LT(cornerErrorInOrder(plan.rooms[1].boundary, right), 0.0005) << thickness;
    }
}

TEST(AdjustPlan, TangentArcsStayTangent)
{
  const PlanLoop truth = roundedRectangle(6, 4, 1);
  RoomPoints raw(0.02, 0.005);
  raw.room(truth, 0, 3);
  Floorplan plan = offPlan(roomOf(truth, 3), 0.01);
  adjustPlan(plan, raw.view());
  const auto& elements = plan.rooms[0].boundary.elements;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const PlanElement& e = elements[i];
    EXPECT_LT((e.normalAt(e.length()) - elements[(i + 1) % 8].normalAt(0)).norm(),
              1e-8);
    if (e.isArc()) {
      EXPECT_NEAR(e.radius, 1, 0.001);
      EXPECT_LT((e.centre - truth.elements[i].centre).norm(), 0.001);
    }
  }
}

TEST(AdjustPlan, ArcsThatMeetAtACornerKeepIt)
{
  PlanLoop truth = rectangle(0, 0, 4, 3);
  truth.elements[1] = arc({3, 1.5}, std::hypot(1, 1.5), -56.309932474, 56.309932474);
  truth.elements[0].end = truth.elements[1].start;
  truth.elements[2].start = truth.elements[1].end;
  RoomPoints raw(0.02, 0.005);
  raw.room(truth, 0, 3);
  Floorplan plan = offPlan(roomOf(truth, 3), 0.01);
  adjustPlan(plan, raw.view());
  EXPECT_LT(cornerErrorInOrder(plan.rooms[0].boundary, truth), 0.001);
}

TEST(AdjustPlan, ColumnsNichesAndSoffitsAreMet)
{
  PlanRoom truth = roomOf(rectangle(0, 0, 6, 5), 3);
  truth.columns = {reversed(circle({2, 2}, 0.2)), reversed(circle({4, 2}, 0.2)),
                   reversed(rectangle(3, 3.5, 3.3, 3.8))};
  truth.details.push_back(detailOf(rectangle(0, 0, 6, 0.6), 2.6));
  truth.niches.push_back({rectangle(2, 5, 3, 5.3), slabAt(0.8), slabAt(2.2)});
  RoomPoints raw(0.015, 0.004);
  raw.room(truth);
  PlanRoom off = truth;
  for (PlanLoop& column : off.columns)
    column = shaken(column, 0.01, 3);
  off.details[0].boundary = rectangle(0, 0, 6, 0.61);
  off.details[0].slab = slabAt(2.608);
  off.niches[0].top = slabAt(2.19);
  off.niches[0].boundary = rectangle(2, 5, 3, 5.292);
  Floorplan plan;
  plan.rooms.push_back(off);
  adjustPlan(plan, raw.view());
  const PlanRoom& room = plan.rooms[0];
  EXPECT_LT(cornerErrorInOrder(room.boundary, truth.boundary), 0.0005);
  for (const std::size_t c : {0, 1}) {
    EXPECT_LT((room.columns[c].elements[0].centre - truth.columns[c].elements[0].centre)
                  .norm(),
              0.0005);
    EXPECT_NEAR(room.columns[c].elements[0].radius, 0.2, 0.0005);
  }
  EXPECT_LT(cornerErrorInOrder(room.columns[2], truth.columns[2]), 0.001);
  EXPECT_LT(cornerErrorInOrder(room.details[0].boundary, truth.details[0].boundary),
            0.001);
  EXPECT_NEAR(room.details[0].slab.heightAt({3, 0.3}), 2.6, 0.0005);
  EXPECT_LT(cornerErrorInOrder(room.niches[0].boundary, truth.niches[0].boundary),
            0.002);
  EXPECT_NEAR(room.niches[0].bottom.heightAt({2.5, 5.1}), 0.8, 0.001);
  EXPECT_NEAR(room.niches[0].top.heightAt({2.5, 5.1}), 2.2, 0.001);
}

TEST(AdjustPlan, AWallThatIsHalfADegreeOffIsNotMadeSquare)
{
  const double turn = 4 * std::tan(0.5 * M_PI / 180);
  for (const double off : {0.0, turn}) {
    const PlanLoop truth = polygon({{0, 0}, {4, off}, {4, 3}, {0, 3}});
    RoomPoints raw(0.02, 0.005);
    raw.room(truth, 0, 2.6);
    Floorplan plan = offPlan(roomOf(truth, 2.6), 0.008);
    adjustPlan(plan, raw.view());
    const PlanLoop& found = plan.rooms[0].boundary;
    EXPECT_LT(cornerErrorInOrder(found, truth), 0.0006);
    const Vector2d wall = found.elements[0].end - found.elements[0].start;
    const Vector2d beside = found.elements[1].end - found.elements[1].start;
    const double sine = std::abs(wall.normalized().dot(beside.normalized()));
    if (off == 0)
      EXPECT_LT(sine, 1e-9); // exactly square
    else
      EXPECT_NEAR(sine, std::sin(0.5 * M_PI / 180), 0.0003);
  }
}

TEST(AdjustPlan, PartsOfOneWallComeOnOneLine)
{
  // A wall with a gap of 1 m; 1 cm between its parts is a step.
  for (const double step : {0.0, 0.01}) {
    const PlanLoop truth = polygon(
        {{0, 0}, {2, 0}, {2, -1}, {3, -1}, {3, step}, {6, step}, {6, 4}, {0, 4}});
    RoomPoints raw(0.02, 0.005);
    raw.room(truth, 0, 2.6);
    Floorplan plan = offPlan(roomOf(truth, 2.6), 0.005);
    adjustPlan(plan, raw.view());
    const auto& e = plan.rooms[0].boundary.elements;
    EXPECT_LT(cornerErrorInOrder(plan.rooms[0].boundary, truth), 0.001);
    const Vector2d way = (e[0].end - e[0].start).normalized();
    const double between = std::abs(way.x() * (e[4].end - e[0].start).y() -
                                    way.y() * (e[4].end - e[0].start).x());
    if (step == 0)
      EXPECT_LT(between, 1e-9);
    else
      EXPECT_NEAR(between, step, 0.001);
  }
}

TEST(AdjustPlan, WallsWithAStepOfMillimetresBetweenThemStayWithinIt)
{
  // No element of the plan is the step, so the walls can't meet where they are seen.
  for (const double step : {0.002, 0.005, 0.01})
    for (const unsigned seed : {1u, 2u}) {
      const PlanLoop truth =
          polygon({{0, 0}, {4, 0}, {4, step}, {8, step}, {8, 4}, {0, 4}});
      RoomPoints raw(0.02, 0.005, seed);
      raw.room(roomOf(truth, 2.5));
      Floorplan plan = offPlan(
          roomOf(polygon({{0, 0}, {4, step / 2}, {8, step}, {8, 4}, {0, 4}}), 2.5),
          0.01, seed);
      adjustPlan(plan, raw.view());
      const auto& walls = plan.rooms[0].boundary.elements;
      EXPECT_NEAR(walls[0].pointAt(2).y(), 0, step / 2 + 0.001) << step;
      EXPECT_NEAR(walls[1].pointAt(2).y(), step, step / 2 + 0.001) << step;
    }
}

TEST(AdjustPlan, AWallThatNobodySawKeepsItsPlaceAndFollowsTheOthers)
{
  RoomPoints raw(0.02, 0.003);
  raw.room(plainRoom(), [](const Vector3d& p) { return p.y() > 1e-9; });
  Floorplan plan;
  plan.rooms.push_back(
      roomOf(polygon({{0.004, 0.02}, {4.006, 0.03}, {3.995, 3}, {0, 3.005}}), 2.6));
  const AdjustmentReport report = adjustPlan(plan, raw.view());
  EXPECT_EQ(report.walls, 3u);
  const auto& e = plan.rooms[0].boundary.elements;
  EXPECT_NEAR(e[0].start.y(), 0.025, 0.002);
  EXPECT_NEAR(e[0].start.y(), e[0].end.y(), 0.0005); // square to its neighbours
  EXPECT_NEAR(e[0].start.x(), 0, 0.0005);
  EXPECT_NEAR(e[0].end.x(), 4, 0.0005);
}

TEST(AdjustPlan, SlopesOfSlabsAreMetAndLevelOnesAreLevel)
{
  PlanRoom truth = plainRoom();
  truth.ceiling = slabAt(2.59, 0.004, -0.002);
  RoomPoints raw(0.02, 0.005);
  raw.room(truth);
  Floorplan plan = offPlan(plainRoom(), 0.005);
  adjustPlan(plan, raw.view());
  EXPECT_LT(plan.rooms[0].floor.plane.head<2>().norm(), 1e-12);
  for (const Vector2d& p : {Vector2d(0, 0), Vector2d(4, 0), Vector2d(4, 3)})
    EXPECT_NEAR(plan.rooms[0].ceiling.heightAt(p), truth.ceiling.heightAt(p), 0.0005);
}

using AtHeight = std::function<double(double z)>;

/** The plain room with its wall at x = 4 m moved into it by so much at each height, and
 * the others by `others`. */
std::vector<Eigen::Vector3f>
withMovedWalls(
    const AtHeight& into,
    const AtHeight& others = [](double) { return 0; })
{
  RoomPoints upright(0.02, 0.004);
  upright.room(plainRoom());
  std::vector<Eigen::Vector3f> points;
  for (const int i : upright.all()) {
    Eigen::Vector3f p = upright[i];
    const auto other = static_cast<float>(others(p.z()));
    if (std::abs(p.x() - 4) < 0.02F)
      p.x() -= static_cast<float>(into(p.z()));
    else if (std::abs(p.x()) < 0.02F)
      p.x() += other;
    else if (std::abs(p.y() - 1.5) > 1.48F)
      p.y() += p.y() < 1.5 ? other : -other;
    points.push_back(p);
  }
  return points;
}

PointView
viewOf(const std::vector<Eigen::Vector3f>& points)
{
  return PointView(points.data(), sizeof(Eigen::Vector3f), points.size());
}

double
runOf(double degrees)
{
  return std::tan(degrees * M_PI / 180);
}

/** A plan of that room with a wall at x = 4 m of which a tilt is assumed; as all plans
 * it is right below the ceiling, where the wall is moved by `into`. */
Floorplan
planWith(double degrees, double into)
{
  Floorplan plan = offPlan(plainRoom(), 0.005);
  std::vector<PlanElement>& walls = plan.rooms[0].boundary.elements;
  for (Vector2d* const end :
       {&walls[0].end, &walls[1].start, &walls[1].end, &walls[2].start})
    end->x() += runOf(degrees) * 2.35 - into;
  walls[1].tilt = degrees * M_PI / 180;
  return plan;
}

TEST(AdjustPlan, TiltedWallsAreMetAtTheirFeet)
{
  for (const double given : {0.0, 2.0, 3.0})
    for (const double degrees : {1.2, 2.0, 3.0}) {
      if (degrees - given > 2) // too far off
        continue;
      SCOPED_TRACE(testing::Message() << given << " degrees, truth " << degrees);
      const auto points = withMovedWalls([&](double z) { return runOf(degrees) * z; });
      Floorplan plan = planWith(given, runOf(degrees) * 2.35);
      const PlanLoop& boundary = plan.rooms[0].boundary;
      adjustPlan(plan, viewOf(points), {}, ofCoarsePlans());
      EXPECT_NEAR(boundary.elements[1].tilt, degrees * M_PI / 180, 0.0005);
      for (const std::size_t wall : {0, 2, 3})
        EXPECT_EQ(boundary.elements[wall].tilt, 0) << wall;
      EXPECT_LT(cornerErrorInOrder(boundary, rectangle(0, 0, 4, 3)), 0.001);
    }
}

TEST(AdjustPlan, WallsThatOnlySeemToTiltAreVertical)
{
  const auto panel = [](double z) { return z < 1.3 ? 0 : 0.04; };
  const auto tolerance = [](double z) { return runOf(0.8) * z; };
  const auto drift = [](double z) { return runOf(1.3) * (z - 2.35); };
  for (const auto& points :
       {withMovedWalls(panel), withMovedWalls(tolerance),
        withMovedWalls(drift, [&](double z) { return -drift(z); })})
    for (const double given : {0.0, 2.0}) {
      Floorplan plan = planWith(given, 0);
      const PlanLoop& boundary = plan.rooms[0].boundary;
      adjustPlan(plan, viewOf(points), {}, ofCoarsePlans());
      for (const PlanElement& wall : boundary.elements)
        EXPECT_EQ(wall.tilt, 0);
      EXPECT_LT(cornerErrorInOrder(boundary, rectangle(0, 0, 4, 3)), 0.05);
    }
}

TEST(AdjustPlan, ErrorsThatPointsShareAreMeasured)
{
  // A depth camera: waves of 5 mm, some 40 cm long.
  RoomPoints even(0.02, 0.002);
  even.room(roomOf(rectangle(0, 0, 8, 6), 3));
  std::vector<Eigen::Vector3f> points;
  const auto wave = [](double a, double b) {
    return 0.007 * std::sin(5 * a + std::sin(3 * b)) * std::sin(4.3 * b + 1);
  };
  for (const int i : even.all()) {
    Vector3d p = even[i].cast<double>();
    const double off = wave(p.x() + p.y(), p.z() + p.x());
    if (p.z() < 0.05 || p.z() > 2.95)
      p.z() += wave(p.x(), p.y());
    else if (p.x() < 0.05 || p.x() > 7.95)
      p.x() += off;
    else
      p.y() += off;
    points.push_back(p.cast<float>());
  }
  const PointView raw(points.data(), sizeof(Eigen::Vector3f), points.size());
  Floorplan plan = offPlan(roomOf(rectangle(0, 0, 8, 6), 3), 0.01);
  const AdjustmentReport report = adjustPlan(plan, raw);
  EXPECT_NEAR(report.waviness, 0.0035, 0.001);
  EXPECT_GT(report.correlation, 0.15);
  EXPECT_LT(report.correlation, 0.6);
  EXPECT_LT(cornerErrorInOrder(plan.rooms[0].boundary, rectangle(0, 0, 8, 6)), 0.003);
}

TEST(AdjustPlan, RefusesEmptyLoopsAndLeavesWhatNoPointShows)
{
  Floorplan plan = offPlan(plainRoom(), 0.01);
  const PlanLoop was = plan.rooms[0].boundary;
  EXPECT_EQ(adjustPlan(plan, PointView()).problem,
            "none of the 0 points of the scan lies at a surface of the plan");
  EXPECT_LT(cornerErrorInOrder(plan.rooms[0].boundary, was), 0.02);
  plan.rooms[0].boundary.elements.clear();
  RoomPoints raw(0.05);
  raw.room(plainRoom());
  EXPECT_EQ(adjustPlan(plan, raw.view()).problem, "room 1 has a loop of 0 elements");
}

} // namespace
