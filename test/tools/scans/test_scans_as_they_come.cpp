// SPDX-License-Identifier: BSD-3-Clause
// A room as E57 and LAS in a national grid, and the programs that read scans: their
// options, what they write, and what they refuse.
#include "plan_file.h"
#include "room_scan_files.h"
#include "scan_file.h"
#include "scan_options.h"
#include "tools/in_folder.h"
#include "tools/option_help.h"

#include <nlohmann/json.hpp>

#include <pcl/io/pcd_io.h>

#include <map>

namespace {

using namespace pcl::sedr::tools;
using namespace programs;
using pcl::sedr::Origin;
using Strings = std::vector<std::string>;

/** A box room as E57 and LAS in a national grid. */
class ScansAsTheyCome : public InFolder<> {
protected:
  static inline const Eigen::Vector3d grid{691600, 5336000, 12};

  ProgramRun
  model(const std::string& scan, const std::string& folder, const Strings& options = {})
  {
    return run(SEDR, {scan, in(folder), "--no-mesh"}, options);
  }

  /** Expects the plan of the room at its place in the grid. */
  void expectRoom(const std::string& folder)
  {
    const pcl::sedr::PlanDocument file = loadPlan(in(folder) + "/floorplan.json");
    ASSERT_EQ(file.plan.rooms.size(), 1u);
    const pcl::sedr::PlanRoom& room = file.plan.rooms[0];
    EXPECT_EQ(room.boundary.elements.size(), 4u);
    EXPECT_NEAR(room.area(), 4 * 3, 0.05);
    const Eigen::Vector3d off = file.origin.place - grid;
    for (const auto& wall : room.boundary.elements) {
      const Eigen::Vector2d corner = wall.start + off.head<2>();
      EXPECT_NEAR(std::abs(corner.x() - 2.37), 2, 0.01);
      EXPECT_NEAR(std::abs(corner.y() - 0.29), 1.5, 0.01);
      EXPECT_NEAR(room.floor.heightAt(wall.start) + off.z(), 0, 0.01);
      EXPECT_NEAR(room.ceiling.heightAt(wall.start) + off.z(), 2.5, 0.01);
    }
  }
};

TEST_F(ScansAsTheyCome, E57OfPosesInAGridGivesThePlanAndEveryOutputItsOrigin)
{
  writeFile(in("scan.e57"), asE57(scanOf(), grid));
  const ProgramRun made = done(model(in("scan.e57"), "of_e57"));
  EXPECT_TRUE(says(made.err, "counted from (6916"));
  expectRoom("of_e57");
  EXPECT_FALSE(says(made.err, "positions"));
  EXPECT_EQ(nlohmann::json::parse(bytesOf(in("of_e57/report.json")))
                .at("positions")
                .at("known"),
            2);
  const Origin origin = originOfModel(in("of_e57/floorplan.json"));
  EXPECT_FALSE(origin.isZero());
  EXPECT_EQ(origin, originOfModel(in("of_e57/report.json")));
  for (const char* name :
       {"structure.pcd", "solid.ply", "solid.obj", "floorplan.svg", "floorplan.dxf"})
    EXPECT_TRUE(says(bytesOf(in("of_e57/") + name), origin.comment())) << name;
  for (const char* name : {"structure.pcd", "solid.ply", "solid.obj"})
    EXPECT_EQ(originOfModel(in("of_e57/") + name), origin) << name;
  EXPECT_EQ(loadCloud(in("of_e57/structure.pcd")).origin, origin);
  pcl::PointCloud<pcl::PointXYZ> cloud; // by PCL's own reader
  ASSERT_EQ(pcl::io::loadPCDFile(in("of_e57/structure.pcd"), cloud), 0);
  EXPECT_EQ(cloud.sensor_origin_.head<3>().cast<double>(), origin.place);
}

TEST_F(ScansAsTheyCome, PosesThatAreNotWhereTheScannerStoodDoNoHarm)
{
  writeFile(in("swapped.e57"), asE57(scanOf(), grid, {{{-20, 0, 1}, {9, -20, 1.5}}}));
  done(model(in("swapped.e57"), "of_swapped"));
  expectRoom("of_swapped");
}

TEST_F(ScansAsTheyCome, LasGivesThePlanAlsoByTheStandardInput)
{
  writeFile(in("scan.las"), asLas(scanOf(), grid));
  done(model(in("scan.las"), "of_las"));
  expectRoom("of_las");
  const std::string command = "cat " + programs::quoted(in("scan.las")) + " | " +
                              programs::quoted(PARALLEL_VOXEL_GRID) + " - " +
                              programs::quoted(in("piped.pcd")) + " 2>/dev/null";
  ASSERT_EQ(std::system(command.c_str()), 0);
  done(run(PARALLEL_VOXEL_GRID, {in("scan.las"), in("thinned.pcd")}));
  EXPECT_EQ(bytesOf(in("piped.pcd")), bytesOf(in("thinned.pcd")));
}

TEST_F(ScansAsTheyCome, TwoScansOfASiteAreComparedInOneFrame)
{
  writeFile(in("site.las"), asLas(scanOf(), grid));
  done(model(in("site.las"), "one"));
  done(model(in("site.las"), "two", {"--origin", "691590.5,5335990,0"}));
  done(model(in("site.las"), "three", {"--origin", in("two")}));
  EXPECT_EQ(originOfModel(in("two/floorplan.json")), (Origin{{691590.5, 5335990, 0}}));
  EXPECT_EQ(originOfModel(in("three/floorplan.json")),
            originOfModel(in("two/floorplan.json")));
  const ProgramRun compared = done(run(STRUCTURE_COMPARE, {in("one"), in("two")}));
  EXPECT_EQ(
      compared.out,
      "nothing has changed by more than 0.05 m; widths of openings are not compared\n");
}

TEST_F(ScansAsTheyCome, PositionsTellWhatWindowsMirror)
{
  done(run(SIMULATE_INDOOR_SCAN, {"big_windows", in("glass"), "--rays", "8000"}));
  const std::string scan = in("glass/scan.pcd");
  const auto positionsOf = [&](const std::string& folder) {
    return nlohmann::json::parse(bytesOf(in(folder) + "/report.json")).at("positions");
  };
  done(model(scan, "unknown"));
  EXPECT_TRUE(positionsOf("unknown").is_null());
  const ProgramRun made =
      done(model(scan, "known", {"--positions", in("glass/positions.txt")}));
  EXPECT_TRUE(says(made.err, " mirror"));
  EXPECT_EQ(positionsOf("known").at("known"), 40);
  EXPECT_GE(positionsOf("known").at("mirrors"), 1);
  EXPECT_GT(positionsOf("known").at("mirrored_points"), 1000);
  const ProgramRun refused = model(scan, "no", {"--positions", scan});
  expectSentence(refused, 1);
}

TEST(ScanPrograms, AllTakeTheSameReadingOptions)
{
  for (const char* program : {SEDR, PARALLEL_VOXEL_GRID, SCAN_TO_PCD,
#ifdef SEDR_MPI
                              SEDR_MPI
#endif
       }) {
    std::map<std::string, std::string> texts;
    for (const OptionHelp& option : optionsIn(run(program, {"--help"}).out))
      texts[option.name] = option.text;
    static std::map<std::string, std::string> first;
    if (first.empty())
      first = texts;
    for (const char* name :
         {"unit", "up", "origin", "scan", "skip-broken", "columns"}) {
      ASSERT_EQ(texts.count(name), 1u) << program << " --" << name;
      EXPECT_EQ(texts[name], first[name]) << program;
    }
  }
}

TEST_F(ScansAsTheyCome, BadOptionsAndScansThatStayTooLargeAreOneSentence)
{
  writeFile(in("large.las"), asLas(scanOf(), grid));
  writeFile(in("cloud.pcd"), scanOf().pcd(false));
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{"--origin", "1,2"},
        {"--origin", "0,0,0"},
        {"--origin", in("nowhere")},
        {"--origin", in("large.las")},
        {"--origin", in("cloud.pcd")},
        {"--scan", "2"},
        {"--skip-broken"},
        {"--columns", "x,y,z"}}) {
    const ProgramRun made = model(in("large.las"), "refused", options);
    expectSentence(made, 1);
    EXPECT_FALSE(std::filesystem::exists(in("refused")));
  }
}

TEST_F(ScansAsTheyCome, ConvertersWriteWhatIsRead)
{
  writeFile(in("scan.e57"), asE57(scanOf(), grid));
  writeFile(in("scan.las"), asLas(scanOf(), grid));
  const ProgramRun listed = done(run(SCAN_TO_PCD, {in("scan.e57"), "--list"}));
  EXPECT_TRUE(says(listed.out, "station"));
  EXPECT_TRUE(
      says(listed.out, Origin{grid + Eigen::Vector3d(2.5, 1.5, 1.4)}.text(", ")));
  const ProgramRun both =
      run(SCAN_TO_PCD, {in("scan.e57"), in("one.pcd"), "--list", "--scan", "9"});
  EXPECT_EQ(both.exit_code, 1);
  EXPECT_TRUE(says(both.err, "it takes no --scan"));
  done(run(SCAN_TO_PCD, {in("scan.e57"), in("one.pcd"), "--scan", "1"}));
  const ToolCloud one = loadCloud(in("one.pcd"));
  const RoomScan scan = scanOf();
  ASSERT_EQ(one.size(), scan.points.size() / 2);
  for (std::size_t i = 0; i < one.size(); i += 100) {
    const Eigen::Vector3d place(scan.points[i].x, scan.points[i].y, scan.points[i].z);
    const Eigen::Vector3f p = (*one.points)[i].getVector3fMap();
    EXPECT_LT((one.origin.toGiven(p.cast<double>()) - grid - place).norm(), 3e-6);
  }
  done(run(SCAN_TO_PCD, {in("scan.las"), in("all.ply")}));
  EXPECT_EQ(loadCloud(in("all.ply")).blob.data, loadCloud(in("scan.las")).blob.data);
  EXPECT_EQ(run(SCAN_TO_PCD, {in("scan.e57")}).exit_code, 1);
  const ProgramRun broken = run(SCAN_TO_PCD, {in("scan.e57") + "x", in("no.pcd")});
  EXPECT_EQ(broken.exit_code, 1);
  EXPECT_FALSE(std::filesystem::exists(in("no.pcd")));
}

TEST_F(ScansAsTheyCome, AFileThatShrinksWhileItIsReadIsAnError)
{
  LasSample sample;
  sample.points.assign(200000, {1, 2, 3});
  for (std::size_t i = 0; i < sample.points.size(); ++i)
    sample.points[i][0] = static_cast<std::int32_t>(i);
  std::string lines;
  for (int i = 0; i < 100000; ++i)
    lines += std::to_string(i % 900) + " 2 3\n";
  for (const std::string& bytes : {sample.bytes(), asE57(scanOf()), lines}) {
    writeFile(in("shrinks"), bytes);
    ScanSettings pieces;
    pieces.piece_bytes = 100000;
    const ScanFile scan(in("shrinks"), pieces);
    std::string reason;
    try {
      scan.forEachPiece([&](const pcl::sedr::RowSource::Piece& piece) {
        if (piece.first == 0)
          std::filesystem::resize_file(in("shrinks"), 300000);
        return true;
      });
    }
    catch (const std::exception& error) {
      reason = error.what();
    }
    EXPECT_TRUE(says(reason, "could not be read to its end: it has become shorter"));
  }
}

} // namespace
