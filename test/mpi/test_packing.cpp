// SPDX-License-Identifier: BSD-3-Clause
#include "mpi/packing.h"

#include <pcl/sedr_filters/floorplan_io.h>

#include <gtest/gtest.h>

#include <limits>

namespace {

using namespace pcl::sedr;
using namespace pcl::sedr::tools;

PlanElement
elementOf(double x)
{
  PlanElement element;
  element.start = {x, 1. / 3};
  element.end = {x + 1, -1e-17};
  element.centre = {0.1, 0.2};
  element.radius = x / 7;
  element.counter_clockwise = false;
  element.inliers = 12;
  element.residual = 1e-3;
  element.evidence = {0.5, 0.25, 0.125};
  return element;
}

PlanRoom
roomWithEverything()
{
  PlanRoom room;
  room.id = 7;
  room.boundary.elements = {elementOf(1), elementOf(2)};
  room.columns = {{{elementOf(3)}}};
  room.floor.plane = {1e-3, 0, 1, 0.1};
  room.floor.inliers = 5;
  room.ceiling.residual = 0.004;
  room.details = {{room.boundary, room.columns, room.floor}};
  room.floor_details = room.details;
  room.niches = {{room.boundary, room.floor, room.ceiling}};
  return room;
}

TEST(Packing, AJobComesOutAsItWentIn)
{
  RepairJob job;
  job.plan = roomWithEverything();
  job.points = {{1, 2, 3}, {0.1f, std::numeric_limits<float>::quiet_NaN(), -5}};
  job.labels = {3, 1};
  job.maximum_distance = 0.15;
  job.grid_size = 0.05;
  const std::string bytes = pack(RoomJob(job));
  const auto unpacked = unpack<RoomJob>(bytes);
  EXPECT_EQ(roomOf(unpacked), 7u);
  EXPECT_TRUE(pack(unpacked) == bytes);
  const auto& same = std::get<RepairJob>(unpacked);
  EXPECT_EQ(floorplanToJson({{same.plan}}), floorplanToJson({{job.plan}}));
  EXPECT_EQ(same.plan.boundary.elements[1].evidence.opening, 0.125);
  EXPECT_EQ(same.points[1].z(), -5);
  EXPECT_EQ(same.labels, job.labels);
  EXPECT_EQ(same.grid_size, 0.05);
}

TEST(Packing, WallsKeepTheirOptions)
{
  WallJob job;
  job.room = 4;
  job.points.resize(9);
  job.candidates = {1, 2, 8};
  job.details = {3};
  job.boundary.neighbours = 11;
  job.boundary.angle = 0.5f;
  job.growing.distance = 0.25;
  job.growing.minimum_support = 0.75;
  const auto same = std::get<WallJob>(unpack<RoomJob>(pack(RoomJob(job))));
  EXPECT_EQ(same.room, 4u);
  EXPECT_EQ(same.candidates, job.candidates);
  EXPECT_EQ(same.details, job.details);
  EXPECT_TRUE(same.floor.empty());
  EXPECT_EQ(same.boundary.neighbours, 11u);
  EXPECT_EQ(same.boundary.angle, 0.5f);
  EXPECT_EQ(same.growing.distance, 0.25);
  EXPECT_EQ(same.growing.minimum_support, 0.75);
  EXPECT_FALSE(same.growing.hasSlice());
}

TEST(Packing, ASurfaceKeepsItsReport)
{
  RoomSurface surface;
  surface.mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1. / 3, 0}};
  surface.mesh.triangles = {{0, 1, 2}};
  surface.mesh.rooms = {2};
  surface.report.room = 2;
  surface.report.closed = true;
  surface.report.screened.iterations = 9;
  surface.report.removed_triangles = 8;
  surface.report.topology.euler_characteristic = -4;
  surface.report.topology.components = {{1, 2.5, -3.5, true}};
  surface.report.warning = "it is small";
  const std::string bytes = pack(RoomResult(surface));
  const auto result = unpack<RoomResult>(bytes);
  const auto& same = std::get<RoomSurface>(result);
  EXPECT_TRUE(same.mesh.vertices == surface.mesh.vertices);
  EXPECT_TRUE(same.mesh.triangles == surface.mesh.triangles);
  EXPECT_EQ(same.mesh.rooms, surface.mesh.rooms);
  EXPECT_TRUE(same.mesh.labels.empty());
  EXPECT_TRUE(same.report.closed);
  EXPECT_EQ(same.report.screened.iterations, 9);
  EXPECT_EQ(same.report.removed_triangles, 8u);
  EXPECT_EQ(same.report.topology.euler_characteristic, -4);
  ASSERT_EQ(same.report.topology.components.size(), 1u);
  EXPECT_EQ(same.report.topology.components[0].signed_volume, -3.5);
  EXPECT_EQ(same.report.warning, "it is small");

  const auto lost = unpack<RoomResult>(pack(RoomResult(LostRoom{"gone"})));
  EXPECT_EQ(std::get<LostRoom>(lost).reason, "gone");
}

TEST(Packing, SamplesKeepTheParametersOfTheirSurface)
{
  SurfaceJob job;
  job.samples.room = 3;
  job.samples.points = {{{1, 2, 3}, {0, 0, 1}}};
  job.samples.skipped = 6;
  job.parameters.depth = 8;
  job.parameters.cell_ratio = 0.7;
  job.parameters.support_distance = 0.2;
  const auto same = std::get<SurfaceJob>(unpack<RoomJob>(pack(RoomJob(job))));
  EXPECT_EQ(same.samples.room, 3u);
  EXPECT_EQ(same.samples.skipped, 6u);
  EXPECT_EQ(same.samples.points[0].normal.z(), 1);
  EXPECT_EQ(same.parameters.depth, 8);
  EXPECT_EQ(same.parameters.point_weight, 10);
  EXPECT_EQ(same.parameters.cell_ratio, 0.7);
  EXPECT_EQ(same.parameters.support_distance, 0.2);
}

} // namespace
