// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.h"

#include <functional>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief What main() returns: parses the command line, prints the help or calls
 * `body`, and turns whatever is thrown into one sentence on stderr. PCL's own messages
 * are silenced, the reasons that stages give are to be thrown as ToolError.
 * @return 0 done, 1 bad use or unreadable input, 2 nothing found; else what `body`
 * returns */
int runTool(Options& options, int argc, char** argv, const std::function<int()>& body);

/** @brief Prints a warning on stderr, the name of the program that runTool() runs
 * before it. */
void warn(const std::string& sentence);

/** @brief Prints what must be known on stderr, the name of the program before it. */
void tell(const std::string& sentence);

/** @brief Prints a line on stderr if that is a terminal; quiet when piped. */
void say(const std::string& line);

} // namespace tools
} // namespace sedr
} // namespace pcl
