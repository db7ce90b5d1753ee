// SPDX-License-Identifier: BSD-3-Clause
#include "in_folder.h"
#include "plan_file.h"
#include "sample_files.h"
#include "tool_error.h"
#include "two_storeys.h"

#include <pcl/sedr_filters/floorplan_io.h>
#include <pcl/sedr_filters/plan_measures.h>

// The output of the tools is checked by test_floorplan_outputs.py.

namespace {

using namespace programs;
using namespace sedr_test;
using Strings = std::vector<std::string>;

/** A program that converts PLAN.json into one file, and names of such files. */
struct Converter {
  std::string program;
  Strings outputs;
};

std::ostream&
operator<<(std::ostream& stream, const Converter& converter)
{
  return stream << std::filesystem::path(converter.program).filename();
}

class FloorplanTools : public InFolder<::testing::TestWithParam<Converter>> {
protected:
  const std::string& program() const { return GetParam().program; }
  const std::string& output() const { return GetParam().outputs[0]; }

  std::string plan(const pcl::sedr::Floorplan& floorplan) const
  {
    writeFile(in("plan.json"), pcl::sedr::floorplanToJson(floorplan));
    return in("plan.json");
  }

  std::string goodPlan() const { return plan({{roomOf(rectangle(0, 0, 5, 4), 2.5)}}); }
};

INSTANTIATE_TEST_SUITE_P(
    Tools,
    FloorplanTools,
    ::testing::Values(Converter{FLOORPLAN_EXTRUSION,
                                {"solid.ply", "solid.obj", "solid.glb"}},
                      Converter{FLOORPLAN_DRAWING, {"plan.svg", "plan.dxf"}}));

TEST_P(FloorplanTools, QuietWhenAllIsWellAndTheSameBytesTwice)
{
  for (const std::string& name : GetParam().outputs) {
    std::string first;
    for (int k = 0; k < 2; ++k) {
      const ProgramRun result = done(run(program(), {goodPlan(), in(name)}));
      EXPECT_EQ(result.out + result.err, "");
      EXPECT_TRUE(k == 0 || bytesOf(in(name)) == first);
      first = bytesOf(in(name));
    }
    EXPECT_NE(first, "");
  }
}

TEST_P(FloorplanTools, OfPlansWithoutRoomsTheOldFileStays)
{
  writeFile(in(output()), "old");
  expectSentence(run(program(), {plan({}), in(output())}), 2);
  EXPECT_EQ(bytesOf(in(output())), "old");
  expectSentence(run(program(), {goodPlan(), in("output.txt")}), 1);
  expectSentence(run(program(), {goodPlan(), in("no_folder/" + output())}), 1);
}

using FloorplanExtrusionTool = InFolder<>;

TEST_F(FloorplanExtrusionTool, ContradictionsAreTold)
{
  pcl::sedr::PlanRoom room = roomOf(rectangle(0, 0, 5, 4), 2.5);
  room.details.push_back(detailOf(rectangle(0, 0, 1, 1), -1));
  writeFile(in("plan.json"), pcl::sedr::floorplanToJson({{room}}));
  const ProgramRun result =
      done(run(FLOORPLAN_EXTRUSION, {in("plan.json"), in("solid.ply")}));
  EXPECT_TRUE(says(result.err, "warning: room 1: a part of its ceiling around (0.5, "));
}

TEST_F(FloorplanExtrusionTool, ARoomThatCannotBeBuiltIsTold)
{
  const std::string file = in("plan.json");
  const std::string solid = in("solid.ply");
  const auto good = roomOf(rectangle(0, 0, 5, 4), 2.5, 1);
  auto bad = roomOf(rectangle(6, 0, 9, 4), 2.5, 2);
  bad.columns = {reversed(rectangle(6, 0, 9, 4))};
  writeFile(file, pcl::sedr::floorplanToJson({{good, bad}}));
  ProgramRun result = done(run(FLOORPLAN_EXTRUSION, {file, solid}));
  EXPECT_TRUE(says(result.err, "room 2"));
  EXPECT_TRUE(std::filesystem::exists(solid));
  writeFile(file, pcl::sedr::floorplanToJson({{bad}}));
  std::filesystem::remove(solid);
  result = run(FLOORPLAN_EXTRUSION, {file, solid});
  expectSentence(result, 2);
  EXPECT_FALSE(std::filesystem::exists(solid));
}

/** Runs pcl_floorplan_drawing on a plan of two storeys. */
class StoreyDrawings : public InFolder<> {
protected:
  ProgramRun draw(const Strings& options) const
  {
    return run(FLOORPLAN_DRAWING, {in("plan.json"), in("out.svg")}, options);
  }

  bool has(const std::string& name) const { return std::filesystem::exists(in(name)); }

  void SetUp() override
  {
    writeFile(in("plan.json"), pcl::sedr::floorplanToJson(twoStoreys()));
  }
};

TEST_F(StoreyDrawings, AreOneAStoreyWithItsNumber)
{
  done(draw({}));
  EXPECT_TRUE(has("out_1.svg") && has("out_2.svg"));
  EXPECT_FALSE(has("out.svg"));
  EXPECT_TRUE(says(bytesOf(in("out_2.svg")), "Room 4"));
  EXPECT_FALSE(says(bytesOf(in("out_2.svg")), "Room 1"));
}

TEST_F(StoreyDrawings, OfOneThatIsAskedForHaveTheNameAsGiven)
{
  done(draw({"--storey", "2"}));
  EXPECT_TRUE(has("out.svg"));
  EXPECT_FALSE(has("out_1.svg") || has("out_2.svg"));
  EXPECT_TRUE(says(bytesOf(in("out.svg")), ">storey 2<"));
}

TEST_F(StoreyDrawings, SectionsAndElevationsAreDrawnInstead)
{
  done(draw({"--section", "rooms"}));
  EXPECT_TRUE(says(bytesOf(in("out.svg")), "Room 4"));
  done(draw({"--section", "0,1,9,1.5"}));
  EXPECT_TRUE(says(bytesOf(in("out.svg")), "0.00, 1.00 and 9.00, 1.50"));
  done(draw({"--elevations", "3"}));
  EXPECT_TRUE(says(bytesOf(in("out.svg")), ">3.1<"));
  for (const Strings& wrong :
       {Strings{"--section", "stairs"}, Strings{"--section", "1,2,1,2"},
        Strings{"--section", "1,2,3"}, Strings{"--section", "50,50,51,50"},
        Strings{"--elevations", "9"}})
    EXPECT_EQ(draw(wrong).exit_code, 1) << wrong[1];
}

TEST_F(StoreyDrawings, ElevationsHatchWhatTheReportBesideThePlanDidNotSee)
{
  const auto drawn = [&] {
    done(run(FLOORPLAN_DRAWING,
             {in("floorplan.json"), in("out.dxf"), "--elevations", "1"}));
    std::string dxf = bytesOf(in("out.dxf"));
    return dxf.find("\n8\nA-WALL-UNSN\n") != std::string::npos;
  };
  std::filesystem::rename(in("plan.json"), in("floorplan.json"));
  EXPECT_FALSE(drawn());
  const auto reportWith = [&](const char* cells) {
    writeFile(in("report.json"),
              std::string("{\"format\": \"sedr-report\", \"walls\": [{\"room\": 1, "
                          "\"walls\": [1], \"base\": 0, \"cell\": 1, \"columns\": 4, "
                          "\"rows\": 2, \"cells\": \"") +
                  cells + "\"}]}");
  };
  reportWith("8s");
  EXPECT_FALSE(drawn());
  reportWith("5s1h2s");
  EXPECT_TRUE(drawn());
}

TEST_F(StoreyDrawings, OfOneThatIsNotThereAreRefused)
{
  expectSentence(draw({"--storey", "9"}), 1,
                 "the plan has no storey 9; there are: 1, 2");
  pcl::sedr::Floorplan plan = twoStoreys();
  plan.storeys = storeysOf(plan);
  plan.rooms.erase(plan.rooms.begin(), plan.rooms.begin() + 2); // the lower storey
  writeFile(in("plan.json"), pcl::sedr::floorplanToJson(plan));
  expectSentence(draw({"--storey", "1"}), 1, "the plan has no storey 1; there are: 2");
  expectSentence(draw({"--elevations", "1"}), 1,
                 "the plan has no room 1; there are: 3, 4");
  EXPECT_FALSE(has("out.svg"));
  done(draw({"--storey", "2"}));
}

TEST_F(StoreyDrawings, OfHundredsOfRoomsAreMade)
{
  pcl::sedr::Floorplan plan;
  for (std::uint32_t k = 0; k < 500; ++k) {
    const double x = 4.1 * (k % 25);
    const double y = 3.1 * (k / 25);
    plan.rooms.push_back(roomOf(rectangle(x, y, x + 4, y + 3), 2.5, k + 1));
  }
  writeFile(in("plan.json"), pcl::sedr::floorplanToJson(plan));
  done(draw({})); // within a minute
  EXPECT_TRUE(says(bytesOf(in("out.svg")), "id=\"room_500\""));
}

TEST_F(StoreyDrawings, OfARoomThatCrossesItselfAreDoubted)
{
  EXPECT_EQ(draw({}).err, "");
  pcl::sedr::Floorplan plan;
  plan.rooms = {roomOf(rectangle(0, 0, 5, 4), 2.5, 7)};
  std::vector<pcl::sedr::PlanElement>& walls = plan.rooms[0].boundary.elements;
  walls[0].end = walls[1].start = {1, 4.5}; // across the opposite wall
  writeFile(in("plan.json"), pcl::sedr::floorplanToJson(plan));
  const ProgramRun result = draw({});
  EXPECT_TRUE(
      says(result.err,
           "outlines cannot be right (rooms: 1), that of room 7 crosses itself near"));
}

TEST_F(StoreyDrawings, OfRoomsAndColumnsAtOnePlaceAreDoubted)
{
  pcl::sedr::Floorplan plan;
  plan.rooms = {roomOf(rectangle(0, 0, 6, 4), 2.5, 7),
                roomOf(rectangle(2, 1, 4, 3), 2, 8),
                roomOf(rectangle(0, 0, 6, 4), 5, 9)};
  plan.rooms[2].floor = slabAt(2.8);
  plan.rooms.push_back(roomOf(rectangle(5, 3, 6, 4), 1, 10));
  for (const double x : {0.5, 1.0, 5.5})
    plan.rooms[0].columns.push_back(reversed(rectangle(x, 1, x + 1, 2)));
  plan.rooms[1].columns = {reversed(rectangle(3, 2, 3.5, 2.5))};
  writeFile(in("plan.json"), pcl::sedr::floorplanToJson(plan));
  const std::string told = draw({}).err;
  EXPECT_TRUE(says(
      told, "rooms overlap by 8.5 m3 (places: 2), most room 7 and room 8 by 7.5 m3",
      "columns reach out of their room by 0.5 m2 (places: 1), most "
      "column 3 of room 7 by 0.5 m2",
      "columns overlap by 0.5 m2 (places: 1), most column 1 of room "
      "7 and its column 2 by 0.5 m2"));
  EXPECT_EQ(std::count(told.begin(), told.end(), '\n'), 3) << told;
}

TEST_F(StoreyDrawings, HaveTheTextsOfTheReportBesideThePlanUnlessOthersAreGiven)
{
  std::filesystem::rename(in("plan.json"), in("floorplan.json"));
  writeFile(in("report.json"), "{\"format\": \"sedr-report\", \"parameters\": "
                               "{\"client\": \"Smith\", \"drawn_by\": \"EK\"}}");
  done(run(FLOORPLAN_DRAWING, {in("floorplan.json"), in("out.svg"), "--storey", "1",
                               "--drawn-by", "Lee"}));
  const std::string svg = bytesOf(in("out.svg"));
  EXPECT_TRUE(says(svg, "Smith", "Lee"));
  EXPECT_FALSE(says(svg, "EK"));
}

TEST_F(StoreyDrawings, PointsAreOfTheRoomAtTheirHeight)
{
  const std::vector<std::vector<float>> points{
      {1, 1, 0}, {1, 1, 2.5F}, {1, 1, 2.8F}, {1, 1, 5.2F}, {4.1F, 1, 1}, {4.1F, 1, 4}};
  writeFile(in("points.pcd"), pcdBytes(points, std::vector<std::uint32_t>(6, 3)));
  pcl::sedr::tools::ToolCloud cloud = pcl::sedr::tools::loadCloud(in("points.pcd"));
  pcl::sedr::tools::giveRooms(twoStoreys(), cloud);
  EXPECT_EQ(cloud.room, (std::vector<std::uint32_t>{1, 1, 3, 3, 2, 4}));
}

using FloorplanEditTool = InFolder<>;

TEST_F(FloorplanEditTool, AppliesEveryEditOrWritesNothing)
{
  const std::string plan = in("plan.json");
  const std::string output = in("edited.json");
  pcl::sedr::Floorplan of_room{{roomOf(rectangle(0, 0, 5, 4), 2.5)}};
  for (const double x : {3.0, 4.0})
    of_room.openings.push_back(openingOf(pcl::sedr::OpeningKind::Door, {1, 0}, {{1, 0}},
                                         {x - 0.4, -0.1}, {x + 0.4, -0.1}, 0, 2, 0.2));
  writeFile(plan, pcl::sedr::floorplanToJson(of_room));
  const ProgramRun result =
      done(run(FLOORPLAN_EDIT, {plan, output, "--move-wall", "1.2=-0.5", "--split",
                                "1,2,-1,2,5", "--name", "1=Kitchen;2=a=b, c",
                                "--opening", "D1,kind=none;D2,kind=window,sill=0.3"}));
  EXPECT_TRUE(says(result.out,
                   "wall 1.2 is moved inwards by 0.500 m; room 1 has 18.00 m2 "
                   "in place of 20.00\n"));
  const auto edited = pcl::sedr::tools::loadPlan(output).plan;
  ASSERT_EQ(edited.rooms.size(), 2U);
  EXPECT_NEAR(edited.rooms[0].area() + edited.rooms[1].area(), 4.5 * 4, 1e-9);
  ASSERT_EQ(edited.openings.size(), 1U);
  EXPECT_EQ(edited.openings[0].kind, pcl::sedr::OpeningKind::Window);
  EXPECT_EQ(edited.rooms[0].name + "|" + edited.rooms[1].name, "Kitchen|a=b, c");
  std::filesystem::remove(output);
  for (const auto& [option, values] : std::vector<std::pair<std::string, Strings>>{
           {"--move-wall", {"1.2", "1.2=0.1m", "1.-2=0.05"}},
           {"--split", {"1.7", "-1,2,-1,2,5"}},
           {"--drop", {"one", "4294967297"}},
           {"--merge", {"1", "-1,2", "", "1,9"}},
           {"--name", {"Kitchen", "1=K\xfc"}},
           {"--square", {"1,"}},
           {"--opening",
            {"D1", "D1,width", "D1,at=2", "D1,width=0.9m", "D1,kind=gate",
             "D1,hinge=top"}},
           {"--floor", {"1=0.1,0.2", "1", "1=nan"}},
           {"--ceiling", {"1=high"}},
           {"--add-opening", {"1.1,width=0.9,height=2", "1.1,at=2,width=0.9"}},
           {"--remove-jog", {"1"}},
           {"--remove", {"column 1"}},
           {"--storey", {"2.8"}}})
    for (const std::string& value : values) {
      const ProgramRun refused = run(FLOORPLAN_EDIT, {plan, output, option, value});
      expectSentence(refused, 1, option);
      const bool is_of_editor =
          value == "1,9" || value == "D1,hinge=top" || value == "1=K\xfc";
      EXPECT_EQ(refused.err.find(" wants ") == std::string::npos, is_of_editor);
      EXPECT_FALSE(std::filesystem::exists(output));
    }
  expectSentence(run(FLOORPLAN_EDIT, {plan, output}), 1, "no edit");
  expectSentence(run(FLOORPLAN_EDIT, {plan, "--drop", "1"}), 1, "name");
  expectSentence(run(FLOORPLAN_EDIT, {plan, output, "--undo"}), 1, "--undo");
  expectSentence(run(FLOORPLAN_EDIT, {plan, output, "--drop", "1"}), 1, "no room");
  EXPECT_FALSE(std::filesystem::exists(output));
}

} // namespace
