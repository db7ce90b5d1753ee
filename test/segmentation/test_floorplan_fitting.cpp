// SPDX-License-Identifier: BSD-3-Clause
#include "room_points.h"

#include <pcl/sedr_segmentation/floorplan_fitting.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;
using Eigen::Vector2d;

/** A room's points as the stages before find them: what a wall's column holds is not
 * the ceiling's. */
RoomEvidence
evidenceOf(const RoomPoints& points, const RoomParts& parts)
{
  const CellGrid grid(0.05);
  const CellSet walls(grid, points.view(), parts.walls);
  const auto besideWalls = [&](const std::vector<int>& slab) {
    std::vector<int> kept;
    for (const int i : slab)
      if (!walls.contains(grid.at(points[i].x(), points[i].y())))
        kept.push_back(i);
    return kept;
  };
  RoomEvidence evidence;
  evidence.around = points.all();
  evidence.ceiling = besideWalls(parts.ceiling);
  evidence.details = parts.details;
  evidence.floor = parts.floor;
  evidence.walls = parts.walls;
  return evidence;
}

PlanRoom
fitted(const RoomPoints& points, const RoomParts& parts)
{
  std::string problem = "none yet";
  const PlanRoom room = fitRoom(points.view(), evidenceOf(points, parts), {}, problem);
  EXPECT_EQ(problem, "");
  return room;
}

/** The largest distance of an end of an element of `truth` from the nearest of `loop`.
 */
double
cornerError(const PlanLoop& loop, const PlanLoop& truth)
{
  double worst = 0;
  for (const auto& e : truth.elements) {
    double least = 1e9;
    for (const auto& f : loop.elements)
      least = std::min(least, (f.start - e.start).norm());
    worst = std::max(worst, least);
  }
  return worst;
}

/** The largest distance of the outline of `truth` from `loop`. */
double
outlineError(const PlanLoop& loop, const PlanLoop& truth)
{
  double worst = 0;
  for (const auto& e : truth.elements)
    for (double share = 0.05; share < 1; share += 0.1)
      worst = std::max(worst, loop.distance(e.pointAt(share * e.length())));
  return worst;
}

TEST(FitRoom, ABoxIsExactToTheMillimetre)
{
  for (const double degrees : {0.0, 28.0}) {
    const PlanLoop truth = placed(rectangle(0, 0, 4, 3), degrees, {0.013, 0.017});
    RoomPoints points;
    const RoomParts parts = points.room(truth, -0.1, 2.4);
    const PlanRoom room = fitted(points, parts);
    ASSERT_EQ(room.boundary.elements.size(), 4u) << degrees;
    EXPECT_LT(cornerError(room.boundary, truth), 0.001) << degrees;
    EXPECT_NEAR(room.floor.heightAt({1, 1}), -0.1, 1e-5);
    EXPECT_NEAR(room.ceiling.heightAt({1, 1}), 2.4, 1e-5);
    EXPECT_GT(room.area(), 0);
    EXPECT_TRUE(room.columns.empty());
    EXPECT_TRUE(room.details.empty());
    for (const auto& e : room.boundary.elements) {
      EXPECT_GT(e.inliers, 500u);
      EXPECT_LT(e.residual, 0.001);
    }
  }
}

TEST(FitRoom, NoiseOfTwoCentimetresCostsMillimetres)
{
  const PlanLoop truth = placed(rectangle(0, 0, 5, 4), 12, {0.013, 0.017});
  RoomPoints points(0.05, 0.02);
  const RoomParts parts = points.room(truth, 0, 2.5);
  const PlanRoom room = fitted(points, parts);
  ASSERT_EQ(room.boundary.elements.size(), 4u);
  EXPECT_LT(cornerError(room.boundary, truth), 0.008);
  EXPECT_NEAR(room.ceiling.heightAt({2, 2}), 2.5, 0.002);
  for (const auto& e : room.boundary.elements)
    EXPECT_NEAR(e.residual, 0.02, 0.005);
}

TEST(FitRoom, FurnitureDoesNotMoveTheWallsBehindIt)
{
  const PlanLoop truth = rectangle(0.01, 0.01, 4.01, 3.01);
  RoomPoints points(0.05, 0.005);
  RoomParts parts = points.room(truth, 0, 2.5);
  // A cupboard 5 cm before the wall up to 1.2 m, which the growing took for wall, too.
  parts.walls =
      joined(parts.walls, points.wall(segment({0.5, 0.06}, {3.5, 0.06}), 0, 1.2));
  EXPECT_LT(cornerError(fitted(points, parts).boundary, truth), 0.004);
}

TEST(FitRoom, CurvedWallsAreArcs)
{
  const PlanLoop truth = placed(bittenRectangle(6, 4, 1.3), 0, {0.01, 0.01});
  RoomPoints points(0.05, 0.003);
  const RoomParts parts = points.room(truth, 0, 2.5);
  const PlanRoom room = fitted(points, parts);
  EXPECT_EQ(std::count_if(room.boundary.elements.begin(), room.boundary.elements.end(),
                          [](const auto& e) { return e.isArc(); }),
            1);
  EXPECT_LT(outlineError(room.boundary, truth), 0.008);
}

TEST(FitRoom, ColumnsAreLoopsThatRunClockwise)
{
  PlanRoom truth = roomOf(rectangle(0.01, 0.01, 6.01, 5.01), 2.5);
  truth.columns = {reversed(circle({2, 2}, 0.3)),
                   reversed(placed(rectangle(-0.25, -0.25, 0.25, 0.25), 20, {4, 3}))};
  RoomPoints points(0.05, 0.002);
  const RoomParts parts = points.room(truth);
  const PlanRoom room = fitted(points, parts);
  ASSERT_EQ(room.columns.size(), 2u);
  for (const auto& column : room.columns)
    EXPECT_LT(column.area(), 0);
  ASSERT_EQ(room.columns[0].elements.size(), 1u);
  EXPECT_TRUE(room.columns[0].elements[0].isArc());
  EXPECT_NEAR(room.columns[0].elements[0].radius, 0.3, 0.01);
  EXPECT_NEAR((room.columns[0].elements[0].centre - Vector2d(2, 2)).norm(), 0, 0.01);
  ASSERT_EQ(room.columns[1].elements.size(), 4u);
  EXPECT_LT(cornerError(room.columns[1], truth.columns[1]), 0.02);
  EXPECT_LT(cornerError(room.boundary, truth.boundary), 0.002);
  EXPECT_NEAR(room.area(), truth.area(), 0.05);
}

TEST(FitRoom, ASoffitsEdgesLieOnTheWallsWhereItMeetsThem)
{
  PlanRoom truth = roomOf(rectangle(0.01, 0.01, 5.01, 4.01), 2.5);
  truth.details = {detailOf(rectangle(3.91, 0.01, 5.01, 4.01), 2.2)};
  RoomPoints points(0.05, 0.002);
  const RoomParts parts = points.room(truth);
  const PlanRoom room = fitted(points, parts);
  ASSERT_EQ(room.details.size(), 1u);
  const PlanDetail& soffit = room.details[0];
  EXPECT_NEAR(soffit.slab.heightAt({4, 2}), 2.2, 0.002);
  EXPECT_TRUE(soffit.holes.empty());
  ASSERT_EQ(soffit.boundary.elements.size(), 4u);
  EXPECT_GT(soffit.boundary.area(), 0);
  for (const auto& e : soffit.boundary.elements) {
    const Vector2d middle = e.pointAt(e.length() / 2);
    if (std::abs(middle.x() - 3.91) < 0.1) {
      EXPECT_NEAR(middle.x(), 3.91, 0.01) << "the riser";
    }
    else {
      EXPECT_NEAR(room.boundary.distance(middle), 0, 1e-6) << "a wall";
    }
  }
  EXPECT_LT(cornerError(room.boundary, truth.boundary), 0.003);
}

TEST(FitRoom, ASoffitAllAroundHasAHole)
{
  PlanRoom truth = roomOf(rectangle(0.01, 0.01, 6.01, 5.01), 2.6);
  truth.details = {detailOf(truth.boundary, 2.3)};
  truth.details[0].holes = {reversed(rectangle(0.81, 0.81, 5.21, 4.21))};
  RoomPoints points(0.05, 0.002);
  const RoomParts parts = points.room(truth);
  const PlanRoom room = fitted(points, parts);
  ASSERT_EQ(room.details.size(), 1u);
  ASSERT_EQ(room.details[0].holes.size(), 1u);
  EXPECT_LT(room.details[0].holes[0].area(), 0);
  EXPECT_LT(cornerError(room.details[0].holes[0], truth.details[0].holes[0]), 0.03);
  EXPECT_NEAR(room.ceilingAt({3, 2}), 2.6, 0.002);
  EXPECT_NEAR(room.ceilingAt({0.3, 2}), 2.3, 0.002);
}

TEST(FitRoom, ARecessIsADetailAboveTheCeiling)
{
  PlanRoom truth = roomOf(rectangle(0.01, 0.01, 5.01, 4.01), 2.5);
  truth.details = {detailOf(rectangle(1.51, 1.01, 3.51, 2.51), 2.75)};
  RoomPoints points(0.05, 0.002);
  const RoomParts parts = points.room(truth);
  const PlanRoom room = fitted(points, parts);
  ASSERT_EQ(room.details.size(), 1u);
  EXPECT_NEAR(room.details[0].slab.heightAt({2, 2}), 2.75, 0.002);
  EXPECT_LT(cornerError(room.details[0].boundary, truth.details[0].boundary), 0.03);
  EXPECT_NEAR(room.details[0].boundary.area(), 3, 0.05);
}

/** The plan of a room of which nothing was seen where `isHidden` says so. */
PlanRoom
fittedWithout(const RoomPoints& points,
              const RoomParts& parts,
              const RoomPoints::InSpace& isHidden)
{
  RoomEvidence evidence = evidenceOf(points, parts);
  for (auto* indices : {&evidence.around, &evidence.ceiling, &evidence.details,
                        &evidence.floor, &evidence.walls})
    indices->erase(
        std::remove_if(indices->begin(), indices->end(),
                       [&](int i) { return isHidden(points[i].cast<double>()); }),
        indices->end());
  std::string problem;
  return fitRoom(points.view(), evidence, {}, problem);
}

/** 6 m x 4 m, with a beam of 0.4 m across. */
PlanRoom
roomWithABeam()
{
  PlanRoom room = roomOf(rectangle(0.01, 0.01, 6.01, 4.01), 2.7);
  room.details = {detailOf(rectangle(2.81, 0.01, 3.21, 4.01), 2.4)};
  return room;
}

TEST(FitRoom, ABeamWhoseEndWasNotSeenGoesOnToTheWall)
{
  const PlanRoom truth = roomWithABeam();
  RoomPoints points(0.05, 0.002);
  const RoomParts parts = points.room(truth);
  // A shadow that reaches farther on one side.
  const PlanRoom room = fittedWithout(points, parts, [](const Eigen::Vector3d& p) {
    return p.z() > 2.3 && p.x() > 2.6 && p.x() < 3.5 && p.y() > 4.4 - 0.4 * p.x();
  });
  ASSERT_EQ(room.details.size(), 1u);
  EXPECT_EQ(room.details[0].boundary.elements.size(), 4u);
  EXPECT_LT(cornerError(room.details[0].boundary, truth.details[0].boundary), 0.03);
}

TEST(FitRoom, PiecesOfABeamAreOneWhereNothingWasSeenBetween)
{
  const PlanRoom truth = roomWithABeam();
  RoomPoints points(0.05, 0.002);
  const RoomParts parts = points.room(truth);
  const PlanRoom room = fittedWithout(points, parts, [](const Eigen::Vector3d& p) {
    return p.z() > 2.3 && p.x() > 2.6 && p.x() < 3.4 && p.y() > 1.6 && p.y() < 2.2;
  });
  ASSERT_EQ(room.details.size(), 1u);
  EXPECT_LT(cornerError(room.details[0].boundary, truth.details[0].boundary), 0.03);
}

TEST(FitRoom, BeamsOnOneLineAreTwoWhereTheCeilingIsSeenBetween)
{
  PlanRoom truth = roomWithABeam();
  truth.details = {detailOf(rectangle(2.81, 0.01, 3.21, 1.51), 2.4),
                   detailOf(rectangle(2.81, 2.31, 3.21, 4.01), 2.4)};
  RoomPoints points(0.05, 0.002);
  const RoomParts parts = points.room(truth);
  EXPECT_EQ(fitted(points, parts).details.size(), 2u);
}

TEST(FitRoom, AShelfBelowTheCeilingWithoutRisersIsNoDetail)
{
  PlanRoom truth = roomOf(rectangle(0.01, 0.01, 5.01, 4.01), 2.5);
  RoomPoints points(0.05, 0.002);
  RoomParts parts = points.room(truth);
  const PlanLoop shelf = rectangle(3.91, 0.01, 5.01, 4.01);
  // The ceiling above it was not seen.
  parts.ceiling.erase(std::remove_if(parts.ceiling.begin(), parts.ceiling.end(),
                                     [&](int i) { return points[i].x() > 3.91f; }),
                      parts.ceiling.end());
  parts.details = points.slab(shelf, 1.9);
  EXPECT_TRUE(fitted(points, parts).details.empty());
}

/** Two rooms of different heights with a partition of 10 cm, their points numbered. */
struct TwoRooms {
  RoomPoints points{0.05, 0.003};
  PlanEvidence evidence;
  PlanLoop left = rectangle(0.01, 0.01, 4.01, 3.01);
  PlanLoop right = rectangle(4.11, 0.01, 7.11, 3.01);

  TwoRooms()
  {
    add(left, 2.5, 7);
    add(right, 2.8, 3);
    evidence.all = points.all();
  }

private:
  void add(const PlanLoop& loop, double height, std::uint32_t number)
  {
    const RoomParts parts = points.room(loop, 0, height);
    evidence.room.resize(points.size(), number);
    const RoomEvidence own = evidenceOf(points, parts);
    evidence.ceiling = joined(evidence.ceiling, own.ceiling);
    evidence.floor = joined(evidence.floor, own.floor);
    evidence.walls = joined(evidence.walls, own.walls);
  }
};

TEST(FitPlan, FitsEachRoomToItsOwnFaceOfThePartition)
{
  TwoRooms scene;
  // What is no ceiling carries no room: it goes to the nearest.
  for (const auto* part : {&scene.evidence.floor, &scene.evidence.walls})
    for (const int i : *part)
      scene.evidence.room[static_cast<std::size_t>(i)] = 0;
  for (const bool walls_known : {true, false}) {
    if (!walls_known)
      scene.evidence.walls.clear();
    std::string problem;
    std::vector<std::string> warnings;
    const Floorplan plan =
        fitPlan(scene.points.view(), scene.evidence, {}, problem, warnings);
    EXPECT_EQ(problem, "");
    EXPECT_TRUE(warnings.empty());
    ASSERT_EQ(plan.rooms.size(), 2u);
    EXPECT_EQ(plan.rooms[0].id, 3u) << "by increasing number";
    EXPECT_EQ(plan.rooms[1].id, 7u);
    EXPECT_LT(cornerError(plan.rooms[0].boundary, scene.right), 0.003);
    EXPECT_LT(cornerError(plan.rooms[1].boundary, scene.left), 0.003);
    EXPECT_NEAR(plan.rooms[0].ceiling.heightAt({5, 1}), 2.8, 0.001);
    EXPECT_NEAR(plan.rooms[1].ceiling.heightAt({1, 1}), 2.5, 0.001);
  }
}

TEST(FitPlan, AWallSeenFromNextDoorIsNoNiche)
{
  // The left room's face of the partition is hidden over half a metre, and a bit of
  // ceiling labelled as its own lies in the partition: behind is the other room's face.
  TwoRooms scene;
  const auto isHidden = [&](int i) {
    const Eigen::Vector3f& p = scene.points[i];
    return p.x() > 3.9F && p.x() < 4.05F && p.y() > 1 && p.y() < 1.5F;
  };
  auto& walls = scene.evidence.walls;
  walls.erase(std::remove_if(walls.begin(), walls.end(), isHidden), walls.end());
  for (double y = 1.025; y < 1.5; y += 0.05) {
    scene.evidence.ceiling.push_back(scene.points.point(4.05, y, 2.5));
    scene.evidence.room.push_back(7);
  }
  scene.evidence.all = scene.points.all();
  std::string problem;
  std::vector<std::string> warnings;
  const Floorplan plan =
      fitPlan(scene.points.view(), scene.evidence, {}, problem, warnings);
  ASSERT_EQ(plan.rooms.size(), 2u);
  EXPECT_EQ(plan.rooms[1].boundary.elements.size(), 4u);
  EXPECT_LT(cornerError(plan.rooms[1].boundary, scene.left), 0.003);
  EXPECT_LT(cornerError(plan.rooms[0].boundary, scene.right), 0.003);
}

TEST(FitPlan, ARoomThatCannotBeFittedIsAWarningWhileOthersCan)
{
  TwoRooms scene;
  auto& floor = scene.evidence.floor;
  floor.erase(std::remove_if(floor.begin(), floor.end(),
                             [&](int i) { return scene.points[i].x() > 4; }),
              floor.end());
  std::string problem;
  std::vector<std::string> warnings;
  const Floorplan plan =
      fitPlan(scene.points.view(), scene.evidence, {}, problem, warnings);
  EXPECT_EQ(problem, "");
  ASSERT_EQ(plan.rooms.size(), 1u);
  EXPECT_EQ(plan.rooms[0].id, 7u);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("room 3"), std::string::npos) << warnings[0];
  EXPECT_NE(warnings[0].find("0 floor points"), std::string::npos) << warnings[0];
}

TEST(FitPlan, WithoutAnyRoomThereIsAProblem)
{
  TwoRooms scene;
  scene.evidence.floor.clear();
  std::string problem;
  std::vector<std::string> warnings;
  EXPECT_TRUE(fitPlan(scene.points.view(), scene.evidence, {}, problem, warnings)
                  .rooms.empty());
  EXPECT_NE(problem, "");
  std::fill(scene.evidence.room.begin(), scene.evidence.room.end(), 0u);
  EXPECT_TRUE(fitPlan(scene.points.view(), scene.evidence, {}, problem, warnings)
                  .rooms.empty());
  EXPECT_NE(problem, "");
}

using Fitting = pcl::FloorplanFitting<pcl::PointXYZ>;

TEST(FloorplanFitting, FitsTheRoomsThatAreSetOrOneForAll)
{
  const TwoRooms scene;
  Fitting fitting;
  fitting.setInputCloud(scene.points.cloud());
  fitting.setCeilingIndices(shared(scene.evidence.ceiling));
  fitting.setFloorIndices(shared(scene.evidence.floor));
  fitting.setWallIndices(shared(scene.evidence.walls));
  fitting.setRooms(scene.evidence.room);
  Floorplan plan;
  plan.rooms.resize(5);
  ASSERT_TRUE(fitting.segment(plan)) << fitting.getErrorMessage();
  ASSERT_EQ(plan.rooms.size(), 2u);
  EXPECT_LT(cornerError(plan.rooms[1].boundary, scene.left), 0.003);

  fitting.setRooms({});
  RoomPoints points;
  const RoomParts parts = points.room(scene.left, 0, 2.5);
  fitting.setInputCloud(points.cloud());
  fitting.setCeilingIndices(shared(parts.ceiling));
  fitting.setFloorIndices(shared(parts.floor));
  fitting.setWallIndices(nullptr);
  ASSERT_TRUE(fitting.segment(plan)) << fitting.getErrorMessage();
  ASSERT_EQ(plan.rooms.size(), 1u);
  EXPECT_EQ(plan.rooms[0].id, 1u);
  EXPECT_LT(cornerError(plan.rooms[0].boundary, scene.left), 0.001);
}

/** A fitting to thinned points that are 4 mm off the room of the raw cloud. */
class OffRaw : public ::testing::Test {
protected:
  OffRaw()
  {
    RoomPoints thinned;
    const RoomParts parts = thinned.room(rectangle(0.004, 0.004, 4.004, 3.004), 0, 2.5);
    fitting_.setInputCloud(thinned.cloud());
    fitting_.setCeilingIndices(shared(parts.ceiling));
    fitting_.setFloorIndices(shared(parts.floor));
    fitting_.setWallIndices(shared(parts.walls));
    RoomPoints dense(0.02);
    dense.room(room_, 0, 2.5);
    scan_ = dense.cloud();
  }

  double errorOfPlan()
  {
    Floorplan plan;
    EXPECT_TRUE(fitting_.segment(plan)) << fitting_.getErrorMessage();
    return plan.rooms.size() == 1 ? cornerError(plan.rooms[0].boundary, room_) : 1;
  }

  PlanLoop room_ = rectangle(0, 0, 4, 3);
  pcl::PointCloud<pcl::PointXYZ>::Ptr scan_;
  Fitting fitting_;
};

TEST_F(OffRaw, IsMetByThePlan)
{
  EXPECT_GT(errorOfPlan(), 0.003);
  fitting_.setRawCloud<pcl::PointXYZ>(scan_);
  EXPECT_LT(errorOfPlan(), 0.0005);
  fitting_.setRawCloud<pcl::PointXYZ>(nullptr);
  EXPECT_GT(errorOfPlan(), 0.003);
}

TEST_F(OffRaw, IsSeenAsItIsWhenThePlanIsFitted)
{
  const auto filled_later = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  fitting_.setRawCloud<pcl::PointXYZ>(filled_later);
  *filled_later = *scan_;
  EXPECT_LT(errorOfPlan(), 0.0005);
}

TEST_F(OffRaw, CountsByItsIndices)
{
  fitting_.setRawCloud<pcl::PointXYZ>(scan_, shared({}));
  EXPECT_GT(errorOfPlan(), 0.003) << "none of them";
  Floorplan plan;
  plan.rooms.resize(1);
  fitting_.setRawCloud<pcl::PointXYZ>(scan_, shared({-1}));
  EXPECT_FALSE(fitting_.segment(plan));
  EXPECT_TRUE(plan.rooms.empty());
  EXPECT_NE(fitting_.getErrorMessage().find("raw cloud"), std::string::npos);
}

TEST(FloorplanFitting, TellsTheBoundaryPointsOfWallsAndColumns)
{
  PlanRoom truth = roomOf(rectangle(0.01, 0.01, 6.01, 5.01), 2.5);
  truth.columns = {reversed(circle({2, 2}, 0.3))};
  RoomPoints points;
  const RoomParts parts = points.room(truth);
  const RoomEvidence evidence = evidenceOf(points, parts);
  Fitting fitting;
  fitting.setInputCloud(points.cloud());
  fitting.setCeilingIndices(shared(evidence.ceiling));
  fitting.setFloorIndices(shared(evidence.floor));
  fitting.setWallIndices(shared(evidence.walls));
  Floorplan plan;
  ASSERT_TRUE(fitting.segment(plan)) << fitting.getErrorMessage();
  const std::vector<FittedBoundary>& boundaries = fitting.getBoundaries();
  ASSERT_EQ(boundaries.size(), 2u);
  EXPECT_EQ(boundaries[0].label, StructureLabel::Wall);
  EXPECT_EQ(boundaries[1].label, StructureLabel::Column);
  const PlanLoop* loops[] = {&truth.boundary, &truth.columns[0]};
  for (std::size_t b = 0; b < 2; ++b) {
    EXPECT_EQ(boundaries[b].room, 1u);
    // One a cell edge, and all but those at corners on the wall itself.
    const double edges = loops[b]->length() / 0.05;
    EXPECT_NEAR(static_cast<double>(boundaries[b].samples.size()), edges, 0.4 * edges);
    std::size_t supported = 0;
    for (const auto& sample : boundaries[b].samples)
      if (sample.isSupported()) {
        ++supported;
        EXPECT_LT(loops[b]->distance(sample.position), 0.02);
      }
    EXPECT_GT(10 * supported, 8 * boundaries[b].samples.size());
  }
  fitting.setGridSize(0);
  EXPECT_FALSE(fitting.segment(plan));
  EXPECT_TRUE(fitting.getBoundaries().empty());
}

TEST(FloorplanFitting, TakesTheRoomsOfThePointType)
{
  const TwoRooms scene;
  const auto cloud = scene.points.cloud<pcl::PointStructure>();
  for (std::size_t i = 0; i < cloud->size(); ++i)
    (*cloud)[i].room = scene.evidence.room[i];
  pcl::FloorplanFitting<pcl::PointStructure> fitting;
  fitting.setInputCloud(cloud);
  fitting.setCeilingIndices(shared(scene.evidence.ceiling));
  fitting.setFloorIndices(shared(scene.evidence.floor));
  Floorplan plan;
  ASSERT_TRUE(fitting.segment(plan)) << fitting.getErrorMessage();
  EXPECT_EQ(plan.rooms.size(), 2u);
}

TEST(FloorplanFitting, RoomsOfAnotherNumberOfPointsAreRefusedWithBothNumbers)
{
  const TwoRooms scene;
  Fitting fitting;
  fitting.setInputCloud(scene.points.cloud());
  fitting.setCeilingIndices(shared(scene.evidence.ceiling));
  fitting.setFloorIndices(shared(scene.evidence.floor));
  fitting.setRooms({1, 2, 3});
  Floorplan plan;
  EXPECT_FALSE(fitting.segment(plan));
  EXPECT_NE(fitting.getErrorMessage().find("of 3"), std::string::npos);
  EXPECT_NE(fitting.getErrorMessage().find(std::to_string(scene.points.size())),
            std::string::npos)
      << fitting.getErrorMessage();
  EXPECT_TRUE(plan.rooms.empty());
}

TEST(FloorplanFitting, ARadiusBeyondTheLimitsIsNoArc)
{
  const PlanLoop truth = placed(bittenRectangle(6, 4, 1.3), 0, {0.01, 0.01});
  RoomPoints points;
  const RoomParts parts = points.room(truth, 0, 2.5);
  Fitting fitting;
  fitting.setInputCloud(points.cloud());
  fitting.setCeilingIndices(shared(evidenceOf(points, parts).ceiling));
  fitting.setFloorIndices(shared(parts.floor));
  const auto arcs = [&] {
    Floorplan plan;
    EXPECT_TRUE(fitting.segment(plan)) << fitting.getErrorMessage();
    std::size_t count = 0;
    for (const auto& e : plan.rooms.at(0).boundary.elements)
      count += e.isArc() ? 1 : 0;
    return count;
  };
  EXPECT_EQ(arcs(), 1u);
  fitting.setRadiusLimits(0.15, 1.0);
  EXPECT_EQ(arcs(), 0u);
}

} // namespace
