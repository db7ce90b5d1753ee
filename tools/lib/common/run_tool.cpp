// SPDX-License-Identifier: BSD-3-Clause
#include "run_tool.h"
#include "sedr_filters/src/base/number_text.h"

#include "result_exchange.h"
#include "tool_error.h"

#include <pcl/console/print.h>

#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
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

/** @brief Throws ToolError if what was printed did not arrive, as on a full disk. */
void
checkPrinted()
{
  errno = 0;
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0 || std::cout.bad())
    throw ToolError(std::string("cannot write to the standard output: ") +
                    (errno != 0 ? std::strerror(errno) : "the disk may be full"));
}

std::string
memoryProblem()
{
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  return "the memory does not suffice: this run has taken " +
         std::to_string(used.ru_maxrss / 1024) +
         " MB; allow it more (ulimit -v), or thin the points first "
         "(pcl_parallel_voxel_grid)";
}

void
tell(const std::string& sentence)
{
  const std::string& tool = runningTool();
  std::cerr << tool + (tool.empty() ? "" : ": ") + plainText(sentence) << std::endl;
}

} // namespace

int
runTool(Options& options, int argc, char** argv, const std::function<int()>& body)
{
  runningTool() = options.tool();
  const auto complain = [](const std::string& sentence, int exit_code) {
    tell(sentence);
    return exit_code;
  };
  std::signal(SIGXFSZ, SIG_IGN); // a file too large is an error of its writer
  try {
    pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
    if (!options.parse(argc, argv)) {
      std::cout << options.answer() << std::flush;
      checkPrinted();
      return Done;
    }
    finishExchanges({argv + 1, argv + argc});
    const int exit_code = body();
    if (exit_code == Done)
      checkPrinted();
    return exit_code;
  }
  catch (const ToolError& error) {
    return complain(error.what(), error.exitCode());
  }
  catch (const std::bad_alloc&) {
    return complain(memoryProblem(), BadUse);
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
  tellOnce("warning: " + sentence);
}

void
tellOnce(const std::string& sentence)
{
  static std::mutex mutex;
  static std::set<std::string> told;
  const std::lock_guard<std::mutex> lock(mutex);
  if (told.insert(sentence).second)
    tell(sentence);
}

void
say(const std::string& line)
{
  if (isatty(STDERR_FILENO) != 0)
    std::cerr << line << std::endl;
}

Progress::Progress(const std::string& step)
{
  if (isatty(STDERR_FILENO) != 0)
    std::cerr << step << " ..." << std::flush;
}

Progress::~Progress()
{
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start_;
  say(formatText(" %.1f s", taken.count()));
}

} // namespace pcl::sedr::tools
