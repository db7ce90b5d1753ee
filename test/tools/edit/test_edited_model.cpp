// SPDX-License-Identifier: BSD-3-Clause
#include "plan_file.h"
#include "tools/in_folder.h"
#include "tools/sample_result.h"

#include <boost/algorithm/string.hpp>
#include <nlohmann/json.hpp>

namespace {

using namespace programs;
using Json = nlohmann::ordered_json;

/** Edits of a folder with two rooms of which a run has told doubts. */
class EditedModel : public InFolder<> {
protected:
  void SetUp() override
  {
    SampleResult().writeTo(model());
    writeFile(in("model/floorplan_1.svg"), "of a building with storeys");
    writeFile(in("model/notes.txt"), "of the user");
    const auto doubt = [](int room, int wall, const char* reason) {
      return Json{{"kind", "stage"},
                  {"room", room},
                  {"wall", wall},
                  {"reason", reason},
                  {"text", reason}};
    };
    Json report = reportNow();
    report["files"] = {"structure.pcd", "mesh.ply",        "floorplan.json",
                       "solid.ply",     "floorplan_1.svg", "report.json"};
    report["rooms"] = {{{"id", 1}, {"mesh", "of 1"}}, {{"id", 2}, {"mesh", "of 2"}}};
    report["walls"] = {{{"room", 1}, {"walls", {3}}}, {{"room", 2}, {"walls", {2}}}};
    report["warnings"] = {doubt(0, 0, "of all"), doubt(1, 3, "off"), doubt(1, 0, "low"),
                          doubt(2, 2, "off"), doubt(2, 0, "low")};
    for (const auto& [key, text] : {std::pair("title", "Mill Lane 14"),
                                    {"client", "Smith"},
                                    {"project", "P-17"},
                                    {"date", "2024-05-31"},
                                    {"drawn_by", "EK"}})
      report["parameters"][key] = text;
    writeFile(in("model/report.json"), report.dump());
  }

  std::string model() const { return in("model"); }

  ProgramRun edit(const std::vector<std::string>& edits) const
  {
    return run(FLOORPLAN_EDIT, {model()}, edits);
  }

  Json reportNow() const { return Json::parse(bytesOf(in("model/report.json"))); }

  bool has(const std::string& name) const
  {
    return std::filesystem::exists(in("model/" + name));
  }

  /** Returns the texts of all doubts. */
  std::vector<std::string> doubts() const
  {
    std::vector<std::string> texts;
    const Json report = reportNow();
    for (const Json& warning : report["warnings"])
      texts.push_back(warning["text"]);
    return texts;
  }
};

TEST_F(EditedModel, AllFilesThatFollowFromThePlanAreOfTheNewOneAndAgree)
{
  const std::string mesh = bytesOf(in("model/mesh.ply"));
  const ProgramRun result = done(edit({"--move-wall", "2.2=0.5", "--name", "2=Küche"}));
  EXPECT_EQ(result.out, "wall 2.2 is moved outwards by 0.500 m; room 2 has 12.00 m2 in "
                        "place of 10.50\nroom 2 is called Küche\nall files that follow "
                        "from the plan are written, still of the scan: mesh.ply, "
                        "structure.pcd\n");
  for (const char* name :
       {"floorplan.svg", "floorplan.pdf", "floorplan.dxf", "model.ifc", "model.glb",
        "solid.obj", "walls.csv", "openings.csv", "notes.txt", "structure.pcd"})
    EXPECT_TRUE(has(name)) << name;
  EXPECT_FALSE(has("floorplan_1.svg")) << "of a plan before";
  EXPECT_FALSE(has("report.html")) << "there was none";
  EXPECT_EQ(bytesOf(in("model/mesh.ply")), mesh);
  const Json rooms = reportNow()["rooms"];
  EXPECT_NEAR(rooms[1]["area"], 12, 1e-6);
  EXPECT_NEAR(rooms[1]["solid"]["volume"], 12 * 2.5, 1e-6);
  std::istringstream table(bytesOf(in("model/rooms.csv")));
  std::string row;
  std::getline(table, row);
  EXPECT_EQ(row.find("room,name,storey,area_m2,"), 0u);
  for (const Json& room : rooms) {
    std::getline(table, row);
    std::vector<std::string> fields;
    boost::split(fields, row, boost::is_any_of(","));
    for (const auto& [column, name] : {std::pair(0, "id"),
                                       {3, "area"},
                                       {6, "perimeter"},
                                       {7, "height"},
                                       {10, "volume"}})
      EXPECT_NEAR(std::stod(fields.at(column)), room[name], 0.0006) << name;
  }
  EXPECT_TRUE(says(bytesOf(in("model/rooms.csv")), "2,Küche,storey 1,12.000,"));
  EXPECT_TRUE(says(bytesOf(in("model/model.ifc")), "12."));
  EXPECT_TRUE(says(bytesOf(in("model/floorplan.svg")), "12.00 m"));
}

TEST_F(EditedModel, SheetsAndIfcKeepTheTextsOfTheRun)
{
  done(edit({"--name", "2=Hall"}));
  const std::string sheet = bytesOf(in("model/floorplan.svg"));
  for (const char* text : {"Mill Lane 14", "Smith", "P-17", "2024-05-31", "EK"})
    EXPECT_TRUE(says(sheet, ">" + std::string(text) + "<")) << text;
  EXPECT_TRUE(says(sheet, ">A<")) << "where section A-A runs";
  EXPECT_TRUE(says(bytesOf(in("model/section_rooms.svg")), ">Section A-A<"));
  EXPECT_TRUE(
      says(bytesOf(in("model/model.ifc")), "('P-17.ifc','2024-05-31T00:00:00',('EK')"));
}

TEST_F(EditedModel, WhatWasToldOfUntouchedRoomsAndWallsStays)
{
  done(edit({"--move-wall", "2.2=0.5"}));
  const Json report = reportNow();
  EXPECT_EQ(report["rooms"][0]["mesh"], "of 1");
  EXPECT_TRUE(report["rooms"][1]["mesh"].is_null());
  ASSERT_EQ(report["walls"].size(), 1u);
  EXPECT_EQ(report["walls"][0]["room"], 1);
  std::vector<std::string> texts = doubts();
  ASSERT_FALSE(texts.empty());
  EXPECT_EQ(texts[0].find("the plan was edited by hand: wall 2.2 is moved"), 0u);
  texts.erase(texts.begin());
  EXPECT_EQ(texts,
            (std::vector<std::string>{"of all", "wall 1.3: off", "room 1: low",
                                      "room 2: low (before the plan was edited)"}));
  std::vector<std::string> subjects;
  for (const Json& doubt : report["doubts"])
    subjects.push_back(doubt["subject"]);
  for (const char* const subject : {"wall 1.3", "room 1", "room 2"})
    EXPECT_EQ(std::count(subjects.begin(), subjects.end(), subject), 1) << subject;
  EXPECT_TRUE(report["verdict"].contains("text"));
}

TEST_F(EditedModel, ARoomOfAnotherHeightIsNotTheOneThatWasMeasured)
{
  done(edit({"--ceiling", "1=2.4"}));
  const Json rooms = reportNow()["rooms"];
  EXPECT_TRUE(rooms[0]["mesh"].is_null());
  EXPECT_EQ(rooms[0]["inferred_floor"], 0);
  EXPECT_EQ(rooms[0]["inferred_ceiling"], 1);
  EXPECT_EQ(rooms[1]["mesh"], "of 2");
  EXPECT_EQ(doubts()[3], "room 1: low (before the plan was edited)");
}

TEST_F(EditedModel, DoubtsOfWallsFollowTheirNumbers)
{
  done(edit({"--split", "1,2,-9,2,9"}));
  EXPECT_EQ(pcl::sedr::tools::loadPlan(in("model/floorplan.json")).plan.rooms.size(),
            3U);
  EXPECT_EQ(reportNow()["warnings"].size(), 5u) << "1.3 was cut: its doubt goes";
  done(edit({"--merge", "3,2"}));
  const Json report = reportNow();
  const auto doubt =
      std::find_if(report["warnings"].begin(), report["warnings"].end(),
                   [](const Json& warning) { return warning["wall"] != 0; });
  ASSERT_NE(doubt, report["warnings"].end());
  EXPECT_EQ((*doubt)["room"], 3);
  EXPECT_EQ((*doubt)["text"],
            "wall 3." + std::to_string((*doubt)["wall"].get<int>()) + ": off");
  EXPECT_EQ(report["edits"].size(), 2u);
}

TEST_F(EditedModel, ADoubtAboutRoomsGoesWhenTheyAreMergedOrSplit)
{
  Json report = reportNow();
  report["warnings"] = {{{"kind", "one_room"}, {"room", 1}, {"values", {3, 40, 2}}},
                        {{"kind", "two_rooms"}, {"room", 2}, {"values", {3, 40}}}};
  writeFile(in("model/report.json"), report.dump());
  const auto doubted = [this] {
    std::string kinds;
    const Json now = reportNow();
    for (const Json& doubt : now["warnings"])
      if (doubt["kind"] != "edited")
        kinds += doubt["kind"].get<std::string>() + " " + doubt["room"].dump() + ",";
    return kinds;
  };
  done(edit({"--ceiling", "1=2.4"}));
  EXPECT_EQ(doubted(), "one_room 1,two_rooms 2,") << "as they were";
  done(edit({"--split", "1,2,-9,2,9"}));
  EXPECT_EQ(doubted(), "one_room 1,two_rooms 2,") << "another was split";
  done(edit({"--undo"}));
  done(edit({"--split", "2,6,-9,6,9"}));
  EXPECT_EQ(doubted(), "one_room 1,");
  done(edit({"--undo"}));
  done(edit({"--merge", "1,2"}));
  EXPECT_EQ(doubted(), "two_rooms 1,") << "of the room that it is a part of now";
}

TEST_F(EditedModel, UndoGoesBackToThePlanAndTheReportBefore)
{
  const std::string plan = bytesOf(in("model/floorplan.json"));
  const auto first = doubts();
  done(edit({"--drop", "1"}));
  const std::string one_room = bytesOf(in("model/floorplan.json"));
  done(edit({"--ceiling", "2=3"}));
  EXPECT_TRUE(has("floorplan.json~") && has("report.json~~"));
  done(edit({"--undo"}));
  EXPECT_EQ(bytesOf(in("model/floorplan.json")), one_room);
  EXPECT_FALSE(has("floorplan.json~~"));
  done(edit({"--undo"}));
  EXPECT_EQ(bytesOf(in("model/floorplan.json")), plan);
  EXPECT_EQ(doubts(), first);
  EXPECT_FALSE(has("floorplan.json~") || has("report.json~"));
  expectSentence(edit({"--undo"}), 1, "no edit to undo");
}

TEST_F(EditedModel, AConfirmedWallIsDoubtedNoMore)
{
  const auto areDoubted = [this](const std::string& wall) {
    const Json report = reportNow();
    return std::count_if(report["doubts"].begin(), report["doubts"].end(),
                         [&](const Json& doubt) { return doubt["subject"] == wall; });
  };
  done(edit({"--name", "1=Hall"}));
  EXPECT_EQ(areDoubted("wall 1.3"), 1);
  done(edit({"--confirm", "1.3"}));
  EXPECT_EQ(areDoubted("wall 1.3"), 0);
  const auto told = doubts();
  EXPECT_EQ(std::count(told.begin(), told.end(), "wall 1.3: off"), 1)
      << "what the scan shows stays";
  done(edit({"--ceiling", "2=3"}));
  EXPECT_TRUE(says(bytesOf(in("model/floorplan.json")), "\"confirmed\""));
}

TEST_F(EditedModel, AfterAnotherRunThereIsNoEditToUndo)
{
  done(edit({"--name", "1=Hall"}));
  // As pcl_sedr keeps it when it writes another one.
  std::filesystem::rename(in("model/floorplan.json"), in("model/floorplan.json~~"));
  SampleResult().writeTo(model());
  const std::string plan = bytesOf(in("model/floorplan.json"));
  expectSentence(edit({"--undo"}), 1, "no edit to undo");
  EXPECT_EQ(bytesOf(in("model/floorplan.json")), plan);
}

TEST_F(EditedModel, ThePageTellsWhatItShowsInPlaceOfTheScan)
{
  writeFile(in("model/report.html"), "of a run");
  EXPECT_FALSE(says(edit({"--name", "1=Hall; 2=Bath"}).err, "in place of the scan"))
      << "it is beside the folder";
  EXPECT_FALSE(says(bytesOf(in("model/report.html")), "floorplan.json~"));
  for (const bool is_other : {true, false}) { // a scan of the name, or none
    if (is_other)
      std::filesystem::copy_file(in("model/structure.pcd"), in("scan.pcd"),
                                 std::filesystem::copy_options::overwrite_existing);
    else
      std::filesystem::remove(in("scan.pcd"));
    const ProgramRun result = done(edit({"--name", "1=Hall; 2=Bath"}));
    EXPECT_TRUE(says(result.err, "the page shows the points of structure.pcd"))
        << is_other;
  }
}

TEST_F(EditedModel, ARefusedEditLeavesTheFolderAsItIs)
{
  const std::string report = bytesOf(in("model/report.json"));
  expectSentence(edit({"--merge", "1,7"}), 1, "no room 7; there are: 1, 2");
  expectSentence(edit({in("x.json"), "--drop", "1"}), 1, "folder");
  EXPECT_EQ(bytesOf(in("model/report.json")), report);
  EXPECT_FALSE(has("floorplan.json~") || has("model.ifc"));
  for (const double other : {-1.0, 1e300}) {
    Json wrong = reportNow();
    wrong["warnings"] = {
        {{"kind", "one_room"}, {"room", 1}, {"values", {3, 40, other}}}};
    writeFile(in("model/report.json"), wrong.dump());
    expectSentence(edit({"--ceiling", "1=2.4"}), 1, "that is no number of a room");
    EXPECT_FALSE(has("floorplan.json~")) << other;
  }
  expectSentence(run(FLOORPLAN_EDIT, {in("nosuch"), "--drop", "1"}), 1,
                 "there is no folder or floor plan");
  std::filesystem::remove(in("model/report.json"));
  expectSentence(edit({"--drop", "1"}), 1, "no report.json");
}

} // namespace
