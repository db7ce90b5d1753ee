// SPDX-License-Identifier: BSD-3-Clause
#include "compare_plans.h"
#include "tools/in_folder.h"
#include "tools/sample_files.h"

#include <pcl/sedr_filters/floorplan_io.h>

#include <nlohmann/json.hpp>

namespace {

using namespace programs;
using namespace pcl::sedr;
using namespace pcl::sedr::tools;
using namespace sedr_test;

/** Runs the program on plans. */
class CompareTool : public InFolder<> {
protected:
  std::string plan(const std::string& name, const Floorplan& plan) const
  {
    writeFile(in(name), floorplanToJson(plan));
    return in(name);
  }
};

TEST_F(CompareTool, WritesJson)
{
  Floorplan before = twoRooms();
  before.rooms[1].columns.push_back(columnLoop(7, 2, 7.5, 2.4));
  const ProgramRun result = done(
      run(STRUCTURE_COMPARE, {plan("a.json", before), plan("b.json", twoRooms(5.3)),
                              "--json", in("d.json")}));
  EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'), 2);
  const auto json = nlohmann::json::parse(bytesOf(in("d.json")));
  ASSERT_EQ(json.at("changes").size(), 2u);
  EXPECT_EQ(json.at("changes")[0].at("shift")[0], 0.3);
}

TEST_F(CompareTool, CountsBothModelsFromOneOrigin)
{
  const Eigen::Vector3d far(5000, 4000, 100);
  writeFile(in("b.json"), documentToJson({twoRooms(), Origin{far}}));
  const ProgramRun result =
      done(run(STRUCTURE_COMPARE,
               {plan("a.json", pcl::sedr::moved(twoRooms(), 0, far)), in("b.json")}));
  EXPECT_EQ(
      result.out,
      "nothing has changed by more than 0.05 m; widths of openings are not compared\n");
}

TEST_F(CompareTool, WarnsOfAModelInAnotherFrameButNotOfWallsThatMoved)
{
  const std::string before = plan("a.json", twoRooms());
  const auto toldOf = [&](const Floorplan& after) {
    return done(run(STRUCTURE_COMPARE, {before, plan("b.json", after)})).err;
  };
  for (const Eigen::Vector3d& by :
       {Eigen::Vector3d(0.3, -0.2, 0), Eigen::Vector3d(0.3, 0, 0)}) {
    const std::string text = toldOf(pcl::sedr::moved(twoRooms(), 0, by));
    EXPECT_NE(text.find(by.y() < 0 ? "shifted by (0.30, -0.20) m" : "(0.30, 0.00) m"),
              std::string::npos)
        << text;
  }
  EXPECT_NE(toldOf(pcl::sedr::moved(twoRooms(), 0, {20, 0, 0}))
                .find("2 of 2 rooms have vanished, and of 2 rooms after 2 were not"),
            std::string::npos);
  EXPECT_EQ(toldOf(twoRooms(5.3)), "") << "a partition that moved";
  EXPECT_EQ(toldOf(twoRooms()), "");
}

TEST_F(CompareTool, RefusesWhatIsNoModel)
{
  const std::string good = plan("a.json", twoRooms());
  const std::vector<std::vector<std::string>> refused{
      {good},
      {good, in("missing.json")},
      {good, folder_.path().string()},
      {good, good, "--scan", "2"},
      {good, good, "--picture", in("d.obj")}};
  for (const auto& arguments : refused) {
    const ProgramRun result = run(STRUCTURE_COMPARE, arguments);
    expectSentence(result, 1);
  }
  const ProgramRun same = done(run(STRUCTURE_COMPARE, {good, good}));
  EXPECT_EQ(
      same.out,
      "nothing has changed by more than 0.05 m; widths of openings are not compared\n");
}

TEST_F(CompareTool, NamesExactlyWhatChangedBetweenTwoScans)
{
  for (const std::string name : {"before", "after"}) {
    done(run(SIMULATE_INDOOR_SCAN,
             {DOC_FOLDER + std::string("/scenes/office_") + name + ".json", in(name),
              "--rays", "120000"}));
    ASSERT_EQ(
        run(SEDR, {in(name + "/scan.pcd"), in(name + "/model"), "--no-mesh"}).exit_code,
        0);
  }
  const ProgramRun result =
      done(run(STRUCTURE_COMPARE,
               {in("before/model"), in("after/model"), "--json", in("changes.json")}));
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
