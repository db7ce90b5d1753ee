// SPDX-License-Identifier: BSD-3-Clause
#include "end_watch.h"

#include <unistd.h>

#include <ctime>
#include <iostream>
#include <utility>

namespace pcl::sedr::tools {

namespace {

sigset_t
endSignal()
{
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGTERM);
  return signals;
}

} // namespace

EndWatch::EndWatch(std::string tool)
    : tool_(std::move(tool))
{
  const sigset_t signals = endSignal();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
}

EndWatch::~EndWatch()
{
  end();
}

void
EndWatch::end()
{
  {
    const auto held = lock();
    has_ended_ = true;
  }
  if (watcher_.joinable())
    watcher_.join();
}

void
EndWatch::begin()
{
  watcher_ = std::thread(&EndWatch::watch, this);
}

void
EndWatch::standDown()
{
  const sigset_t signals = endSignal();
  pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
}

void
EndWatch::note(int rank, const std::string& held)
{
  const auto locked = lock();
  if (held.empty())
    held_.erase(rank);
  else
    held_[rank] = held;
}

void
EndWatch::noteKept(const std::string& folder)
{
  const auto locked = lock();
  kept_ = folder;
}

void
EndWatch::watch()
{
  const sigset_t signals = endSignal();
  const timespec a_while{0, 100000000}; // 0.1 s
  for (;;) {
    const bool is_told = sigtimedwait(&signals, nullptr, &a_while) == SIGTERM;
    const auto locked = lock();
    if (has_ended_)
      return;
    if (!is_told)
      continue;
    std::cerr << sentence() << std::endl;
    _exit(1);
  }
}

std::string
EndWatch::sentence() const
{
  std::string all;
  for (const auto& [rank, held] : held_)
    all += (all.empty() ? ", while " : ", ") + std::string("rank ") +
           std::to_string(rank) + " held " + held;
  return tool_ + ": ended from outside, or because a rank has died" + all +
         (kept_.empty() ? "; nothing was finished"
                        : "; what was finished is in '" + kept_ + "'");
}

} // namespace pcl::sedr::tools
