// SPDX-License-Identifier: BSD-3-Clause
#include "progress.h"

#include <unistd.h>

#include <iomanip>
#include <iostream>
#include <utility>

namespace pcl::sedr::tools {

Progress::Progress(std::string step)
    : step_(std::move(step))
{
  if (isatty(STDERR_FILENO) != 0)
    watcher_ = std::thread(&Progress::watch, this);
}

Progress::~Progress()
{
  if (!watcher_.joinable())
    return;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    has_ended_ = true;
  }
  ended_.notify_one();
  watcher_.join();
  if (!has_spoken_)
    return;
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start_;
  std::cerr << ' ' << std::fixed << std::setprecision(1) << taken.count() << " s"
            << std::endl;
}

void
Progress::watch()
{
  std::unique_lock<std::mutex> lock(mutex_);
  if (ended_.wait_for(lock, std::chrono::seconds(1), [this] { return has_ended_; }))
    return;
  std::cerr << step_ << " ..." << std::flush;
  has_spoken_ = true;
}

} // namespace pcl::sedr::tools
