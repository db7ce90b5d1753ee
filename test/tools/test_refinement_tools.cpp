// SPDX-License-Identifier: BSD-3-Clause
#include "tool_cloud.h"
#include "tool_contract.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace programs;
using pcl::sedr::tools::floatField;
using pcl::sedr::tools::loadCloud;
using pcl::sedr::tools::ToolCloud;
using Strings = std::vector<std::string>;

INSTANTIATE_TEST_SUITE_P(
    RefinementTools,
    ToolContract,
    ::testing::Values(Tool(STRUCTURE_REFINEMENT, "output.pcd", true),
                      Tool(VERTICAL_HOLE_REPAIR, "output.pcd", true)));

class RefinementTools : public InFolder<> {
protected:
  ProgramRun runOn(const std::string& tool,
                   const std::string& bytes,
                   const Strings& options = {},
                   const std::string& output = "output.pcd")
  {
    writeFile(in("input.pcd"), bytes);
    if (!std::filesystem::exists(in("plan.json")))
      writeFile(in("plan.json"), pcl::sedr::floorplanToJson({{planOf(BoxRoom())}}));
    return run(tool, {in("input.pcd"), in("plan.json"), in(output)}, options);
  }

  void
  expectFailure(const ProgramRun& result, int exit_code, const std::string& words) const
  {
    expectSentence(result, exit_code, words);
    EXPECT_FALSE(std::filesystem::exists(in("output.pcd")));
  }
};

/** Expects every point on the surface of its label, with a normal into the room. */
void
expectOnSurfaces(const ToolCloud& cloud)
{
  const pcl::sedr::PlanRoom room = planOf(BoxRoom());
  const auto x = floatField(cloud.blob, "normal_x");
  const auto y = floatField(cloud.blob, "normal_y");
  const auto z = floatField(cloud.blob, "normal_z");
  ASSERT_EQ(z.size(), cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d p = (*cloud.points)[i].getVector3fMap().cast<double>();
    const Eigen::Vector3d normal(x[i], y[i], z[i]);
    const auto label = static_cast<Label>(cloud.label[i]);
    ASSERT_EQ(cloud.room[i], 1u);
    if (label == Label::Wall) {
      const auto isOn = [&](const auto& e) {
        return e.distance(p.head<2>()) < 1e-5 &&
               (e.normalAt(0) - normal.head<2>()).norm() < 1e-6;
      };
      const auto& walls = room.boundary.elements;
      ASSERT_TRUE(std::any_of(walls.begin(), walls.end(), isOn)) << "row " << i;
    }
    else {
      ASSERT_NEAR(p.z(), label == Label::Floor ? 0 : 2.5, 1e-5) << "row " << i;
      ASSERT_EQ(normal.z(), label == Label::Floor ? 1 : -1) << "row " << i;
    }
  }
}

TEST_F(RefinementTools, RefinementMovesPointsOntoTheirSurfaces)
{
  const RoomScan scan = scanOf();
  const ProgramRun result = runOn(STRUCTURE_REFINEMENT, scan.pcd(true));
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out + result.err, "") << "quiet when piped";
  const ToolCloud cloud = loadCloud(in("output.pcd"));
  expectOnSurfaces(cloud);

  // Every labelled point is present, in order, with its fields and on its surface.
  const auto intensity = floatField(cloud.blob, "intensity");
  std::size_t next = 0;
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const RoomPoint& p = scan.points[i];
    if (p.label == Label::Other)
      continue;
    ASSERT_LT(next, cloud.size());
    ASSERT_EQ(intensity[next], static_cast<float>(i));
    ASSERT_LT((Eigen::Vector3f(p.x, p.y, p.z) - (*cloud.points)[next].getVector3fMap())
                  .norm(),
              0.0021f);
    ++next;
  }
  EXPECT_EQ(next, cloud.size());
}

TEST_F(RefinementTools, RefinementLeavesPointsOutThatAreTooFarFromTheirSurface)
{
  RoomScan scan =
      scanOf().without([](const RoomPoint& p) { return p.label != Label::Wall; });
  const std::size_t walls = scan.points.size();
  const float y = static_cast<float>(BoxRoom().y);
  scan.points.push_back({1.5f, y + 0.1f, 1.f, Label::Wall, 1});
  scan.points.push_back({1.5f, y + 0.2f, 1.f, Label::Wall, 1});
  scan.points.push_back({1.5f, y, 1.f, Label::Wall, 2}); // the plan has no room 2
  scan.points.push_back({1.5f, std::nanf(""), 1.f, Label::Wall, 1});
  EXPECT_EQ(runOn(STRUCTURE_REFINEMENT, scan.pcd(true)).exit_code, 0);
  EXPECT_EQ(loadCloud(in("output.pcd")).size(), walls + 1);
  EXPECT_EQ(
      runOn(STRUCTURE_REFINEMENT, scan.pcd(true), {"--max-distance", "0.05"}).exit_code,
      0);
  EXPECT_EQ(loadCloud(in("output.pcd")).size(), walls);
}

TEST_F(RefinementTools, RepairClosesTheDoorAndWhatTheCupboardHid)
{
  ASSERT_EQ(
      runOn(STRUCTURE_REFINEMENT, scanOf().pcd(true), {}, "refined.pcd").exit_code, 0);
  const ProgramRun result = runOn(VERTICAL_HOLE_REPAIR, bytesOf(in("refined.pcd")));
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out + result.err, "") << "quiet when piped";
  const ToolCloud cloud = loadCloud(in("output.pcd"));
  expectOnSurfaces(cloud);
  // 59 square metres of surface, 400 cells per square metre.
  EXPECT_NEAR(static_cast<double>(cloud.size()), 400 * (24 + 35), 300);

  // Scanned points come first and keep their fields; new points have zeros in them.
  const auto intensity = floatField(cloud.blob, "intensity");
  const auto added = std::find_if(intensity.rbegin(), intensity.rend(),
                                  [](float v) { return v != 0; }) -
                     intensity.rbegin();
  EXPECT_LE(std::count(intensity.begin(), intensity.end() - added, 0.f), 1);
  // The doorway of 2 square metres; at the cupboard 1.8 of wall and 2 of floor.
  EXPECT_NEAR(static_cast<double>(added), 400 * 5.8, 250);
}

TEST_F(RefinementTools, PlansThatAreNoneAreRefused)
{
  const std::string good = pcl::sedr::floorplanToJson({{planOf(BoxRoom())}});
  for (const std::string& bad :
       {std::string("no plan at all"), std::string(1000, '\0'), std::string("{}"),
        std::string("[1, 2]"), good.substr(0, good.size() / 2), std::string()}) {
    writeFile(in("plan.json"), bad);
    for (const char* tool : {STRUCTURE_REFINEMENT, VERTICAL_HOLE_REPAIR})
      expectFailure(runOn(tool, scanOf().pcd(true)), 1, "plan.json");
  }
  writeFile(in("plan.json"), "VERSION .7\nFIELDS x y z\n");
  for (const char* tool : {STRUCTURE_REFINEMENT, VERTICAL_HOLE_REPAIR})
    expectFailure(runOn(tool, scanOf().pcd(true)), 1, "a floor plan is asked for");
  writeFile(in("plan.json"), pcl::sedr::floorplanToJson({}));
  for (const char* tool : {STRUCTURE_REFINEMENT, VERTICAL_HOLE_REPAIR})
    expectFailure(runOn(tool, scanOf().pcd(true)), 2, "no rooms");
}

TEST_F(RefinementTools, WhatHasNoPointOnThePlanIsToldSo)
{
  BoxRoom elsewhere;
  elsewhere.x = 100;
  for (const char* tool : {STRUCTURE_REFINEMENT, VERTICAL_HOLE_REPAIR}) {
    expectFailure(runOn(tool, scanOf(elsewhere).pcd(true)), 2, "none of the");
    expectFailure(runOn(tool, scanOf().pcd(false)), 2, "none of the");
  }
}

} // namespace
