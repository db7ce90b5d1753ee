// SPDX-License-Identifier: BSD-3-Clause
#include "says.h"
#include "tools/in_folder.h"

#include <sstream>

namespace {

using programs::bytesOf;

class Program : public programs::InFolder<> {
protected:
  static programs::ProgramRun run(const std::string& arguments)
  {
    std::istringstream words(arguments);
    return programs::run(SIMULATOR_PROGRAM,
                         {std::istream_iterator<std::string>(words), {}});
  }

  static void expectRefused(const std::string& arguments, const std::string& part)
  {
    programs::expectSentence(run(arguments), 1, part);
  }
};

TEST_F(Program, writesScanAndTruthIntoANewFolder)
{
  const auto outcome = done(run("syn_flat " + in("new/sub") + " --rays 500"));
  EXPECT_TRUE(outcome.err.empty()) << outcome.err;
  EXPECT_EQ(bytesOf(in("new/sub/scan.pcd")).rfind("# .PCD", 0), 0U);
  EXPECT_EQ(bytesOf(in("new/sub/truth.ply")).rfind("ply\n", 0), 0U);
  EXPECT_TRUE(says(bytesOf(in("new/sub/truth.json")), "\"sedr-room-truth\""));
  EXPECT_FALSE(bytesOf(in("new/sub/positions.txt")).empty());
  const auto begin = std::filesystem::directory_iterator(in("new/sub"));
  EXPECT_EQ(std::distance(begin, std::filesystem::directory_iterator()), 4);
}

TEST_F(Program, writesTheSameBytesWithOneAndTwoThreads)
{
  run("bls_room " + in("one") + " --rays 300 --seed 5 --threads 1");
  run("bls_room " + in("two") + " --rays 300 --seed 5 --threads 2");
  run("bls_room " + in("other") + " --rays 300 --seed 6 --threads 2");
  const std::string one = bytesOf(in("one/scan.pcd"));
  EXPECT_GT(one.size(), 1000U);
  EXPECT_TRUE(one == bytesOf(in("two/scan.pcd")));
  EXPECT_FALSE(one == bytesOf(in("other/scan.pcd")));
  EXPECT_TRUE(bytesOf(in("one/truth.ply")) == bytesOf(in("two/truth.ply")));
}

TEST_F(Program, listsItsScenes)
{
  const auto list = done(run("--list"));
  EXPECT_TRUE(says(list.out, "bls_room", "hls_hall", "syn_flat", "--noise 0.02"));
}

TEST_F(Program, scansTheFileThatItPrints)
{
  const auto print = done(run("--print closet"));
  std::ofstream(in("mine.json")) << print.out;
  done(run("closet " + in("built_in") + " --rays 300"));
  const auto own = done(run(in("mine.json") + " " + in("own") + " --rays 300"));
  const std::string scan = bytesOf(in("built_in/scan.pcd"));
  EXPECT_GT(scan.size(), 1000U);
  EXPECT_TRUE(scan == bytesOf(in("own/scan.pcd")));
  expectRefused("--print no_scene", "no scene 'no_scene'");
}

TEST_F(Program, refusesFaultySceneFilesWithTheirPlace)
{
  const std::string path = in("mine.json");
  std::ofstream(path) << R"({"format": "sedr-scene", "version": 1, "name": "a"})";
  expectRefused(path + " " + in("out"), path + ": the scene lacks \"summary\"");
  const std::string missing = in("none.json");
  expectRefused(missing + " " + in("out"), missing);
  EXPECT_FALSE(std::filesystem::exists(in("out")));
}

TEST_F(Program, refusesAFolderThatCannotBeWritten)
{
  std::ofstream(in("file")) << "not a folder";
  expectRefused("bls_room " + in("file"), in("file"));
  expectRefused("bls_room " + in("file/below"), in("file/below"));
}

TEST_F(Program, refusesScenesThatItLacksAndListsBesideAScan)
{
  const std::string start = "bls_room " + in("out");
  expectRefused("no_scene " + in("out"), "no scene 'no_scene'");
  expectRefused("--print closet " + start, "--print");
  expectRefused("--list " + start, "--list");
  EXPECT_FALSE(std::filesystem::exists(in("out")));
}

} // namespace
