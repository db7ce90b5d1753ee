// SPDX-License-Identifier: BSD-3-Clause
#include "room_evidence.h"

#include <array>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;
using Eigen::Vector2d;

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

TEST(FitRoom, AFloorWithAStepOfATenthOfAMetreIsNotTilted)
{
  PlanRoom truth = roomOf(rectangle(0.01, 0.01, 8.01, 5.01), 2.5);
  truth.floor_details = {detailOf(rectangle(4.5, 0.01, 8.01, 5.01), 0.1)};
  const PlanRoom room = fitted(truth, 0.005);
  EXPECT_NEAR(room.floor.heightAt({1, 1}), 0, 0.002);
  EXPECT_NEAR(room.floor.heightAt({7, 1}), 0, 0.002);
  ASSERT_EQ(room.floor_details.size(), 1u);
  EXPECT_NEAR(room.floor_details[0].slab.heightAt({6, 2}), 0.1, 0.002);
  EXPECT_LT(
      cornerError(room.floor_details[0].boundary, truth.floor_details[0].boundary),
      0.006);
}

TEST(FitRoom, FurnitureDoesNotMoveTheWallsBehindIt)
{
  const PlanLoop truth = rectangle(0.01, 0.01, 4.01, 3.01);
  RoomPoints points(0.05, 0.005);
  RoomParts parts = points.room(truth, 0, 2.5);
  // A cupboard 5 cm in front of the wall up to 1.2 m, also labelled wall.
  parts.walls =
      joined(parts.walls, points.wall(segment({0.5, 0.06}, {3.5, 0.06}), 0, 1.2));
  EXPECT_LT(cornerError(fitted(points, parts).boundary, truth), 0.004);
}

/** Returns how deep a room of 6 m is that ends 3.5 m from one wall at a face up to a
 * height, with 50 cm of its ceiling behind that which no stage has labelled.
 * @param interrupted for how many metres behind the face no ceiling was seen */
double
depthBefore(double top, double interrupted)
{
  const PlanRoom truth = roomOf(rectangle(0.01, 0.01, 6.01, 4.01), 2.5);
  RoomPoints points;
  const RoomParts parts = points.room(
      truth, [&](const Eigen::Vector3d& p) { return p.y() < 3.5 || p.z() > top; },
      [&](double, double y) { return y < 3.5 || y > 3.5 + interrupted; },
      [](double, double y) { return y < 3.5; });
  RoomParts labelled = parts;
  labelled.ceiling.clear();
  for (const int i : parts.ceiling)
    if (points[i].y() < 3.5F)
      labelled.ceiling.push_back(i);
  labelled.walls =
      joined(parts.walls, points.wall(segment({6.01, 3.5}, {0.01, 3.5}), 0, top));
  const PlanRoom room = fitted(points, labelled);
  double depth = 0;
  for (const auto& e : room.boundary.elements)
    depth = std::max(depth, e.start.y() - 0.01);
  return depth;
}

TEST(FitRoom, ACeilingThatGoesOnIsInterruptedByAWallAndNotByACupboard)
{
  EXPECT_NEAR(depthBefore(2.3, 0), 4, 0.06) << "above a cupboard";
  EXPECT_NEAR(depthBefore(2.5, 0.1), 3.49, 0.01) << "behind a wall";
}

TEST(FitRoom, ASoffitsEdgesLieOnTheWallsWhereItMeetsThem)
{
  PlanRoom truth = roomOf(rectangle(0.01, 0.01, 5.01, 4.01), 2.5);
  truth.details = {detailOf(rectangle(3.91, 0.01, 5.01, 4.01), 2.2)};
  const PlanRoom room = fitted(truth, 0.002);
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
  truth.details[0].holes = {reversed(rectangle(0.61, 0.61, 5.41, 4.41))};
  const PlanRoom room = fitted(truth, 0.002);
  ASSERT_EQ(room.details.size(), 1u);
  ASSERT_EQ(room.details[0].holes.size(), 1u);
  EXPECT_LT(room.details[0].holes[0].area(), 0);
  EXPECT_LT(cornerError(room.details[0].holes[0], truth.details[0].holes[0]), 0.003);
  EXPECT_LT(cornerError(room.details[0].boundary, truth.boundary), 0.003);
  EXPECT_NEAR(room.ceilingAt({3, 2}), 2.6, 0.002);
  EXPECT_NEAR(room.ceilingAt({0.3, 2}), 2.3, 0.002);
}

/** 8 m x 6 m, turned, with six coffers 60 cm apart, each of its own depth. */
PlanRoom
cofferedRoom()
{
  const auto turned = [](double x0, double y0, double x1, double y1) {
    return placed(rectangle(x0, y0, x1, y1), 14, {0.013, 0.017});
  };
  PlanRoom room = roomOf(turned(0, 0, 7.8, 5.8), 3);
  for (const auto& [x, y, depth] : std::vector<std::array<double, 3>>{{0.6, 0.6, 0.15},
                                                                      {3, 0.6, 0.2},
                                                                      {5.4, 0.6, 0.25},
                                                                      {0.6, 3.2, 0.3},
                                                                      {3, 3.2, 0.35},
                                                                      {5.4, 3.2, 0.12}})
    room.details.push_back(detailOf(turned(x, y, x + 1.8, y + 2), 3 + depth));
  return room;
}

TEST(FitRoom, TheRisersOfACofferAreItsOwnWhateverHeightsOthersHave)
{
  for (const double noise : {0.002, 0.01}) {
    const PlanRoom truth = cofferedRoom();
    const PlanRoom room = fitted(truth, noise);
    ASSERT_EQ(room.details.size(), truth.details.size());
    for (const PlanDetail& coffer : truth.details) {
      double least = 1e9;
      for (const PlanDetail& d : room.details)
        least = std::min(least, cornerError(d.boundary, coffer.boundary));
      EXPECT_LT(least, 0.02) << coffer.slab.heightAt({3, 3}) << ", noise " << noise;
    }
  }
}

/** Returns the plan of a room without the points for which `isHidden` is true. */
PlanRoom
fittedWithout(const RoomPoints& points,
              const RoomParts& parts,
              const RoomPoints::InSpace& isHidden)
{
  PlanEvidence evidence = evidenceOf(points, parts);
  for (auto* indices : {&evidence.all, &evidence.ceiling, &evidence.details,
                        &evidence.floor, &evidence.walls})
    indices->erase(
        std::remove_if(indices->begin(), indices->end(),
                       [&](int i) { return isHidden(points[i].cast<double>()); }),
        indices->end());
  return fitted(points, evidence);
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
  // A shadow that is longer on one side.
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
  // The ceiling above it was not scanned.
  parts.ceiling.erase(std::remove_if(parts.ceiling.begin(), parts.ceiling.end(),
                                     [&](int i) { return points[i].x() > 3.91f; }),
                      parts.ceiling.end());
  parts.details = points.slab(shelf, 1.9);
  EXPECT_TRUE(fitted(points, parts).details.empty());
}

TEST(FitRoom, ADuctFromWallToWallIsNoDetailABeamIs)
{
  const PlanLoop strip = rectangle(2.01, 0.01, 2.41, 4.01);
  for (const double gap : {0.12, 0.25, 0.0}) {
    PlanRoom truth = roomOf(rectangle(0.01, 0.01, 5.01, 4.01), 2.8);
    truth.details = {detailOf(strip, 2.3)};
    RoomPoints points(0.05, 0.002);
    const RoomParts parts = points.room(truth, [&](const Eigen::Vector3d& p) {
      return p.x() < 1.9 || p.x() > 2.5 || p.y() < 0.1 || p.y() > 3.9 ||
             p.z() < 2.8 - gap;
    });
    EXPECT_EQ(fitted(points, parts).details.size(), gap > 0 ? 0u : 1u) << gap;
  }
}

TEST(FitRoom, FieldsBetweenBeamsAreOfTheMainCeilingWhateverLevelTheyWereFoundIn)
{
  int narrow = 0; // beams
  for (const double degrees :
       {0.0, 5.0, 10.0, 15.0, 20.0, 25.0, 30.0, 35.0, 40.0, 90.0, 180.0, 270.0}) {
    SCOPED_TRACE(degrees);
    const auto turned = [&](const PlanLoop& loop) {
      return placed(loop, degrees, {0, 0});
    };
    PlanRoom truth = roomOf(turned(rectangle(0.01, 0.01, 6.01, 4.01)), 2.7);
    const PlanLoop beams[] = {turned(rectangle(1.91, 0.01, 2.11, 4.01)),
                              turned(rectangle(3.91, 0.01, 4.11, 4.01))};
    truth.details = {detailOf(beams[0], 2.4), detailOf(beams[1], 2.4)};
    RoomPoints points(0.04, 0.005);
    RoomParts parts = points.room(truth);
    const Vector2d along(std::cos(degrees * M_PI / 180),
                         std::sin(degrees * M_PI / 180));
    const auto other_fields =
        std::stable_partition(parts.ceiling.begin(), parts.ceiling.end(), [&](int i) {
          return along.dot(points[i].head<2>().cast<double>()) < 2;
        });
    parts.details.insert(parts.details.end(), other_fields, parts.ceiling.end());
    parts.ceiling.erase(other_fields, parts.ceiling.end());
    const PlanRoom room = fitted(points, parts);
    EXPECT_EQ(room.details.size(), 2u);
    for (const PlanDetail& beam : room.details)
      if (beam.boundary.area() < 0.78) {
        EXPECT_NEAR(beam.boundary.area(), 0.6, 0.02) << "a row of cells less";
        ++narrow;
      }
      else
        EXPECT_NEAR(beam.boundary.area(), 0.8, 0.02);
    const auto heightAt = [&](double x) {
      return room.ceilingAt(x * along + 2 * Vector2d(-along.y(), along.x()));
    };
    for (const double x : {1.0, 3.0, 5.0})
      EXPECT_NEAR(heightAt(x), 2.7, 0.002) << x;
    for (const double x : {2.01, 4.01})
      EXPECT_NEAR(heightAt(x), 2.4, 0.005) << x;
  }
  EXPECT_LE(narrow, 1) << "of 24";
}

} // namespace
