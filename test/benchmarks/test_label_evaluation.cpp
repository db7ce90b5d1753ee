// SPDX-License-Identifier: BSD-3-Clause
#include "tools/option_help.h"
#include "tools/run_program.h"
#include "tools/sample_files.h"

#include <gtest/gtest.h>

#include <limits>
#include <sstream>
#include <utility>

namespace {

using namespace programs;
using Strings = std::vector<std::string>;

class LabelEvaluation : public ::testing::Test {
protected:
  std::string in(const std::string& name) const
  {
    return (folder_.path() / name).string();
  }

  /** Returns the five cells after the start of a line of the output. */
  static Strings cellsAfter(const std::string& start, const ProgramRun& run)
  {
    const std::size_t at = run.out.find("\n" + start);
    std::istringstream words(
        at == std::string::npos ? "" : run.out.substr(at + 1 + start.size()));
    Strings cells(5);
    for (std::string& cell : cells)
      words >> cell;
    return cells;
  }

  TemporaryFolder folder_;
};

TEST_F(LabelEvaluation, help_tells_every_option_with_its_default)
{
  const ProgramRun help = run(LABEL_EVALUATION, {"-h"});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_FALSE(optionsIn(help.out).empty());
  for (const OptionHelp& option : optionsIn(help.out))
    EXPECT_TRUE(option.tellsDefault()) << option.name;
}

TEST_F(LabelEvaluation, labels_are_scored_by_the_nearest_point)
{
  writeFile(in("structure.pcd"),
            pcdBytes({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {1, 2, 5}));
  writeFile(in("scan.pcd"),
            pcdBytes({{0, 0, 0.01f}, {1, 0, 0.01f}, {1, 0, 0.06f}, {2, 0, 0.01f}},
                     {0, 1, 12, 7}));
  const ProgramRun result = run(
      LABEL_EVALUATION, {in("structure.pcd"), in("scan.pcd"), "--map", "0=1,1=2,7=3"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  // true, predicted, recall, precision, precision of the structure's points
  EXPECT_EQ(cellsAfter("ceiling", result),
            (Strings{"1", "1", "100.00", "100.00", "100.00"}));
  EXPECT_EQ(cellsAfter("floor", result),
            (Strings{"1", "2", "100.00", "50.00", "100.00"}));
  EXPECT_EQ(cellsAfter("wall", result),
            (Strings{"1", "1", "100.00", "100.00", "100.00"}));
  // other, ceiling, floor, wall, detail
  EXPECT_EQ(cellsAfter("12 ", result), (Strings{"0", "0", "1", "0", "0"}));
}

TEST_F(LabelEvaluation, a_scan_is_thinned_to_one_point_in_two_centimetres)
{
  writeFile(in("structure.pcd"), pcdBytes({{0, 0, 0}, {1, 0, 0}}, {1, 2}));
  // Three points in one cube, and one that is near no point of the structure.
  writeFile(in("scan.pcd"),
            pcdBytes({{0.001f, 0, 0}, {0.002f, 0, 0}, {0.003f, 0, 0}, {0.5f, 0, 0}},
                     {1, 1, 1, 1}));
  const ProgramRun result =
      run(LABEL_EVALUATION, {in("structure.pcd"), in("scan.pcd")});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(cellsAfter("ceiling", result),
            (Strings{"2", "1", "50.00", "100.00", "100.00"}));
}

TEST_F(LabelEvaluation, points_too_far_off_the_surface_are_other)
{
  writeFile(in("structure.pcd"),
            "VERSION 0.7\nFIELDS x y z normal_x normal_y normal_z label\n"
            "SIZE 4 4 4 4 4 4 4\nTYPE F F F F F F U\nCOUNT 1 1 1 1 1 1 1\nWIDTH 2\n"
            "HEIGHT 1\nPOINTS 2\nDATA ascii\n0 0 0 0 0 1 1\n1 0 0 0 0 1 1\n");
  writeFile(in("scan.pcd"), pcdBytes({{0.03f, 0, 0}, {1, 0, 0.03f}}, {1, 1}));
  const auto recall = [this](const Strings& more) {
    Strings arguments{in("structure.pcd"), in("scan.pcd")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return cellsAfter("ceiling", run(LABEL_EVALUATION, arguments))[2];
  };
  EXPECT_EQ(recall({}), "100.00");
  EXPECT_EQ(recall({"--off-surface", "0.02"}), "50.00");
}

TEST_F(LabelEvaluation, surfaces_without_normals_are_refused)
{
  writeFile(in("structure.pcd"), pcdBytes({{0, 0, 0}}, {1}));
  const ProgramRun result =
      run(LABEL_EVALUATION,
          {in("structure.pcd"), in("structure.pcd"), "--off-surface", "0.01"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.err.find("has no field 'normal_x'"), std::string::npos)
      << result.err;
}

TEST_F(LabelEvaluation, points_that_are_not_finite_count_neither_here_nor_there)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::string bad = in("bad.pcd");
  const std::string good = in("good.pcd");
  writeFile(bad, pcdBytes({{0, 0, 0}, {1, 0, nan}, {nan, nan, nan}}, {1, 2, 2}));
  writeFile(good, pcdBytes({{0, 0, 0}}, {1}));
  const ProgramRun expected = run(LABEL_EVALUATION, {good, good});
  for (const auto& [structure, scan] :
       {std::pair(bad, good), std::pair(good, bad), std::pair(bad, bad)}) {
    const ProgramRun result = run(LABEL_EVALUATION, {structure, scan});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, expected.out);
  }
}

TEST_F(LabelEvaluation, maps_every_label_of_32_bits)
{
  writeFile(in("structure.pcd"), pcdBytes({{0, 0, 0}}, {1}));
  writeFile(in("scan.pcd"), pcdBytes({{0, 0, 0}}, {4294967295}));
  const auto mapped = [this](const std::string& map) {
    return run(LABEL_EVALUATION, {in("structure.pcd"), in("scan.pcd"), "--map", map});
  };
  const ProgramRun result = mapped("4294967295=00000000001");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(cellsAfter("ceiling", result)[0], "1");
  for (const char* wrong :
       {"4294967296=1", "-1=1", "1=", "=1", "1=6", "1= 1", "1=1,1=2"})
    EXPECT_EQ(mapped(wrong).exit_code, 1) << wrong;
}

TEST_F(LabelEvaluation, refuses_what_it_cannot_score)
{
  writeFile(in("labelled.pcd"), pcdBytes({{0, 0, 0}}, {9}));
  writeFile(in("bare.pcd"), pcdBytes({{0, 0, 0}}));
  const auto refused = [this](const Strings& arguments, const char* words) {
    const ProgramRun result = run(LABEL_EVALUATION, arguments);
    EXPECT_EQ(result.exit_code, 1) << words;
    EXPECT_TRUE(result.failsInOneSentence()) << result.out << result.err;
    EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
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
