// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>

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

/** @brief Makes a text from a file printable: control characters and bytes that are no
 * UTF-8 become `\x1b`, and what follows the first `most` bytes becomes `...`. */
std::string plainText(std::string_view text,
                      std::size_t most = std::numeric_limits<std::size_t>::max());

/** @brief Quotes a word or name from a file in a message: printable, at most 40 bytes,
 * in single quotes. */
std::string quotedWord(std::string_view word);

} // namespace pcl::sedr::tools
