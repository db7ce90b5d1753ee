// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulator/temporary_folder.h"

#include <sys/wait.h>

#include <algorithm>
#include <vector>

namespace programs {

using pcl::sedr::sim::test::bytesOf;
using pcl::sedr::sim::test::TemporaryFolder;

/** The result of a program run. */
struct ProgramRun {
  int exit_code = -1; ///< 124: took over a minute; above 128: crashed
  std::string out;
  std::string err;

  /** Returns true if stderr is a single line, as required of failing programs. */
  bool failsInOneSentence() const
  {
    return err.size() > 20 && std::count(err.begin(), err.end(), '\n') == 1 &&
           out.empty();
  }
};

inline std::string
quoted(const std::string& word)
{
  std::string text = "'";
  for (const char c : word)
    text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

/** Runs a program without a terminal, for at most a minute. */
inline ProgramRun
run(const std::string& program, const std::vector<std::string>& arguments)
{
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "out").string();
  const std::string err = (folder.path() / "err").string();
  std::string command = "timeout -k 5 60 " + quoted(program);
  for (const auto& argument : arguments)
    command += " " + quoted(argument);
  command += " >" + quoted(out) + " 2>" + quoted(err) + " </dev/null";
  const int status = std::system(command.c_str());
  ProgramRun result;
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  result.out = bytesOf(out);
  result.err = bytesOf(err);
  return result;
}

} // namespace programs
