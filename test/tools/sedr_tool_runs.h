// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "box_room.h"
#include "run_program.h"
#include "sample_files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace programs {

using Strings = std::vector<std::string>;

/** Runs pcl_sedr in a folder of its own. */
class SedrTool : public ::testing::Test {
protected:
  std::string in(const std::string& name) const
  {
    return (folder_.path() / name).string();
  }

  ProgramRun onFile(const std::string& bytes, const Strings& options = {})
  {
    writeFile(in("input.pcd"), bytes);
    Strings arguments{in("input.pcd"), in("model")};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run(SEDR, arguments);
  }

  /** Expects the exit code, a sentence with `words`, and no new file. */
  void expectFailure(const ProgramRun& result, int exit_code, const std::string& words)
  {
    EXPECT_EQ(result.exit_code, exit_code) << result.err;
    EXPECT_TRUE(result.failsInOneSentence()) << result.out << result.err;
    EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(folder_.path()))
      EXPECT_TRUE(entry.is_directory() || entry.path().filename() == "input.pcd")
          << entry.path() << " was left behind";
  }

  TemporaryFolder folder_;
};

} // namespace programs
