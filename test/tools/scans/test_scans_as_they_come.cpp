// SPDX-License-Identifier: BSD-3-Clause
// A simulated building as E57 and LAS in a national grid gives the plan of its PCD.
#include "scan_options.h"
#include "scanned_building.h"

#include <pcl/io/pcd_io.h>

namespace {

using namespace pcl::sedr::tools;
using namespace programs;
using pcl::sedr::Origin;

class ScansAsTheyCome : public ScannedBuilding {};

TEST_F(ScansAsTheyCome, E57OfThreePosesInAGridGivesThePlanAndEveryOutputItsOrigin)
{
  writeFile(in("scan.e57"), e57());
  const ProgramRun made = model(in("scan.e57"), "of_e57");
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_NE(made.err.find("counted from (6916"), std::string::npos) << made.err;
  expectPlan("of_e57");
  EXPECT_EQ(made.err.find("positions"), std::string::npos) << made.err;
  EXPECT_EQ(nlohmann::json::parse(bytesOf(in("of_e57/report.json")))
                .at("positions")
                .at("known"),
            3);
  const Origin origin = originOfModel(in("of_e57/floorplan.json"));
  EXPECT_FALSE(origin.isZero());
  EXPECT_EQ(origin, originOfModel(in("of_e57/report.json")));
  for (const char* name :
       {"structure.pcd", "solid.ply", "solid.obj", "floorplan.svg", "floorplan.dxf"})
    EXPECT_NE(bytesOf(in("of_e57/") + name).find(origin.comment()), std::string::npos)
        << name;
  for (const char* name : {"structure.pcd", "solid.ply", "solid.obj"})
    EXPECT_EQ(originOfModel(in("of_e57/") + name), origin) << name;
  EXPECT_EQ(loadCloud(in("of_e57/structure.pcd")).origin, origin);
  pcl::PointCloud<pcl::PointXYZ> cloud; // by PCL's own reader
  ASSERT_EQ(pcl::io::loadPCDFile(in("of_e57/structure.pcd"), cloud), 0);
  EXPECT_EQ(cloud.sensor_origin_.head<3>().cast<double>(), origin.place);
}

TEST_F(ScansAsTheyCome, PosesThatAreNotWhereTheScannerStoodDoNoHarm)
{
  std::swap(stations_[0].place, stations_[2].place);
  const std::string swapped = e57();
  std::swap(stations_[0].place, stations_[2].place);
  writeFile(in("swapped.e57"), swapped);
  ASSERT_EQ(model(in("swapped.e57"), "of_swapped").exit_code, 0);
  expectPlan("of_swapped");
}

TEST_F(ScansAsTheyCome, LasGivesThePlanAlsoByTheStandardInput)
{
  writeFile(in("scan.las"), las());
  ASSERT_EQ(model(in("scan.las"), "of_las").exit_code, 0);
  expectPlan("of_las");
  const std::string command = "cat " + programs::quoted(in("scan.las")) + " | " +
                              programs::quoted(PARALLEL_VOXEL_GRID) + " - " +
                              programs::quoted(in("piped.pcd")) + " 2>/dev/null";
  ASSERT_EQ(std::system(command.c_str()), 0);
  ASSERT_EQ(run(PARALLEL_VOXEL_GRID, {in("scan.las"), in("thinned.pcd")}).exit_code, 0);
  EXPECT_EQ(bytesOf(in("piped.pcd")), bytesOf(in("thinned.pcd")));
}

TEST_F(ScansAsTheyCome, TwoScansOfASiteAreComparedInOneFrame)
{
  writeFile(in("site.las"), las());
  ASSERT_EQ(model(in("site.las"), "one").exit_code, 0);
  ASSERT_EQ(model(in("site.las"), "two", {"--origin", "691590.5,5335990,0"}).exit_code,
            0);
  ASSERT_EQ(model(in("site.las"), "three", {"--origin", in("two")}).exit_code, 0);
  EXPECT_EQ(originOfModel(in("two/floorplan.json")), (Origin{{691590.5, 5335990, 0}}));
  EXPECT_EQ(originOfModel(in("three/floorplan.json")),
            originOfModel(in("two/floorplan.json")));
  const ProgramRun compared = run(STRUCTURE_COMPARE, {in("one"), in("two")});
  EXPECT_EQ(compared.exit_code, 0) << compared.err;
  EXPECT_EQ(compared.out, "nothing has changed\n");
}

TEST_F(ScansAsTheyCome, PositionsTellWhatWindowsMirror)
{
  ASSERT_EQ(run(SIMULATE_INDOOR_SCAN, {"big_windows", in("glass"), "--rays", "8000"})
                .exit_code,
            0);
  const std::string scan = in("glass/scan.pcd");
  const auto positionsOf = [&](const std::string& folder) {
    return nlohmann::json::parse(bytesOf(in(folder) + "/report.json")).at("positions");
  };
  ASSERT_EQ(model(scan, "unknown").exit_code, 0);
  EXPECT_TRUE(positionsOf("unknown").is_null());
  const ProgramRun made =
      model(scan, "known", {"--positions", in("glass/positions.txt")});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_NE(made.err.find(" mirror"), std::string::npos) << made.err;
  EXPECT_EQ(positionsOf("known").at("known"), 40);
  EXPECT_GE(positionsOf("known").at("mirrors"), 1);
  EXPECT_GT(positionsOf("known").at("mirrored_points"), 1000);
  const ProgramRun refused = model(scan, "no", {"--positions", scan});
  expectSentence(refused, 1);
}

} // namespace
