// SPDX-License-Identifier: BSD-3-Clause
#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>

namespace pcl::sedr::sim::test {
namespace {

/** @brief Exit code and output of a run of the program. */
struct Outcome {
  int exit_code = -1;
  std::string output;
  std::string errors;
};

class Program : public testing::Test {
protected:
  Outcome run(const std::string& arguments) const
  {
    const auto output = folder_.path() / "stdout";
    const auto errors = folder_.path() / "stderr";
    const std::string command = std::string(SIMULATOR_PROGRAM) + " " + arguments +
                                " >" + output.string() + " 2>" + errors.string();
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, bytesOf(output),
            bytesOf(errors)};
  }

  std::filesystem::path at(const std::string& name) const
  {
    return folder_.path() / name;
  }

  /** @brief Expects exit code 1 and a single line on stderr that contains @p part. */
  void expectRefused(const std::string& arguments, const std::string& part) const
  {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 1) << arguments;
    EXPECT_NE(outcome.errors.find(part), std::string::npos) << outcome.errors;
    EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1);
    EXPECT_TRUE(outcome.output.empty()) << outcome.output;
  }

  TemporaryFolder folder_;
};

TEST_F(Program, writesScanAndTruthIntoANewFolder)
{
  const Outcome outcome = run("syn_flat " + at("new/sub").string() + " --rays 500");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_TRUE(outcome.errors.empty()) << outcome.errors;
  EXPECT_EQ(bytesOf(at("new/sub/scan.pcd")).rfind("# .PCD", 0), 0U);
  EXPECT_EQ(bytesOf(at("new/sub/truth.ply")).rfind("ply\n", 0), 0U);
  EXPECT_NE(bytesOf(at("new/sub/truth.json")).find("\"sedr-room-truth\""),
            std::string::npos);
  EXPECT_FALSE(bytesOf(at("new/sub/positions.txt")).empty());
  const auto begin = std::filesystem::directory_iterator(at("new/sub"));
  EXPECT_EQ(std::distance(begin, std::filesystem::directory_iterator()), 4);
}

TEST_F(Program, writesTheSameBytesWithOneAndTwoThreads)
{
  run("bls_room " + at("one").string() + " --rays 300 --seed 5 --threads 1");
  run("bls_room " + at("two").string() + " --rays 300 --seed 5 --threads 2");
  run("bls_room " + at("other").string() + " --rays 300 --seed 6 --threads 2");
  const std::string one = bytesOf(at("one/scan.pcd"));
  EXPECT_GT(one.size(), 1000U);
  EXPECT_TRUE(one == bytesOf(at("two/scan.pcd")));
  EXPECT_FALSE(one == bytesOf(at("other/scan.pcd")));
  EXPECT_TRUE(bytesOf(at("one/truth.ply")) == bytesOf(at("two/truth.ply")));
}

TEST_F(Program, listsItsScenesAndOptions)
{
  const Outcome list = run("--list");
  EXPECT_EQ(list.exit_code, 0);
  for (const char* name : {"bls_room", "hls_hall", "syn_flat"})
    EXPECT_NE(list.output.find(name), std::string::npos) << name;
  EXPECT_NE(list.output.find("--noise 0.02"), std::string::npos) << list.output;
  const Outcome help = run("-h");
  EXPECT_EQ(help.exit_code, 0);
  for (const char* name : {"--seed", "--noise", "--rays", "--max-range", "--threads"})
    EXPECT_NE(help.output.find(name), std::string::npos) << name;
}

TEST_F(Program, scansTheFileThatItPrints)
{
  const Outcome print = run("--print closet");
  EXPECT_EQ(print.exit_code, 0);
  std::ofstream(at("mine.json")) << print.output;
  EXPECT_EQ(run("closet " + at("built_in").string() + " --rays 300").exit_code, 0);
  const Outcome own =
      run(at("mine.json").string() + " " + at("own").string() + " --rays 300");
  EXPECT_EQ(own.exit_code, 0) << own.errors;
  const std::string scan = bytesOf(at("built_in/scan.pcd"));
  EXPECT_GT(scan.size(), 1000U);
  EXPECT_TRUE(scan == bytesOf(at("own/scan.pcd")));
  expectRefused("--print no_scene", "no scene 'no_scene'");
}

TEST_F(Program, refusesFaultySceneFilesWithTheirPlace)
{
  const std::string path = at("mine.json").string();
  std::ofstream(path) << R"({"format": "sedr-scene", "version": 1, "name": "a"})";
  expectRefused(path + " " + at("out").string(),
                path + ": the scene lacks \"summary\"");
  const std::string missing = at("none.json").string();
  expectRefused(missing + " " + at("out").string(), missing);
  EXPECT_FALSE(std::filesystem::exists(at("out")));
}

TEST_F(Program, refusesAFolderThatCannotBeWritten)
{
  std::ofstream(at("file")) << "not a folder";
  expectRefused("bls_room " + at("file").string(), at("file").string());
  expectRefused("bls_room " + at("file/below").string(), at("file/below").string());
}

TEST_F(Program, refusesBadOptions)
{
  const std::string start = "bls_room " + at("out").string();
  expectRefused("bls_room", "OUTPUT_DIR");
  expectRefused(start + " surplus", "too many");
  expectRefused(start + " --wrong 1", "--wrong");
  expectRefused(start + " --noise -0.1", "--noise");
  expectRefused(start + " --rays 0", "--rays");
  expectRefused("no_scene " + at("out").string(), "no scene 'no_scene'");
  expectRefused("--print closet " + start, "--print");
  expectRefused("--list " + start, "--list");
  expectRefused(start + " --threads -1", "--threads");
  expectRefused(start + " --seed -1", "--seed");
  expectRefused(start + " --max-range 0", "--max-range");
  EXPECT_FALSE(std::filesystem::exists(at("out")));
}

} // namespace
} // namespace pcl::sedr::sim::test
