// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "box_room.h"
#include "in_folder.h"
#include "option_help.h"
#include "sample_files.h"

#include <pcl/sedr_filters/floorplan_io.h>

#include <gtest/gtest.h>

#include <ostream>
#include <utility>

// Tests of the requirements for every tool of the form "pcl_x INPUT OUTPUT [options]"
// or "pcl_x INPUT PLAN.json OUTPUT [options]". A test program instantiates it:
//
//     INSTANTIATE_TEST_SUITE_P(Tools, ToolContract, ::testing::Values("/path/to/pcl_x",
//     ...));

namespace programs {

/** A tool and its arguments. */
struct Tool {
  Tool(const char* path)
      : program(path)
  {}

  Tool(std::string path, std::string output_name, bool plan = false)
      : program(std::move(path))
      , output(std::move(output_name))
      , takes_plan(plan)
  {}

  std::string program;
  std::string output = "output.pcd";
  bool takes_plan = false; ///< as its second argument
};

inline std::ostream&
operator<<(std::ostream& stream, const Tool& tool)
{
  return stream << tool.program;
}

class ToolContract : public InFolder<::testing::TestWithParam<Tool>> {
protected:
  const std::string& program() const { return GetParam().program; }

  /** Runs the tool on a cloud, with the plan of a room if it takes one. */
  ProgramRun runOn(const std::string& input, const std::string& output)
  {
    if (!GetParam().takes_plan)
      return run(program(), {input, output});
    writeFile(in("input_plan.json"), pcl::sedr::floorplanToJson({{planOf(BoxRoom())}}));
    return run(program(), {input, in("input_plan.json"), output});
  }

  ProgramRun onFile(const std::string& bytes)
  {
    writeFile(in("input.pcd"), bytes);
    return runOn(in("input.pcd"), in(GetParam().output));
  }

  /** Expects the exit code, one sentence, and no new file. */
  void expectFailure(const ProgramRun& result, int exit_code) const
  {
    expectSentence(result, exit_code);
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path()))
      EXPECT_EQ(entry.path().filename().string().compare(0, 5, "input"), 0)
          << entry.path() << " was left behind";
  }
};

TEST_P(ToolContract, HelpTellsUsageAndEveryDefault)
{
  const ProgramRun help = run(program(), {"-h"});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_EQ(help.err, "");
  EXPECT_NE(help.out.find("Usage: pcl_"), std::string::npos);
  const std::vector<OptionHelp> options = optionsIn(help.out);
  EXPECT_FALSE(options.empty());
  for (const auto& option : options)
    EXPECT_TRUE(option.tellsDefault()) << option.name;
}

TEST_P(ToolContract, NumbersThatAreNoneOrOutOfRangeAreRefused)
{
  std::string value = "many";
  for (const auto& option : optionsIn(run(program(), {"-h"}).out)) {
    if (!option.hasRange())
      continue;
    std::vector<std::string> arguments{in("a.pcd"), in("b.pcd"), "--" + option.name,
                                       value};
    if (GetParam().takes_plan)
      arguments.insert(arguments.begin(), in("plan.json"));
    const ProgramRun result = run(program(), arguments);
    expectFailure(result, 1);
    EXPECT_NE(result.err.find("--" + option.name), std::string::npos) << result.err;
    value = "-1";
  }
}

TEST_P(ToolContract, BadCommandLinesAreRefused)
{
  expectFailure(run(program(), {}), 1);
  expectFailure(run(program(), {"a.pcd"}), 1);
  expectFailure(run(program(), {"a.pcd", "b.pcd", "c.pcd", "d.pcd"}), 1);
  expectFailure(run(program(), {"a.pcd", "b.pcd", "--no-such-option"}), 1);
}

TEST_P(ToolContract, FilesThatAreNoCloudsAreRefused)
{
  expectFailure(runOn(in("missing.pcd"), in(GetParam().output)), 1);
  expectFailure(runOn(folder_.path().string(), in(GetParam().output)), 1);
  expectFailure(onFile(""), 1);
  expectFailure(onFile("no cloud at all\n"), 1);
  expectFailure(onFile(std::string(5000, '\0')), 1);
  expectFailure(onFile(pcdBytes({})), 1);
  const std::string good = pcdBytes({{1, 2, 3}, {1, 2, 4}}, {1, 2});
  expectFailure(onFile(good.substr(0, good.size() - 1)), 1);
  expectFailure(onFile(good.substr(0, 60)), 1);
}

TEST_P(ToolContract, AMeshIsToldFromACloud)
{
  const ProgramRun result =
      onFile("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
             "property float y\nproperty float z\nelement face 1\n"
             "property list uchar int vertex_indices\nend_header\n"
             "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  const std::string name = std::filesystem::path(program()).filename();
  EXPECT_EQ(result.err.rfind(name + ": warning: '", 0), 0U) << result.err;
  EXPECT_NE(result.err.find("is a mesh of 1 face"), std::string::npos) << result.err;
}

TEST_P(ToolContract, CloudsWithoutAFinitePointOrTooFarAwayAreRefused)
{
  const float nan = std::nanf("");
  expectFailure(onFile(pcdBytes({{nan, nan, nan}, {nan, 0, 0}})), 1);
  const ProgramRun far = onFile(pcdBytes({{4.5e6f, 1, 1}, {4.5e6f, 2, 1}}));
  expectFailure(far, 1);
  EXPECT_NE(far.err.find("mm"), std::string::npos) << "it tells the resolution left";
}

TEST_P(ToolContract, OutputsThatCannotBeWrittenAreRefusedBeforeTheWork)
{
  writeFile(in("input.pcd"), pcdBytes({{1, 2, 3}}));
  const std::string& output = GetParam().output;
  expectFailure(runOn(in("input.pcd"), in("no_folder/" + output)), 1);
  expectFailure(runOn(in("input.pcd"), in("output.txt")), 1);
  std::filesystem::create_directory(in("input_folder_" + output));
  expectFailure(runOn(in("input.pcd"), in("input_folder_" + output)), 1);
}

} // namespace programs
