// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tools/run_program.h"
#include "tools/sample_files.h"

#include <gtest/gtest.h>

#include <cmath>

// What every tool of the form "pcl_x INPUT OUTPUT.pcd [options]" promises. A test
// program instantiates it with the tools it knows:
//
//     INSTANTIATE_TEST_SUITE_P(Tools, ToolContract, ::testing::Values("/path/to/pcl_x",
//     ...));

namespace programs {

class ToolContract : public ::testing::TestWithParam<std::string> {
protected:
  std::string in(const std::string& name) const
  {
    return (folder_.path() / name).string();
  }

  ProgramRun onFile(const std::string& bytes)
  {
    writeFile(in("input.pcd"), bytes);
    return run(GetParam(), {in("input.pcd"), in("output.pcd")});
  }

  /** One sentence, the exit code, and no file but those that were there. */
  void expectFailure(const ProgramRun& result, int exit_code) const
  {
    EXPECT_EQ(result.exit_code, exit_code) << result.err;
    EXPECT_TRUE(result.failsInOneSentence()) << result.out << result.err;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path()))
      EXPECT_EQ(entry.path().filename().string().compare(0, 5, "input"), 0)
          << entry.path() << " was left behind";
  }

  TemporaryFolder folder_;
};

TEST_P(ToolContract, HelpTellsUsageAndOptions)
{
  for (const char* option : {"-h", "--help"}) {
    const ProgramRun result = run(GetParam(), {option});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_NE(result.out.find("Usage: pcl_"), std::string::npos);
    EXPECT_NE(result.out.find("default "), std::string::npos);
    EXPECT_EQ(result.err, "");
  }
}

TEST_P(ToolContract, BadCommandLinesAreRefused)
{
  expectFailure(run(GetParam(), {}), 1);
  expectFailure(run(GetParam(), {"a.pcd"}), 1);
  expectFailure(run(GetParam(), {"a.pcd", "b.pcd", "c.pcd"}), 1);
  expectFailure(run(GetParam(), {"a.pcd", "b.pcd", "--no-such-option"}), 1);
}

TEST_P(ToolContract, FilesThatAreNoCloudsAreRefused)
{
  expectFailure(run(GetParam(), {in("missing.pcd"), in("output.pcd")}), 1);
  expectFailure(run(GetParam(), {folder_.path().string(), in("output.pcd")}), 1);
  expectFailure(onFile(""), 1);
  expectFailure(onFile("no cloud at all\n"), 1);
  expectFailure(onFile(std::string(5000, '\0')), 1);
  expectFailure(onFile(pcdBytes({})), 1);
  const std::string good = pcdBytes({{1, 2, 3}, {1, 2, 4}}, {1, 2});
  expectFailure(onFile(good.substr(0, good.size() - 1)), 1);
  expectFailure(onFile(good.substr(0, 60)), 1);
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
  expectFailure(run(GetParam(), {in("input.pcd"), in("no_folder/output.pcd")}), 1);
  expectFailure(run(GetParam(), {in("input.pcd"), in("output.txt")}), 1);
  std::filesystem::create_directory(in("input_folder.pcd"));
  expectFailure(run(GetParam(), {in("input.pcd"), in("input_folder.pcd")}), 1);
}

} // namespace programs
