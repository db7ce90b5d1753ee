// SPDX-License-Identifier: BSD-3-Clause
// Plans of rooms of many shapes, from their points.
#include "room_evidence.h"

#include <utility>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;
using Eigen::Vector2d;

std::size_t
arcsOf(const PlanLoop& loop)
{
  return static_cast<std::size_t>(std::count_if(
      loop.elements.begin(), loop.elements.end(), [](auto& e) { return e.isArc(); }));
}

/** Expects as many segments and arcs as in the truth, its corners and its outline. */
void
expectShape(const PlanLoop& truth, double noise, double tolerance)
{
  const PlanLoop loop = fitted(roomOf(truth, 2.5), noise).boundary;
  EXPECT_EQ(loop.elements.size(), truth.elements.size());
  EXPECT_EQ(arcsOf(loop), arcsOf(truth));
  EXPECT_LT(cornerError(loop, truth), tolerance);
  EXPECT_LT(outlineError(loop, truth), tolerance);
}

TEST(WallShapes, CornersAtAnyAngleInTheGrid)
{
  const PlanLoop shape = polygon({{0, 0}, {5, 0}, {5, 2}, {2, 2}, {2, 4}, {0, 4}});
  for (const double degrees : {0, 3, 17, 30, 45, 62, 88})
    for (const double noise : {0.0, 0.02}) {
      SCOPED_TRACE(testing::Message() << degrees << " noise " << noise);
      expectShape(placed(shape, degrees, {1.013, -7.021}), noise, 0.003 + noise / 2);
    }
}

TEST(WallShapes, ARoundRoomIsOneCircle)
{
  for (const double radius : {0.8, 2.0}) {
    const PlanLoop loop =
        fitted(roomOf(circle({3.02, 1.01}, radius), 2.5), 0.01).boundary;
    ASSERT_EQ(loop.elements.size(), 1u) << radius;
    EXPECT_TRUE(loop.elements[0].isArc());
    EXPECT_NEAR((loop.elements[0].centre - Vector2d(3.02, 1.01)).norm(), 0, 0.003);
    EXPECT_NEAR(loop.elements[0].radius, radius, 0.003);
  }
}

TEST(WallShapes, CurvedWallsThatMeetOthersAtAnAngle)
{
  const double half = std::asin(3.0 / 5) * 180 / M_PI;
  const PlanLoop bulging{{segment({-3, 0}, {3, 0}), segment({3, 0}, {3, 4}),
                          arc({0, 0}, 5, 90 - half, 90 + half),
                          segment({-3, 4}, {-3, 0})}};
  for (const double degrees : {0.0, 20.0, 45.0}) {
    SCOPED_TRACE(degrees);
    expectShape(placed(bulging, degrees, {0.01, 0.02}), 0.005, 0.015);
    expectShape(placed(bittenRectangle(6, 4, 1.2), degrees, {0.01, 0.02}), 0.005, 0.01);
  }
}

TEST(WallShapes, ACurvedWallIsOneThoughSoffitsOfWindowsWereSeenBehindIt)
{
  const double radius = 5.24;
  const double half = std::asin(2.1 / radius) * 180 / M_PI;
  const Vector2d middle(radius * std::cos(half * M_PI / 180), 2.1);
  const PlanLoop walls{{segment({0, 0}, {3.7, 0}), segment({3.7, 0}, {3.7, 4.2}),
                        segment({3.7, 4.2}, {0, 4.2}),
                        arc(middle, radius, 180 - half, 180 + half)}};
  const double depth = 0.25;
  const double head = 2.2;
  // How far behind a wall with windows, and how far along it; 0 elsewhere.
  const auto windowAt = [&](const Vector2d& p) -> std::pair<double, double> {
    const Vector2d d = p - middle;
    const double behind[] = {-p.y(), p.y() - 4.2, d.norm() - radius};
    const double along[] = {p.x() - 0.9, p.x() - 0.9,
                            std::abs(std::atan2(d.y(), -d.x())) * radius - 0.4};
    for (const int k : {0, 1, 2})
      if (behind[k] > -0.05 && along[k] > 0 && along[k] < (k < 2 ? 1.9 : 1.3))
        return {behind[k], along[k]};
    return {-1, 0};
  };
  RoomPoints points(0.05, 0.003);
  RoomParts parts = points.room(roomOf(walls, 2.57), [&](const Eigen::Vector3d& p) {
    return p.z() < 0.75 || p.z() > head || !(windowAt(p.head<2>()).first > -0.05);
  });
  parts.walls = joined(
      parts.walls, points.slab(rectangle(-1, -1, 5, 5), head, [&](double x, double y) {
        const double behind = windowAt({x, y}).first;
        return behind > 0.01 && behind < depth;
      }));
  const PlanLoop loop = fitted(points, parts).boundary;
  EXPECT_EQ(loop.elements.size(), 4u);
  EXPECT_EQ(arcsOf(loop), 1u);
  EXPECT_LT(outlineError(loop, walls), 0.01);
}

TEST(WallShapes, AGentlyCurvedWallIsOneArc)
{
  for (const double radius : {60.0, 200.0}) {
    const double half = std::asin(6 / radius) * 180 / M_PI;
    const double y = 7 - std::sqrt(radius * radius - 36);
    const PlanLoop bowed{{segment({-6, 0}, {6, 0}), segment({6, 0}, {6, 7}),
                          arc({0, y}, radius, 90 - half, 90 + half),
                          segment({-6, 7}, {-6, 0})}};
    for (const double degrees : {0.0, 20.0})
      expectShape(placed(bowed, degrees, {0.01, 0.02}), 0.005, 0.01);
  }
}

TEST(WallShapes, ArcsTangentToWallsAreOneArcEach)
{
  for (const auto& shape : {stadium(4, 1.5), roundedRectangle(6, 4, 1)})
    for (const double degrees : {0.0, 33.0}) {
      SCOPED_TRACE(testing::Message() << shape.elements.size() << " at " << degrees);
      const PlanLoop truth = placed(shape, degrees, {0.017, 0.023});
      const PlanLoop loop = fitted(roomOf(truth, 2.5), 0.003).boundary;
      EXPECT_EQ(loop.elements.size(), truth.elements.size());
      EXPECT_EQ(arcsOf(loop), arcsOf(truth));
      EXPECT_LT(outlineError(loop, truth), 0.006);
      for (const auto& e : loop.elements)
        if (e.isArc()) {
          EXPECT_NEAR(e.radius, shape.elements[1].radius, 0.03);
        }
    }
}

TEST(WallShapes, AnSCurveIsTwoArcs)
{
  // The right wall of a room continues over two arcs of 2 m into another line, each
  // tangent to the next.
  const double a = 50 * M_PI / 180;
  const Vector2d middle(2 - 2 * std::cos(a), 2 * std::sin(a));
  const double x = 2 * middle.x();
  const double y = 2 * middle.y();
  const PlanLoop truth{{segment({-3, -1.5}, {0, -1.5}), segment({0, -1.5}, {0, 0}),
                        arc({2, 0}, 2, 180, 130), arc({x - 2, y}, 2, -50, 0),
                        segment({x, y}, {x, y + 1.2}),
                        segment({x, y + 1.2}, {-3, y + 1.2}),
                        segment({-3, y + 1.2}, {-3, -1.5})}};
  for (const double noise : {0.001, 0.01}) {
    SCOPED_TRACE(noise);
    const PlanLoop loop = fitted(roomOf(truth, 2.5), noise).boundary;
    EXPECT_EQ(loop.elements.size(), 7u);
    EXPECT_EQ(arcsOf(loop), 2u);
    EXPECT_LT(outlineError(loop, truth), 0.005 + noise / 2);
  }
}

TEST(WallShapes, AWallThatTurnsOverAShortArcIsNotCutIntoStraightPieces)
{
  for (const auto& [radius, turn] :
       {std::pair(1.1, 60.0), std::pair(1.5, 45.0), std::pair(1.5, 60.0)}) {
    SCOPED_TRACE(testing::Message() << radius << " m over " << turn);
    const double a = turn * M_PI / 180;
    const Vector2d centre(3, radius);
    const Vector2d end = centre + radius * Vector2d(std::sin(a), -std::cos(a));
    const Vector2d far = end + 2 * Vector2d(std::cos(a), std::sin(a));
    const PlanLoop truth =
        placed({{segment({0, 0}, {3, 0}), arc(centre, radius, -90, turn - 90),
                 segment(end, far), segment(far, {far.x(), 5}),
                 segment({far.x(), 5}, {0, 5}), segment({0, 5}, {0, 0})}},
               33, {0.017, 0.023});
    const PlanLoop loop = fitted(roomOf(truth, 2.5), 0.002).boundary;
    EXPECT_EQ(loop.elements.size(), truth.elements.size());
    EXPECT_EQ(arcsOf(loop), 1u);
    EXPECT_LT(outlineError(loop, truth), 0.006);
  }
}

TEST(WallShapes, ChamfersAndFlatAnglesStayStraight)
{
  for (const double noise : {0.002, 0.015}) {
    SCOPED_TRACE(noise);
    for (const double cut : {0.5, 0.9})
      expectShape(
          placed(polygon({{cut, 0}, {5 - cut, 0}, {5, cut}, {5, 4}, {0, 4}, {0, cut}}),
                 17, {0.02, 0.01}),
          noise, 0.004 + noise);
    // The upper wall is bent by six degrees.
    const PlanLoop bent = polygon({{0, 0}, {6, 0}, {6, 3}, {3, 3.315}, {0, 3}});
    const PlanLoop loop = fitted(roomOf(bent, 2.5), noise).boundary;
    EXPECT_EQ(loop.elements.size(), 5u);
    EXPECT_LT(outlineError(loop, bent), 0.005 + noise / 2);
    const PlanLoop straight = placed(rectangle(0, 0, 12, 3), 7, {0, 0});
    EXPECT_EQ(fitted(roomOf(straight, 2.5), noise).boundary.elements.size(), 4u);
  }
}

TEST(WallShapes, PilastersAndNichesHaveRightAngles)
{
  const PlanLoop in_wall = polygon({{0, 0},
                                    {1, 0},
                                    {1, 0.15},
                                    {1.4, 0.15},
                                    {1.4, 0},
                                    {2.5, 0},
                                    {2.5, -0.2},
                                    {2.9, -0.2},
                                    {2.9, 0},
                                    {5, 0},
                                    {5, 3},
                                    {0, 3}});
  const PlanLoop flat =
      polygon({{0, 0}, {2, 0}, {2, 0.1}, {2.5, 0.1}, {2.5, 0}, {5, 0}, {5, 3}, {0, 3}});
  for (const auto& [degrees, noise] :
       {std::pair(0.0, 0.003), std::pair(0.0, 0.01), std::pair(25.0, 0.003)}) {
    SCOPED_TRACE(testing::Message() << degrees << " noise " << noise);
    for (const PlanLoop& shape : {in_wall, flat})
      expectShape(placed(shape, degrees, {0.02, 0.013}), noise, 0.005 + noise);
  }
}

TEST(WallShapes, PartitionsHaveTwoFacesAndAnEnd)
{
  for (const double thickness : {0.08, 0.12, 0.2}) {
    SCOPED_TRACE(thickness);
    const double x = 2.5 + thickness;
    expectShape(polygon({{0.01, 0.01},
                         {5.01, 0.01},
                         {5.01, 4.01},
                         {x, 4.01},
                         {x, 1.51},
                         {2.5, 1.51},
                         {2.5, 4.01},
                         {0.01, 4.01}}),
                0.005, 0.01);
  }
}

TEST(WallShapes, ColumnsAreSquareOrRound)
{
  for (const double degrees : {0.0, 30.0}) {
    SCOPED_TRACE(degrees);
    PlanRoom truth = roomOf(rectangle(0.01, 0.01, 7.01, 5.01), 2.5);
    truth.columns = {
        reversed(circle({1.5, 1.5}, 0.2)), reversed(circle({3.3, 2.2}, 0.4)),
        reversed(placed(rectangle(-0.2, -0.2, 0.2, 0.2), degrees, {5, 1.3})),
        reversed(placed(rectangle(-0.3, -0.15, 0.3, 0.15), degrees, {5.2, 3.6}))};
    const PlanRoom room = fitted(truth, 0.003);
    EXPECT_LT(cornerError(room.boundary, truth.boundary), 0.002);
    EXPECT_NEAR(room.area(), truth.area(), 0.05);
    ASSERT_EQ(room.columns.size(), 4u);
    for (const PlanLoop& expected : truth.columns) {
      const PlanLoop* nearest = nullptr;
      for (const PlanLoop& column : room.columns)
        if (!nearest ||
            outlineError(column, expected) < outlineError(*nearest, expected))
          nearest = &column;
      EXPECT_EQ(nearest->elements.size(), expected.elements.size());
      EXPECT_EQ(arcsOf(*nearest), arcsOf(expected));
      EXPECT_LT(outlineError(*nearest, expected), 0.01);
      EXPECT_LT(nearest->area(), 0);
    }
  }
}

TEST(WallShapes, AColumnIsOneThoughFewRaysMeetThreeQuartersOfIt)
{
  for (const PlanLoop& column :
       {circle({3, 2}, 0.25), rectangle(2.75, 1.75, 3.25, 2.25)}) {
    PlanRoom truth = roomOf(rectangle(0.01, 0.01, 6.01, 4.01), 2.5);
    truth.columns = {reversed(column)};
    RoomPoints points(0.05, 0.003);
    const RoomParts parts = points.room(truth);
    RoomPoints dense(0.02);
    dense.room(truth);
    const auto full = dense.cloud();
    const auto scan = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
    int met = 0;
    for (const auto& p : *full)
      if (std::hypot(p.x - 3, p.y - 2) > 0.4 || p.z < 0.1f || p.z > 2.4f ||
          p.x + p.y < 4.75f || ++met % 8 == 0)
        scan->push_back(p);
    Fitting fitting;
    setEvidence(points, evidenceOf(points, parts), fitting);
    fitting.setRawCloud(scan);
    Floorplan plan;
    ASSERT_TRUE(fitting.segment(plan)) << fitting.getErrorMessage();
    ASSERT_EQ(plan.rooms[0].columns.size(), 1u);
    EXPECT_LT(outlineError(plan.rooms[0].columns[0], truth.columns[0]), 0.01);
  }
}

TEST(WallShapes, AColumnIsOneThoughASideOfItWasNotSeen)
{
  PlanRoom truth = roomOf(rectangle(0.01, 0.01, 6.01, 4.01), 2.5);
  truth.columns = {reversed(rectangle(2.8, 1.8, 3.2, 2.2))};
  RoomPoints points(0.05, 0.003);
  const PlanRoom room = fitted(points, points.room(truth, [](const Eigen::Vector3d& p) {
    return std::abs(p.x() - 3.2) > 0.02 || std::abs(p.y() - 2) > 0.22;
  }));
  ASSERT_EQ(room.columns.size(), 1u);
  EXPECT_LT(outlineError(room.columns[0], truth.columns[0]), 0.05);
}

TEST(WallShapes, ColumnsBelowABeamAreFound)
{
  for (const double degrees : {0.0, 21.0}) {
    SCOPED_TRACE(degrees);
    const Eigen::Vector2d at(0.02, 0.013);
    PlanRoom truth = roomOf(placed(rectangle(0, 0, 12, 6), degrees, at), 3.4);
    truth.details = {detailOf(placed(rectangle(0, 2.8, 12, 3.2), degrees, at), 2.9)};
    truth.columns = {reversed(placed(rectangle(3, 2.8, 3.4, 3.2), degrees, at)),
                     reversed(placed(circle({7, 3}, 0.22), degrees, at))};
    const PlanRoom room = fitted(truth, 0.005);
    EXPECT_EQ(room.boundary.elements.size(), 4u);
    ASSERT_EQ(room.columns.size(), 2u);
    const bool is_round = arcsOf(room.columns[0]) > 0; // the first
    EXPECT_LT(outlineError(room.columns[is_round ? 1 : 0], truth.columns[0]), 0.01);
    EXPECT_LT(outlineError(room.columns[is_round ? 0 : 1], truth.columns[1]), 0.04);
  }
}

TEST(WallShapes, AColumnBeforeAWallIsOne)
{
  for (const double gap : {0.3, 0.6}) {
    SCOPED_TRACE(gap);
    PlanRoom truth = roomOf(rectangle(0.01, 0.01, 6.01, 4.01), 2.5);
    truth.columns = {reversed(circle({3, 0.01 + gap + 0.15}, 0.15))};
    const PlanRoom room = fitted(truth, 0.003);
    EXPECT_EQ(room.boundary.elements.size(), 4u);
    ASSERT_EQ(room.columns.size(), 1u);
    EXPECT_LT(outlineError(room.columns[0], truth.columns[0]), 0.01);
  }
}

} // namespace
