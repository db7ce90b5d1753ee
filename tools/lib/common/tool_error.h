// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

namespace pcl::sedr::tools {

/** @brief Meaning of a tool's exit code. */
enum ExitCode {
  Done = 0,
  BadUse = 1,      ///< bad options, unreadable input, output that cannot be written
  NothingFound = 2 ///< the input was read, but lacks what the tool looks for
};

/** @brief Ends a tool with a sentence, printed by runTool(), and an exit code. */
class ToolError : public std::runtime_error {
public:
  explicit ToolError(const std::string& sentence, ExitCode exit_code = BadUse)
      : std::runtime_error(sentence)
      , exit_code_(exit_code)
  {}

  ExitCode exitCode() const { return exit_code_; }

private:
  ExitCode exit_code_;
};

/** @brief Throws ToolError unless `problem` is empty. */
inline void
throwProblem(const std::string& problem, ExitCode exit_code = BadUse)
{
  if (!problem.empty())
    throw ToolError(problem, exit_code);
}

} // namespace pcl::sedr::tools
