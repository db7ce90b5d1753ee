// SPDX-License-Identifier: BSD-3-Clause
#include "progress.h"

#include "run_tool.h"

#include <unistd.h>

#include <cstdio>
#include <iostream>

namespace pcl::sedr::tools {

Progress::Progress(const std::string& step)
{
  if (isatty(STDERR_FILENO) != 0)
    std::cerr << step << " ..." << std::flush;
}

Progress::~Progress()
{
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start_;
  char text[40];
  std::snprintf(text, sizeof text, " %.1f s", taken.count());
  say(text);
}

} // namespace pcl::sedr::tools
