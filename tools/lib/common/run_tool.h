// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.h"

#include <chrono>
#include <functional>
#include <string>

namespace pcl::sedr::tools {

/** @brief Implements main(): parses the command line, prints the help or finishes
 * exchanges of results that were killed and calls `body`, and prints an exception as
 * one sentence on stderr. PCL's own messages are silenced; `body` throws the reasons
 * that stages give as ToolError.
 * @return 0 done, 1 bad use or unreadable input, 2 nothing found; else the value from
 * `body` */
int runTool(Options& options, int argc, char** argv, const std::function<int()>& body);

/** @brief Prints a warning on stderr, after the name of the program in runTool(). */
void warn(const std::string& sentence);

/** @brief As above, but only once per process for each sentence. */
void warnOnce(const std::string& sentence);

/** @brief Prints an important message on stderr, after the name of the program; once
 * per process. */
void tellOnce(const std::string& sentence);

/** @brief Prints a line on stderr if that is a terminal. */
void say(const std::string& line);

/** @brief Names the current step on a terminal, and tells at its end how long it took.
 * Silent if stderr is no terminal.
 * @code
 * const Progress progress("finding planes");
 * @endcode */
class Progress {
public:
  explicit Progress(const std::string& step);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

} // namespace pcl::sedr::tools
