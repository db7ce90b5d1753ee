// SPDX-License-Identifier: BSD-3-Clause
#include "compare/change_mesh.h"
#include "compare/plan_alignment.h"
#include "compare_plans.h"
#include "tools/run_program.h"
#include "tools/sample_files.h"

#include <pcl/io/ply_io.h>
#include <pcl/point_types.h>
#include <pcl/sedr_filters/floorplan_io.h>

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace {

using namespace programs;
using namespace pcl::sedr;
using namespace pcl::sedr::tools;
using namespace sedr_test;

/** Runs the program on plans. */
class CompareTool : public ::testing::Test {
protected:
  std::string in(const std::string& name) const
  {
    return (folder_.path() / name).string();
  }

  std::string plan(const std::string& name, const Floorplan& plan) const
  {
    writeFile(in(name), floorplanToJson(plan));
    return in(name);
  }

  TemporaryFolder folder_;
};

TEST_F(CompareTool, WritesJsonAndAColouredMesh)
{
  Floorplan before = twoRooms();
  before.rooms[1].columns.push_back(columnLoop(7, 2, 7.5, 2.4));
  const ProgramRun result =
      run(STRUCTURE_COMPARE, {plan("a.json", before), plan("b.json", twoRooms(5.3)),
                              "--mesh", in("d.ply"), "--json", in("d.json")});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'), 2);
  const auto json = nlohmann::json::parse(bytesOf(in("d.json")));
  ASSERT_EQ(json.at("changes").size(), 2u);
  EXPECT_EQ(json.at("changes")[0].at("shift")[0], 0.3);
  pcl::PointCloud<pcl::PointXYZRGB> corners;
  ASSERT_EQ(pcl::io::loadPLYFile(in("d.ply"), corners), 0);
  std::map<int, std::size_t> reds; // the colours differ in red
  for (const auto& corner : corners)
    ++reds[corner.r];
  EXPECT_EQ(reds[change_colours::vanished.red], 3u * 8) << "four faces of a column";
  EXPECT_EQ(reds[change_colours::moved.red], 3u * 4) << "both faces of the partition";
  EXPECT_EQ(reds[change_colours::appeared.red], 0u);
  EXPECT_EQ(reds[change_colours::unchanged.red], 3u * (2 * 12 - 4));
}

TEST_F(CompareTool, AStepIsNotPaintedAsTheFloorAroundItThatHasMoved)
{
  constexpr double step = 0.5;
  Floorplan before = twoRooms();
  before.rooms[0].floor_details.push_back({rectangle(1, 1, 3, 3), {}, slabAt(step)});
  Floorplan after = before;
  after.rooms[0].floor = slabAt(0.2);
  ASSERT_EQ(told(before, after),
            Lines{"moved floor by 0.20 m (z +0.20), 18.50 m2: room_1_floor -> "
                  "room_1_floor"});
  saveChangeMesh(in("d.ply"), before, after, comparePlans(before, after, {}));
  pcl::PointCloud<pcl::PointXYZRGB> corners;
  ASSERT_EQ(pcl::io::loadPLYFile(in("d.ply"), corners), 0);
  std::size_t moved = 0;
  for (const auto& corner : corners)
    if (corner.r == change_colours::moved.red) {
      ++moved;
      EXPECT_NEAR(corner.z, 0.2, 1e-6) << "on the floor, not on the step";
    }
  EXPECT_GT(moved, 0u);
}

TEST_F(CompareTool, TellsThatModelsFarApartCannotBeAligned)
{
  PlanTransform away;
  away.shift = {100, 0, 0};
  const ProgramRun result =
      run(STRUCTURE_COMPARE,
          {plan("a.json", twoRooms()), plan("b.json", transformed(twoRooms(), away)),
           "--align", "--json", in("d.json")});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_NE(result.err.find("cannot be aligned"), std::string::npos) << result.err;
  EXPECT_FALSE(std::filesystem::exists(in("d.json")));
}

TEST_F(CompareTool, RefusesWhatIsNoModel)
{
  const std::string good = plan("a.json", twoRooms());
  const std::vector<std::vector<std::string>> refused{
      {good},
      {good, in("missing.json")},
      {good, folder_.path().string()},
      {good, good, "--scan", "2"},
      {good, good, "--mesh", in("d.obj")}};
  for (const auto& arguments : refused) {
    const ProgramRun result = run(STRUCTURE_COMPARE, arguments);
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_TRUE(result.failsInOneSentence()) << result.err;
  }
  const ProgramRun same = run(STRUCTURE_COMPARE, {good, good});
  EXPECT_EQ(same.exit_code, 0);
  EXPECT_EQ(same.out, "nothing has changed\n");
}

TEST_F(CompareTool, NamesExactlyWhatChangedBetweenTwoScans)
{
  for (const char* name : {"before", "after"})
    ASSERT_EQ(run(SIMULATE_INDOOR_SCAN,
                  {DOC_FOLDER + std::string("/scenes/office_") + name + ".json",
                   in(name), "--rays", "120000"})
                  .exit_code,
              0);
  const ProgramRun result =
      run(STRUCTURE_COMPARE,
          {in("before/scan.pcd"), in("after/scan.pcd"), "--json", in("changes.json")});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto changes = nlohmann::json::parse(bytesOf(in("changes.json"))).at("changes");
  ASSERT_EQ(changes.size(), 3u) << result.out;
  EXPECT_EQ(changes[0].at("what"), "partition");
  EXPECT_EQ(changes[0].at("change"), "moved");
  const double turn = 20 * M_PI / 180;
  EXPECT_NEAR(changes[0].at("shift")[0].get<double>(), 0.3 * std::cos(turn), 0.01);
  EXPECT_NEAR(changes[0].at("shift")[1].get<double>(), 0.3 * std::sin(turn), 0.01);
  EXPECT_EQ(changes[1].at("what"), "column");
  EXPECT_EQ(changes[1].at("change"), "appeared");
  EXPECT_NEAR(changes[1].at("area").get<double>(), 0.35 * 0.35, 0.02);
  EXPECT_EQ(changes[2].at("what"), "soffit");
  EXPECT_EQ(changes[2].at("change"), "vanished");
}

} // namespace
