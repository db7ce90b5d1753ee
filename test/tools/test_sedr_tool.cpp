// SPDX-License-Identifier: BSD-3-Clause
#include "option_help.h"
#include "plan_file.h"
#include "sedr_tool_runs.h"
#include "tool_cloud.h"
#include "tools/pictures/pictures.h"

#include <pcl/sedr_filters/floorplan_io.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>

namespace {

using namespace programs;

/** Expects the files of the model of a box room. */
void
expectSolidAndDrawings(const std::string& model, const nlohmann::json& told)
{
  for (const char* name : {"solid.ply", "solid.obj"}) {
    pcl::sedr::TriangleMesh solid;
    ASSERT_EQ(pcl::sedr::loadMesh(model + name, solid), "");
    EXPECT_TRUE(pcl::sedr::checkTopology(solid).isClosedManifold());
    EXPECT_EQ(solid.triangles.size(), 12u) << "a box";
    EXPECT_NEAR(solid.signedVolume(), 30, 0.2) << "outwards";
  }
  EXPECT_TRUE(says(bytesOf(model + "solid.mtl"), "newmtl wall"));
  EXPECT_TRUE(says(bytesOf(model + "floorplan.svg"), "Room 1"));
  EXPECT_TRUE(says(bytesOf(model + "floorplan.dxf"), "AC1027"));
  EXPECT_TRUE(says(bytesOf(model + "ceiling.svg"), ">ceiling 12.0"));
  EXPECT_TRUE(says(bytesOf(model + "section_rooms.svg"), ">h 2.5"));
  for (const char* name : {"ceiling.pdf", "ceiling.dxf", "section_rooms.dxf"})
    EXPECT_TRUE(std::filesystem::exists(model + name)) << name;
  const std::string ifc = bytesOf(model + "model.ifc");
  EXPECT_TRUE(says(ifc, "FILE_SCHEMA(('IFC4'))", "=IFCSPACE("));
  EXPECT_EQ(bytesOf(model + "model.glb").substr(0, 4), "glTF");
  EXPECT_EQ(told.at("closed_manifold"), true);
  EXPECT_NEAR(told.at("volume").get<double>(), 30, 0.2);
  EXPECT_NEAR(told.at("wall_area").get<double>(), 14 * 2.5, 0.2);
}

/** Points 5 cm apart along the walls leave oblique cells of 5 cm empty; behind the
 * doorway nothing was seen. */
void
expectOnlySparse(const std::string& told)
{
  EXPECT_TRUE(says(told, "too sparse for cells of 0.05 m", "look at door D1"));
  EXPECT_EQ(std::count(told.begin(), told.end(), '\n'), 2) << told;
}

TEST_F(SedrTool, KeepsThePlanOfAModelThatWasEdited)
{
  done(onFile(scanOf().pcd(false), {"--no-mesh"}));
  done(run(FLOORPLAN_EDIT, {in("model"), "--name", "1=Hall"}));
  const ProgramRun again = done(onFile(scanOf().pcd(false), {"--no-mesh"}));
  EXPECT_TRUE(says(again.err, "it is kept as floorplan.json~~"));
  EXPECT_FALSE(says(bytesOf(in("model/floorplan.json")), "Hall"));
  EXPECT_TRUE(says(bytesOf(in("model/floorplan.json~~")), "Hall"));
  EXPECT_EQ(bytesOf(in("model/floorplan.json~")), bytesOf(in("model/floorplan.json")));
  std::filesystem::copy_file(in("model/floorplan.json~~"), in("model/floorplan.json"),
                             std::filesystem::copy_options::overwrite_existing);
  done(run(FLOORPLAN_EDIT, {in("model"), "--confirm", "1.1"}));
  EXPECT_TRUE(says(bytesOf(in("model/rooms.csv")), "Hall"));
}

TEST_F(SedrTool, MakesAClosedModelOfARoomAndItsDrawings)
{
  const RoomScan scan = scanOf();
  const ProgramRun result = done(onFile(scan.pcd(false), {}));
  expectOnlySparse(result.err);
  EXPECT_EQ(result.out.rfind("1 room, 12.0 square metres", 0), 0u) << result.out;

  const ToolCloud structure = loadCloud(in("model/structure.pcd"));
  EXPECT_TRUE(structure.has_label && structure.has_room);
  for (const char* name : {"normal_x", "normal_y", "normal_z"})
    EXPECT_TRUE(pcl::sedr::tools::findField(structure.blob, name)) << name;

  const auto plan = pcl::sedr::tools::loadPlan(in("model/floorplan.json")).plan;
  ASSERT_EQ(plan.rooms.size(), 1u);
  EXPECT_NEAR(plan.rooms[0].area(), 12, 0.05);

  const auto report = nlohmann::json::parse(bytesOf(in("model/report.json")));
  EXPECT_EQ(report.at("input").at("points"), scan.points.size());
  for (const auto& entry : std::filesystem::directory_iterator(in("model")))
    EXPECT_FALSE(says(bytesOf(entry.path()), in("")))
        << entry.path() << " tells where on the disk the scan is";
  EXPECT_EQ(report.at("parameters").at("tree_depth"), 9);
  ASSERT_EQ(report.at("rooms").size(), 1u);
  EXPECT_NEAR(report.at("rooms")[0].at("volume").get<double>(), 30, 0.2);
  EXPECT_NEAR(report.at("rooms")[0].at("perimeter").get<double>(), 14, 0.05);
  EXPECT_EQ(report.at("parameters").at("voxel_size"), 0.05) << "as it was given";
  for (const char* name : {"unit", "z_up", "threads", "headroom"})
    EXPECT_TRUE(report.at("parameters").contains(name)) << name;
  ASSERT_EQ(report.at("stages").size(), 13u); // ten of the chain
  EXPECT_EQ(report.at("stages")[0].at("stage"), "reading");
  EXPECT_EQ(report.at("stages")[11].at("stage"), "MeshEvaluation");

  const auto& coverage = report.at("coverage");
  EXPECT_NEAR(coverage.at("modelled").get<double>(), 12, 0.05);
  EXPECT_NEAR(coverage.at("seen").get<double>(), 12, 0.05);
  EXPECT_EQ(coverage.at("share"), 1);
  EXPECT_TRUE(coverage.at("left_out").is_array());

  const ProgramRun judged =
      done(run(MESH_EVALUATION, {in("model/mesh.ply"), "--json", in("figures.json")}));
  const auto mesh = nlohmann::json::parse(bytesOf(in("figures.json"))).at("mesh");
  EXPECT_EQ(mesh.at("closed_manifold"), true) << judged.out;
  EXPECT_NEAR(std::abs(mesh.at("volume").get<double>()), 30, 0.4);
  expectSolidAndDrawings(in("model/"), report.at("rooms")[0].at("solid"));
  const auto& rooms = report.at("schedules").at("rooms");
  std::string line;
  for (const auto& text : rooms.at("rows").at(0))
    line += (line.empty() ? "" : ",") + text.get<std::string>();
  EXPECT_TRUE(says(bytesOf(in("model/rooms.csv")), "\r\n" + line + "\r\n"));
  EXPECT_EQ(report.at("schedules").at("walls").at("rows").size(), 4u);
  EXPECT_EQ(bytesOf(in("model/openings.csv")).rfind("number,kind,", 0), 0u);
}

TEST_F(SedrTool, AProjectHasItsOwnGuids)
{
  const std::string scan = scanOf().pcd(false);
  const auto guidOf = [&](const Strings& options) {
    done(onFile(scan, options));
    const std::string ifc = bytesOf(in("model/model.ifc"));
    return ifc.substr(ifc.find("=IFCPROJECT('") + 13, 22);
  };
  const std::string mill =
      guidOf({"--no-mesh", "--project", "Mill Lane", "--client", "Smith"});
  EXPECT_TRUE(says(bytesOf(in("model/ceiling.svg")), ">Smith<"));
  const auto report = nlohmann::json::parse(bytesOf(in("model/report.json")));
  EXPECT_EQ(report.at("parameters").at("client"), "Smith");
  EXPECT_TRUE(says(bytesOf(in("model/floorplan.svg")), ">Mill Lane<"));
  EXPECT_EQ(mill, guidOf({"--no-mesh", "--project", "Mill Lane", "--threads", "1"}));
  EXPECT_NE(mill, guidOf({"--no-mesh", "--project", "Park Road"}));
}

TEST_F(SedrTool, PriorsAreSetByNameAndReported)
{
  done(onFile(scanOf().pcd(false),
              {"--no-mesh", "--prior", "max_wall=1.5, min_headroom=2.1"}));
  std::map<std::string, double> values;
  const auto report = nlohmann::json::parse(bytesOf(in("model/report.json")));
  for (const auto& prior : report.at("priors"))
    values[prior.at("name")] = prior.at("value");
  EXPECT_EQ(values.at("max_wall"), 1.5);
  EXPECT_EQ(pcl::sedr::tools::loadPlan(in("model/floorplan.json")).max_wall, 1.5)
      << "for drawing it again";
  EXPECT_EQ(values.at("min_headroom"), 2.1);
  EXPECT_EQ(values.at("max_door_width"), 1.6) << "the default";
  EXPECT_EQ(report.at("parameters").at("headroom"), 2.1) << "of the stage";
}

TEST_F(SedrTool, DrawsRoomsAndPlanOnDemand)
{
  const std::string scan = scanOf().pcd(false);
  done(onFile(scan, {"--no-mesh"}));
  EXPECT_FALSE(std::filesystem::exists(in("model/pictures")));
  const std::string structure = bytesOf(in("model/structure.pcd"));

  std::map<std::string, std::string> first;
  for (int k = 0; k < 2; ++k) {
    done(onFile(scan, {"--no-mesh", "--pictures"}));
    EXPECT_TRUE(bytesOf(in("model/structure.pcd")) == structure)
        << "drawing changes nothing";
    std::map<std::string, std::string> pictures;
    for (const auto& entry : std::filesystem::directory_iterator(in("model/pictures")))
      pictures[entry.path().filename()] = bytesOf(entry.path());
    ASSERT_EQ(pictures.size(), 2u);
    for (const auto& [name, bytes] : pictures)
      EXPECT_GT(imageOf(bytes).width, 400) << name;
    if (k == 0)
      first = pictures;
    EXPECT_TRUE(pictures == first) << "the same bytes every time";
  }
}

TEST_F(SedrTool, WritesThePageOnDemandThatPclSedrReportWrites)
{
  const ProgramRun result = onFile(scanOf().pcd(false), {"-report"}); // PCL's one dash
  ASSERT_EQ(result.exit_code, 0) << result.err;
  expectOnlySparse(result.err);
  EXPECT_EQ(result.out.rfind("1 room, 12.0 square metres", 0), 0u) << result.out;
  const std::string page = bytesOf(in("model/report.html"));
  EXPECT_TRUE(says(page, "{\"name\":\"model\",\"report\":{\"format\":\"sedr-report\""));
  std::filesystem::remove(in("model/report.html"));
  done(run(SEDR_REPORT, {in("model")}));
  EXPECT_TRUE(bytesOf(in("model/report.html")) == page);
  EXPECT_TRUE(says(page, "\"is_scan\":true")) << "of the folder above";
  EXPECT_FALSE(says(page, in(""))) << "tells where on the disk it is";
}

TEST_F(SedrTool, LeavesNothingOfAnEarlierRunBesideItsOwnFiles)
{
  const std::string scan = scanOf().pcd(false);
  done(onFile(scan, {"--pictures", "--report"}));
  for (const char* mine : {"model/notes.txt", "model/floorplan_old.svg"})
    writeFile(in(mine), "mine");
  const Strings old{"model/mesh.ply", "model/report.html", "model/pictures"};
  const ProgramRun failed = run(SEDR, {in("nothing.pcd"), in("model"), "--no-mesh"});
  EXPECT_EQ(failed.exit_code, 1);
  for (const auto& name : old)
    EXPECT_TRUE(std::filesystem::exists(in(name))) << name << ", the run failed";
  done(onFile(scan, {"--no-mesh"}));
  for (const auto& name : old)
    EXPECT_FALSE(std::filesystem::exists(in(name))) << name << " is of another model";
  for (const char* mine : {"model/notes.txt", "model/floorplan_old.svg"})
    EXPECT_TRUE(std::filesystem::exists(in(mine))) << mine;
  writeFile(in("model/mesh.ply"), scan); // the type of a scan follows from its content
  done(run(SEDR, {in("model/mesh.ply"), in("model"), "--no-mesh"}));
  EXPECT_TRUE(bytesOf(in("model/mesh.ply")) == scan) << "what was read stays";
}

TEST_F(SedrTool, APoseInACornerOfTheRoomChangesNothing)
{
  writeFile(in("pose.txt"), "0.37 -1.21 0\n");
  done(onFile(scanOf().pcd(false), {"--no-mesh", "--positions", in("pose.txt")}));
  const auto report = nlohmann::json::parse(bytesOf(in("model/report.json")));
  EXPECT_NEAR(report.at("rooms")[0].at("area").get<double>(), 12, 0.05);
}

TEST_F(SedrTool, TellsThatHalfOfThePointsAreNotFinite)
{
  RoomScan scan = scanOf();
  const std::size_t n = scan.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    RoomPoint lost = scan.points[i];
    lost.y = std::nanf("");
    scan.points.push_back(lost);
  }
  const ProgramRun result = done(onFile(scan.pcd(false), {"--no-mesh"}));
  EXPECT_TRUE(says(result.err, "50 % of the points are not finite"));
}

TEST_F(SedrTool, KeepsTheOldModelWhereTheNewOneDoesNotFit)
{
  const std::string scan = scanOf().pcd(false);
  done(onFile(scan));
  const auto modelBytes = [&] {
    std::string all;
    for (const auto& entry : std::filesystem::directory_iterator(in("model")))
      all += bytesOf(entry.path());
    return all;
  };
  const std::string before = modelBytes();
  for (const char* size : {"1000", "20000", "200000"}) {
    const ProgramRun result =
        run("prlimit", {"--fsize=" + std::string(size), SEDR, in("input.pcd"),
                        in("model"), "--voxel-size", "0.04"});
    expectSentence(result, 1);
    EXPECT_TRUE(modelBytes() == before) << size;
  }
}

TEST_F(SedrTool, GivesTheSameBytesForAnyNumberOfThreads)
{
  const std::string bytes =
      scanOfRooms({{}, {4.47, -1.21, 4, 3, 2.5, 1, true}}).pcd(false);
  Strings results;
  for (const char* threads : {"1", "3"}) {
    done(onFile(bytes, {"--threads", threads}));
    results.push_back(bytesOf(in("model/mesh.ply")) +
                      bytesOf(in("model/structure.pcd")) +
                      bytesOf(in("model/floorplan.json")));
  }
  EXPECT_EQ(results[0], results[1]);
}

} // namespace
