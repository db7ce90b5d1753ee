// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "says.h"
#include "tools/run_program.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace programs {

/** Expects the exit code and one sentence with `words`. */
inline void
expectSentence(const ProgramRun& result, int exit_code, const std::string& words = "")
{
  EXPECT_EQ(result.exit_code, exit_code) << result.err;
  EXPECT_TRUE(result.failsInOneSentence()) << result.out << result.err;
  EXPECT_TRUE(says(result.err, words));
}

/** Returns a run that has to succeed; ends the test otherwise. */
inline ProgramRun
done(ProgramRun result)
{
  if (result.exit_code != 0)
    throw std::runtime_error("exit code " + std::to_string(result.exit_code) + ": " +
                             result.err);
  return result;
}

/** Runs a program without a terminal, with options after its arguments. */
inline ProgramRun
run(const std::string& program,
    std::vector<std::string> arguments,
    const std::vector<std::string>& options)
{
  arguments.insert(arguments.end(), options.begin(), options.end());
  return run(program, arguments);
}

/** Tests with files in a folder of their own. */
template <typename TestT = ::testing::Test>
class InFolder : public TestT {
protected:
  std::string in(const std::string& name) const
  {
    return (folder_.path() / name).string();
  }

  TemporaryFolder folder_;
};

} // namespace programs
