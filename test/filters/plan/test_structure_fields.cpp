// SPDX-License-Identifier: BSD-3-Clause
#include "plan_loops.h"

#include <pcl/sedr_filters/impl/structure_fields.hpp>

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

template <typename PointT>
PointT
movedTo()
{
  SurfacePoint surface;
  surface.position = {1, 2, 3};
  surface.normal = {0, 0.6, -0.8};
  surface.label = StructureLabel::Wall;
  surface.room = 7;
  PointT p;
  setSurfacePoint(surface, p);
  return p;
}

TEST(StructureFields, APointGetsWhatItsTypeHas)
{
  EXPECT_EQ(movedTo<pcl::PointXYZ>().getVector3fMap(), Eigen::Vector3f(1, 2, 3));
  EXPECT_EQ(movedTo<pcl::PointXYZL>().label, 3u);
  EXPECT_EQ(movedTo<pcl::PointNormal>().getNormalVector3fMap(),
            Eigen::Vector3f(0, 0.6f, -0.8f));
  const auto p = movedTo<pcl::PointStructure>();
  EXPECT_EQ(p.getVector3fMap(), Eigen::Vector3f(1, 2, 3));
  EXPECT_EQ(p.getNormalVector3fMap(), Eigen::Vector3f(0, 0.6f, -0.8f));
  EXPECT_EQ(p.label, 3u);
  EXPECT_EQ(p.room, 7u);
}

TEST(StructureFields, LabelsAndRoomsComeFromThePointTypeOnlyIfNoneWereGiven)
{
  const Floorplan plan{{roomOf(rectangle(0, 0, 4, 3), 2.5)}};
  pcl::PointCloud<pcl::PointStructure> cloud(2, 1);
  cloud[0].label = 2;
  cloud[1].room = 5;
  std::vector<std::uint32_t> labels;
  std::vector<std::uint32_t> rooms{8, 9};
  EXPECT_EQ(structureProblem(&plan, cloud, {0, 1}, labels, rooms), "");
  EXPECT_EQ(labels, (std::vector<std::uint32_t>{2, 0}));
  EXPECT_EQ(rooms, (std::vector<std::uint32_t>{8, 9})) << "as they were given";
  rooms.clear();
  EXPECT_EQ(structureProblem(&plan, cloud, {}, labels, rooms), "");
  EXPECT_EQ(rooms, (std::vector<std::uint32_t>{0, 5}));
}

TEST(StructureFields, WhatIsMissingIsToldWithItsNumbers)
{
  const Floorplan plan{{roomOf(rectangle(0, 0, 4, 3), 2.5)}};
  const Floorplan none;
  const pcl::PointCloud<pcl::PointXYZL> cloud(3, 1);
  std::vector<std::uint32_t> labels;
  std::vector<std::uint32_t> rooms;
  EXPECT_EQ(structureProblem(nullptr, cloud, {}, labels, rooms),
            "no floor plan with rooms was set");
  EXPECT_EQ(structureProblem(&none, cloud, {}, labels, rooms),
            "no floor plan with rooms was set");
  EXPECT_EQ(structureProblem(&plan, cloud, {0, 3}, labels, rooms),
            "index 3 is out of range, the cloud has 3 points");
  EXPECT_EQ(structureProblem(&plan, cloud, {0}, labels, rooms),
            "the cloud has 3 points, but 3 labels and 0 rooms are known");
  labels = {1};
  rooms = {1, 1, 1};
  EXPECT_EQ(structureProblem(&plan, cloud, {0}, labels, rooms),
            "the cloud has 3 points, but 1 labels and 3 rooms are known");
}

} // namespace
