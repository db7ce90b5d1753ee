// SPDX-License-Identifier: BSD-3-Clause
#include "plan_file.h"
#include "sedr_tool_runs.h"

#include <pcl/sedr_filters/floorplan_io.h>

#include <nlohmann/json.hpp>

namespace {

using namespace programs;

TEST_F(SedrTool, RefusesPriorsThatAreNone)
{
  const std::string scan = scanOf().pcd(false);
  expectFailure(onFile(scan, {"--prior", "max_wal=1"}), 1, "there is no prior max_wal");
  expectFailure(onFile(scan, {"--prior", "max_wall"}), 1, "name=value");
  expectFailure(onFile(scan, {"--prior", "max_wall=wide"}), 1, "its value a number");
  expectFailure(onFile(scan, {"--prior", "max_wall=20"}), 1, "from 0.1 to 3 m");
  expectFailure(onFile(scan, {"--origin", "1,2"}), 1, "--origin takes x,y,z");
}

TEST_F(SedrTool, FoldersThatCannotBeWrittenAreRefusedBeforeTheWork)
{
  writeFile(in("input.pcd"), scanOf().pcd(false));
  expectFailure(run(SEDR, {in("input.pcd"), in("input.pcd")}), 1, "folder");
  expectFailure(run(SEDR, {in("input.pcd"), in("input.pcd/model")}), 1, "folder");
  std::filesystem::create_directories(in("model/mesh.ply"));
  expectFailure(run(SEDR, {in("input.pcd"), in("model")}), 1, "mesh.ply");
}

TEST_F(SedrTool, MemoryThatDoesNotSufficeIsToldWhereverItEnds)
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers need terabytes of addresses";
#endif
  writeFile(in("input.pcd"), scanOf().pcd(false));
  int told = 0;
  for (int megabytes = 110; megabytes <= 250; megabytes += 10) {
    const auto limited = run(
        "/bin/sh", {"-c", "ulimit -v $0; exec \"$@\"", std::to_string(1024 * megabytes),
                    SEDR, in("input.pcd"), in("model"), "--no-mesh", "--partial"});
    EXPECT_LT(limited.exit_code, 128) << megabytes << ": " << limited.err;
    EXPECT_TRUE(limited.exit_code != 1 || limited.failsInOneSentence());
    EXPECT_EQ(limited.exit_code == 0, std::filesystem::exists(in("model")))
        << megabytes << ": " << limited.err << limited.out;
    told += limited.err.find("memory does not suffice") != std::string::npos ? 1 : 0;
    std::filesystem::remove_all(in("model"));
  }
  EXPECT_GT(told, 1);
}

TEST_F(SedrTool, AScanIsNotWrittenOver)
{
  std::filesystem::create_directory(in("same"));
  const std::string bytes = scanOf().pcd(false);
  writeFile(in("same/structure.pcd"), bytes);
  const ProgramRun result = run(SEDR, {in("same/structure.pcd"), in("same/../same")});
  expectSentence(result, 1, "would be written over");
  EXPECT_TRUE(bytesOf(in("same/structure.pcd")) == bytes);
  EXPECT_FALSE(std::filesystem::exists(in("same/mesh.ply")));
}

TEST_F(SedrTool, ScansThatCannotBeRoomsAreToldSo)
{
  const RoomScan scan = scanOf();
  const auto changed = [&](auto change) {
    RoomScan other = scan;
    for (auto& p : other.points)
      change(p);
    return other.pcd(false);
  };
  expectFailure(onFile(changed([](auto& p) { p.y = std::nanf(""); })), 1, "finite");
  expectFailure(onFile(changed([](auto& p) { p.x += 1.5e6f; })), 1, "mm");
  expectFailure(onFile(changed([](auto& p) {
                  p.x *= 1000;
                  p.y *= 1000;
                  p.z *= 1000;
                })),
                2, "millimetre");
  expectFailure(onFile(changed([](auto& p) {
                  p.x /= 0.0254f;
                  p.y /= 0.0254f;
                  p.z /= 0.0254f;
                })),
                2, "0.0254");
  expectFailure(onFile(changed([](auto& p) {
                  p.x *= 0.1f;
                  p.y *= 0.1f;
                  p.z *= 0.1f;
                })),
                2, "too small");
  RoomScan few = scan;
  few.points.resize(900);
  expectFailure(onFile(few.pcd(false)), 2, "900");
}

/** Three rooms, each point changed. */
std::string
threeRooms(const std::function<void(RoomPoint&)>& change)
{
  RoomScan scan = scanOfRooms({{0, 0, 6, 5}, {0, 5.11, 4, 3}, {4.13, 5.11, 5, 4.27}});
  for (auto& p : scan.points)
    change(p);
  return scan.pcd(false);
}

TEST_F(SedrTool, AnotherAxisOrUnitIsRefusedNamingTheOptionThatMendsIt)
{
  const auto turn = [](RoomPoint& p) { // y up
    std::swap(p.y, p.z);
    p.z = -p.z;
  };
  const auto scale = [](RoomPoint& p) {
    for (float* value : {&p.x, &p.y, &p.z})
      *value /= 0.3048F;
  };
  nlohmann::json told; // of the input in the last report
  const auto areaWith = [&](const std::string& scan, const Strings& options) {
    Strings all = options;
    all.emplace_back("--no-mesh");
    done(onFile(scan, all));
    double area = 0;
    for (const auto& room :
         pcl::sedr::tools::loadPlan(in("model/floorplan.json")).plan.rooms)
      area += room.area();
    told = nlohmann::json::parse(bytesOf(in("model/report.json"))).at("input");
    std::filesystem::remove_all(in("model"));
    return area;
  };
  const double area = 6 * 5 + 4 * 3 + 5 * 4.27;
  const std::string turned = threeRooms(turn);
  expectFailure(onFile(turned), 2, "say --up y");
  EXPECT_NEAR(areaWith(turned, {"--up", "y"}), area, 0.1);
  const std::string in_feet = threeRooms(scale);
  expectFailure(onFile(in_feet), 2, "--unit 0.3048");
  EXPECT_NEAR(areaWith(in_feet, {"--unit", "0.3048"}), area, 0.1);
  EXPECT_EQ(told.at("unit"), 0.3048) << "as the viewer is to read it";
  EXPECT_NEAR(areaWith(in_feet, {"--unit", "1"}), area / 0.3048 / 0.3048, 60);
}

TEST_F(SedrTool, ScansWithoutAStructureAreToldWhatIsMissing)
{
  const RoomScan scan = scanOf();
  const auto only = [&](Label label) {
    return scan.without([&](const RoomPoint& p) { return p.label != label; })
        .pcd(false);
  };
  expectFailure(onFile(only(Label::Floor)), 2, "no ceiling above it");
  EXPECT_FALSE(std::filesystem::exists(in("model"))) << "no folder is left behind";
  expectFailure(onFile(only(Label::Wall)), 2, "neither a floor nor a ceiling");
  expectFailure(onFile(scan.withoutLabel(Label::Ceiling).pcd(false)), 2,
                "no ceiling above it");
  expectFailure(onFile(scan.withoutLabel(Label::Floor).pcd(false)), 2,
                "no floor below it");
  expectFailure(onFile(scan.withoutLabel(Label::Wall).pcd(false)), 2, "walls");
}

/** A room of 12 m2, and beside it 48 m2 of floor and ceiling without walls. */
RoomScan
roomBesideOpenHall()
{
  RoomScan scan = scanOf();
  scan.addPiece({6, -1, 0}, {14, 5, 0}, Label::Floor, 0);
  scan.addPiece({6, -1, 2.5}, {14, 5, 2.5}, Label::Ceiling, 0);
  return scan;
}

TEST_F(SedrTool, LessThanHalfOfTheFloorIsNoModelUnlessAskedFor)
{
  const std::string scan = roomBesideOpenHall().pcd(false);
  const ProgramRun refused = onFile(scan, {"--no-mesh"});
  expectFailure(refused, 2, "--partial");
  EXPECT_TRUE(says(refused.err, "12 of "));
  EXPECT_FALSE(std::filesystem::exists(in("model"))) << "no folder is left behind";

  const ProgramRun partial = done(onFile(scan, {"--no-mesh", "--partial"}));
  EXPECT_TRUE(says(partial.err, "warning"));
  const auto report = nlohmann::json::parse(bytesOf(in("model/report.json")));
  const auto& gap = report.at("coverage").at("left_out").at(0);
  EXPECT_NEAR(gap.at("area").get<double>(), 48, 3);
  EXPECT_NEAR(gap.at("ceiling").get<double>(), 2.5, 0.1);
  EXPECT_EQ(gap.at("counts"), true);
  EXPECT_LT(report.at("coverage").at("share").get<double>(), 0.3);
  EXPECT_TRUE(std::filesystem::exists(in("model/floorplan.json")));
}

} // namespace
