// SPDX-License-Identifier: BSD-3-Clause
#include "two_rooms.h"

#include <pcl/sedr_filters/point_types.h>

#include <limits>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;
using Eigen::Vector2d;

TEST(FloorplanFitting, FitsTheRoomsThatAreSetOrOneForAll)
{
  const UnequalRooms scene;
  Fitting fitting;
  setEvidence(scene.points, scene.evidence, fitting);
  Floorplan plan;
  plan.rooms.resize(5);
  ASSERT_TRUE(fitting.segment(plan)) << fitting.getErrorMessage();
  ASSERT_EQ(plan.rooms.size(), 2u);
  EXPECT_LT(cornerError(plan.rooms[1].boundary, scene.left), 0.003);
  ASSERT_EQ(fitting.getBoundaries().size(), 2u);
  EXPECT_EQ(fitting.getBoundaries()[1].room, 7u);

  fitting.setRooms({});
  RoomPoints points;
  const RoomParts parts = points.room(scene.left, 0, 2.5);
  fitting.setInputCloud(points.cloud());
  fitting.setIndices(shared(points.all()));
  fitting.setCeilingIndices(shared(parts.ceiling));
  fitting.setFloorIndices(shared(parts.floor));
  fitting.setWallIndices(nullptr);
  ASSERT_TRUE(fitting.segment(plan)) << fitting.getErrorMessage();
  ASSERT_EQ(plan.rooms.size(), 1u);
  EXPECT_EQ(plan.rooms[0].id, 1u);
  EXPECT_LT(cornerError(plan.rooms[0].boundary, scene.left), 0.001);
}

/** A fit to thinned points that deviate by 4 mm from the room of the raw cloud. */
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
  fitting_.setRawCloud(scan_);
  EXPECT_LT(errorOfPlan(), 0.0005);
  fitting_.setRawCloud(nullptr);
  EXPECT_GT(errorOfPlan(), 0.003);
}

TEST_F(OffRaw, IsMetAsWellWhereItIsAListOfPoints)
{
  const auto points = std::make_shared<std::vector<Eigen::Vector3f>>();
  for (const auto& p : *scan_)
    points->push_back(p.getVector3fMap());
  fitting_.setRawCloud(scan_);
  const double error = errorOfPlan();
  fitting_.setRawPoints(points);
  EXPECT_EQ(errorOfPlan(), error);
  fitting_.setRawPoints(nullptr);
  EXPECT_GT(errorOfPlan(), 0.003);
}

TEST_F(OffRaw, IsSeenAsItIsWhenThePlanIsFitted)
{
  const auto filled_later = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  fitting_.setRawCloud(filled_later);
  *filled_later = *scan_;
  EXPECT_LT(errorOfPlan(), 0.0005);
}

TEST_F(OffRaw, CountsByItsIndices)
{
  fitting_.setRawCloud(scan_, shared({}));
  EXPECT_GT(errorOfPlan(), 0.003) << "none of them";
  Floorplan plan;
  plan.rooms.resize(1);
  fitting_.setRawCloud(scan_, shared({-1}));
  EXPECT_FALSE(fitting_.segment(plan));
  EXPECT_TRUE(plan.rooms.empty());
  EXPECT_NE(fitting_.getErrorMessage().find("raw cloud"), std::string::npos);
}

TEST(FloorplanFitting, TellsTheBoundaryPointsOfWallsAndColumns)
{
  PlanRoom truth = roomOf(rectangle(0.01, 0.01, 6.01, 5.01), 2.5);
  truth.columns = {reversed(circle({2, 2}, 0.3))};
  RoomPoints points;
  const PlanEvidence evidence = evidenceOf(points, points.room(truth));
  Fitting fitting;
  setEvidence(points, evidence, fitting);
  Floorplan plan;
  ASSERT_TRUE(fitting.segment(plan)) << fitting.getErrorMessage();
  const std::vector<FittedBoundary>& boundaries = fitting.getBoundaries();
  ASSERT_EQ(boundaries.size(), 2u);
  EXPECT_EQ(boundaries[0].label, StructureLabel::Wall);
  EXPECT_EQ(boundaries[1].label, StructureLabel::Column);
  const PlanLoop* loops[] = {&truth.boundary, &truth.columns[0]};
  for (std::size_t b = 0; b < 2; ++b) {
    EXPECT_EQ(boundaries[b].room, 1u);
    // One per cell edge; all but those at corners are on the wall itself.
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

/** The noise of the walls of a box whose walls wave by an amplitude every metre. */
WallNoise
noiseOf(double noise, double amplitude)
{
  const PlanLoop box = rectangle(0.01, 0.01, 9.01, 7.01);
  RoomPoints points(0.05, noise);
  const RoomParts parts = points.room(box, 0, 2.5);
  const PlanEvidence evidence = evidenceOf(points, parts);
  Fitting fitting;
  setEvidence(points, evidence, fitting);
  const auto cloud = points.cloud();
  for (const int i : parts.walls) {
    pcl::PointXYZ& p = (*cloud)[static_cast<std::size_t>(i)];
    const bool is_along_x = p.y < 0.1F || p.y > 6.9F;
    float& off = is_along_x ? p.y : p.x;
    off +=
        static_cast<float>(amplitude * std::sin(2 * M_PI * (is_along_x ? p.x : p.y)));
  }
  fitting.setInputCloud(cloud);
  Floorplan plan;
  EXPECT_TRUE(fitting.segment(plan)) << fitting.getErrorMessage();
  EXPECT_EQ(fitting.getWallNoise().size(), 1u);
  return fitting.getWallNoise().empty() ? WallNoise() : fitting.getWallNoise()[0];
}

TEST(FloorplanFitting, TellsTheNoiseOfWallsAndHowFarItIsAlike)
{
  EXPECT_LT(noiseOf(0.003, 0).measured, 0.004);
  const WallNoise white = noiseOf(0.01, 0);
  EXPECT_EQ(white.rooms, std::vector<std::uint32_t>{1});
  EXPECT_GT(white.stretches, 20u);
  EXPECT_LT(white.measured, 0.01); // ten points of a wall are seen at a place
  EXPECT_LT(white.correlation, 0.1);
  // Of a sine of 1.5 cm, three quarters are within 1.39 cm: 1.2 sigma.
  const WallNoise wave = noiseOf(0.002, 0.015);
  EXPECT_NEAR(wave.measured, 0.012, 0.003);
  EXPECT_GT(wave.correlation, 0.1);
}

TEST(FloorplanFitting, TakesTheRoomsOfThePointType)
{
  const UnequalRooms scene;
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

TEST(FloorplanFitting, HiddenCellsOfNoRoomOrPlaceAreRefused)
{
  const UnequalRooms scene;
  Fitting fitting;
  setEvidence(scene.points, scene.evidence, fitting);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  Floorplan plan;
  for (const auto& [room, x] :
       {std::pair(0u, 1.0F), std::pair(7u, nan), std::pair(7u, 1e30F)}) {
    fitting.setHiddenCells({{room, {{{x, 1, 2.5F}}, {}}}});
    EXPECT_FALSE(fitting.segment(plan));
    EXPECT_NE(fitting.getErrorMessage().find("of room " + std::to_string(room)),
              std::string::npos)
        << fitting.getErrorMessage();
  }
}

TEST(FloorplanFitting, RoomsOfAnotherNumberOfPointsAreRefusedWithBothNumbers)
{
  const UnequalRooms scene;
  Fitting fitting;
  setEvidence(scene.points, scene.evidence, fitting);
  fitting.setRooms({1, 2, 3});
  Floorplan plan;
  EXPECT_FALSE(fitting.segment(plan));
  EXPECT_NE(fitting.getErrorMessage().find("of 3"), std::string::npos);
  EXPECT_NE(fitting.getErrorMessage().find(std::to_string(scene.points.size())),
            std::string::npos)
      << fitting.getErrorMessage();
  EXPECT_TRUE(plan.rooms.empty());
}

TEST(FloorplanFitting, WallsTiltOutAndInHoweverMuch)
{
  for (const double degrees : {-25.0, -8.0, 1.2, 2.0, 5.0, 12.0, 25.0}) {
    SCOPED_TRACE(degrees);
    // The foot of the wall is at x = 4 m.
    const double tilt = degrees * M_PI / 180;
    const double run = std::tan(tilt);
    const double head = 4 - 2.5 * run;
    RoomPoints points;
    RoomParts parts = points.room(rectangle(0, 0, std::max(4.0, head), 3), 0, 2.5);
    const auto scan = points.cloud();
    const auto isBeyond = [&](int i) {
      const auto& p = (*scan)[static_cast<std::size_t>(i)];
      return p.x > 4.001 - run * p.z;
    };
    for (const int i : parts.walls)
      if (auto& p = (*scan)[static_cast<std::size_t>(i)];
          p.x > std::max(4.0, head) - 0.02)
        p.x = static_cast<float>(4 - run * p.z);
    for (auto* part : {&parts.ceiling, &parts.floor, &parts.walls})
      part->erase(std::remove_if(part->begin(), part->end(), isBeyond), part->end());
    std::vector<int> seen = points.all(); // a wall hides what is behind it
    seen.erase(std::remove_if(seen.begin(), seen.end(), isBeyond), seen.end());
    Fitting fitting;
    fitting.setInputCloud(scan);
    fitting.setIndices(shared(seen));
    fitting.setCeilingIndices(shared(parts.ceiling));
    fitting.setFloorIndices(shared(parts.floor));
    fitting.setWallIndices(shared(parts.walls));
    Floorplan plan;
    ASSERT_TRUE(fitting.segment(plan)) << fitting.getErrorMessage();
    const PlanLoop& boundary = plan.rooms.at(0).boundary;
    EXPECT_LT(cornerError(boundary, rectangle(0, 0, 4, 3)), 0.01);
    double sum = 0;
    for (const PlanElement& wall : boundary.elements)
      sum += wall.tilt;
    EXPECT_NEAR(sum, tilt, 0.002);
  }
}

TEST(FloorplanFitting, ARadiusBeyondTheLimitsIsNoArc)
{
  const PlanLoop truth = placed(bittenRectangle(6, 4, 1.3), 0, {0.01, 0.01});
  RoomPoints points;
  const PlanEvidence evidence = evidenceOf(points, points.room(truth, 0, 2.5));
  Fitting fitting;
  setEvidence(points, evidence, fitting);
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
