// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/table/csv_file.h"
#include "tools/option_help.h"
#include "tools/run_program.h"
#include "tools/sample_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace {

using namespace programs;
using pcl::sedr::benchmark::linesToContinue;
using Strings = std::vector<std::string>;

class BenchmarkTools : public ::testing::Test {
protected:
  std::string in(const std::string& name) const
  {
    return (folder_.path() / name).string();
  }

  /** Runs of the simplest scene, with few rays. */
  ProgramRun bench(const Strings& more)
  {
    Strings arguments{"--scenes", "bls_room", "--no-mesh", "--rays", "4000"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(SEDR_BENCHMARK, arguments);
  }

  static void
  expectRefused(const std::string& program, const Strings& arguments, const char* words)
  {
    const ProgramRun result = run(program, arguments);
    EXPECT_EQ(result.exit_code, 1) << words;
    EXPECT_TRUE(result.failsInOneSentence()) << result.out << result.err;
    EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
  }

  TemporaryFolder folder_;
};

TEST_F(BenchmarkTools, runs_scenes_and_resumes)
{
  const Strings one{"--noise", "0.005", "--seeds", "1", "--csv", in("a.csv")};
  ASSERT_EQ(bench(one).exit_code, 0);
  ASSERT_EQ(linesToContinue(in("a.csv")).size(), 1u);
  EXPECT_EQ(linesToContinue(in("a.csv"))[0].rfind("bls_room,0.005,1,0,", 0), 0u);

  const ProgramRun resumed =
      bench({"--noise", "0.005", "--seeds", "1,2", "--csv", in("a.csv"), "--resume"});
  ASSERT_EQ(resumed.exit_code, 0) << resumed.err;
  EXPECT_EQ(resumed.out.rfind("bls_room          0.50 cm  seed 2   1/1 rooms", 0), 0u)
      << resumed.out;
  EXPECT_EQ(std::count(resumed.out.begin(), resumed.out.end(), '\n'), 1);
  EXPECT_EQ(linesToContinue(in("a.csv")).size(), 2u);
}

TEST_F(BenchmarkTools, shares_runs_between_processes)
{
  for (const std::string part : {"1", "2"}) {
    const std::string csv = in(part + ".csv");
    ASSERT_EQ(bench({"--noise", "0.002,0.005", "--seeds", "1", "--csv", csv, "--part",
                     part + "/2"})
                  .exit_code,
              0);
    const Strings lines = linesToContinue(csv);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_EQ(lines[0].rfind(part == "1" ? "bls_room,0.002," : "bls_room,0.005,", 0),
              0u);
  }
}

TEST_F(BenchmarkTools, a_run_that_fails_does_not_stop_the_others)
{
  const ProgramRun result =
      run(SEDR_BENCHMARK, {"--scenes", "bls_room", "--no-mesh", "--rays", "1",
                           "--noise", "0.001", "--seeds", "1,2", "--csv", in("a.csv")});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const Strings lines = linesToContinue(in("a.csv"));
  ASSERT_EQ(lines.size(), 2u);
  for (const std::string& line : lines)
    EXPECT_NE(line.find(",failed,failed"), std::string::npos) << line;
  EXPECT_NE(result.out.find("failed: "), std::string::npos);
}

TEST_F(BenchmarkTools, bad_use_is_told_before_the_work)
{
  expectRefused(SEDR_BENCHMARK, {"--scenes", "no_such_scene"}, "no_such_scene");
  expectRefused(SEDR_BENCHMARK, {"--noise", "much"}, "--noise");
  expectRefused(SEDR_BENCHMARK, {"--seeds", "-1"}, "--seeds");
  expectRefused(SEDR_BENCHMARK, {"--part", "3/2"}, "--part");
  expectRefused(SEDR_BENCHMARK, {"--resume"}, "--csv");
  expectRefused(SEDR_BENCHMARK, {"--csv", in("no/folder.csv")}, "folder.csv");
  writeFile(in("other.csv"), "scene,colour\nattic,blue\n");
  expectRefused(SEDR_BENCHMARK, {"--csv", in("other.csv")}, "other columns");
}

TEST_F(BenchmarkTools, help_tells_every_option_with_its_default)
{
  for (const char* program : {SEDR_BENCHMARK, LABEL_EVALUATION}) {
    const ProgramRun help = run(program, {"-h"});
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_FALSE(optionsIn(help.out).empty());
    for (const OptionHelp& option : optionsIn(help.out))
      EXPECT_TRUE(option.tellsDefault()) << option.name;
  }
}

TEST_F(BenchmarkTools, labels_are_scored_by_the_nearest_point)
{
  writeFile(in("structure.pcd"),
            pcdBytes({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {1, 2, 5}));
  writeFile(in("scan.pcd"),
            pcdBytes({{0, 0, 0.01f}, {1, 0, 0.01f}, {1, 0, 0.06f}, {2, 0, 0.01f}},
                     {0, 1, 12, 7}));
  const ProgramRun result = run(
      LABEL_EVALUATION, {in("structure.pcd"), in("scan.pcd"), "--map", "0=1,1=2,7=3"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto line = [&result](const std::string& start) {
    const std::size_t at = result.out.find("\n" + start);
    std::istringstream words(
        at == std::string::npos ? "" : result.out.substr(at + 1 + start.size()));
    Strings cells(5);
    for (std::string& cell : cells)
      words >> cell;
    return cells;
  };
  // true, predicted, recall, precision, precision of the structure's points
  EXPECT_EQ(line("ceiling"), (Strings{"1", "1", "100.00", "100.00", "100.00"}));
  EXPECT_EQ(line("floor"), (Strings{"1", "2", "100.00", "50.00", "100.00"}));
  EXPECT_EQ(line("wall"), (Strings{"1", "1", "100.00", "100.00", "100.00"}));
  // other, ceiling, floor, wall, detail
  EXPECT_EQ(line("12 "), (Strings{"0", "0", "1", "0", "0"}));
}

TEST_F(BenchmarkTools, surfaces_without_normals_are_refused)
{
  writeFile(in("structure.pcd"), pcdBytes({{0, 0, 0}}, {1}));
  const ProgramRun result =
      run(LABEL_EVALUATION,
          {in("structure.pcd"), in("structure.pcd"), "--off-surface", "0.01"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.err.find("has no field 'normal_x'"), std::string::npos)
      << result.err;
}

TEST_F(BenchmarkTools, label_evaluation_refuses_what_it_cannot_score)
{
  writeFile(in("labelled.pcd"), pcdBytes({{0, 0, 0}}, {9}));
  writeFile(in("bare.pcd"), pcdBytes({{0, 0, 0}}));
  const auto refused = [this](const Strings& arguments, const char* words) {
    expectRefused(LABEL_EVALUATION, arguments, words);
  };
  refused({in("bare.pcd"), in("labelled.pcd")}, "no field 'label'");
  refused({in("labelled.pcd"), in("bare.pcd")}, "no field 'label'");
  refused({in("labelled.pcd"), in("missing.pcd")}, "missing.pcd");
  refused({in("labelled.pcd"), in("labelled.pcd"), "--map", "9"}, "--map");
  refused({in("labelled.pcd"), in("labelled.pcd"), "--radius", "0"}, "--radius");
  const ProgramRun result =
      run(LABEL_EVALUATION, {in("labelled.pcd"), in("labelled.pcd")});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_TRUE(result.failsInOneSentence()) << result.err;
}

} // namespace
