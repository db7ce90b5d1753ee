// SPDX-License-Identifier: BSD-3-Clause
#include "run_tool.h"

#include "plain_text.h"
#include "tool_error.h"

#include <pcl/console/print.h>

#include <unistd.h>

#include <csignal>
#include <exception>
#include <iostream>
#include <mutex>
#include <new>
#include <set>

namespace pcl::sedr::tools {

namespace {

/** @brief Returns the name of the running program. */
std::string&
runningTool()
{
  static std::string name;
  return name;
}

} // namespace

int
runTool(Options& options, int argc, char** argv, const std::function<int()>& body)
{
  runningTool() = options.tool();
  const auto complain = [&](const std::string& sentence, int exit_code) {
    std::cerr << options.tool() << ": " << plainText(sentence) << std::endl;
    return exit_code;
  };
  std::signal(SIGXFSZ, SIG_IGN); // a file too large is an error of its writer
  try {
    pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
    if (!options.parse(argc, argv)) {
      std::cout << options.answer() << std::flush;
      return Done;
    }
    return body();
  }
  catch (const ToolError& error) {
    return complain(error.what(), error.exitCode());
  }
  catch (const std::bad_alloc&) {
    return complain("the memory does not suffice for this input", BadUse);
  }
  catch (const std::exception& error) {
    return complain(std::string("failed: ") + error.what(), BadUse);
  }
  catch (...) {
    return complain("failed for an unknown reason", BadUse);
  }
}

void
warn(const std::string& sentence)
{
  tell("warning: " + sentence);
}

void
warnOnce(const std::string& sentence)
{
  static std::mutex mutex;
  static std::set<std::string> told;
  const std::lock_guard<std::mutex> lock(mutex);
  if (told.insert(sentence).second)
    warn(sentence);
}

void
tell(const std::string& sentence)
{
  const std::string& tool = runningTool();
  std::cerr << tool + (tool.empty() ? "" : ": ") + plainText(sentence) << std::endl;
}

void
say(const std::string& line)
{
  if (isatty(STDERR_FILENO) != 0)
    std::cerr << line << std::endl;
}

} // namespace pcl::sedr::tools
