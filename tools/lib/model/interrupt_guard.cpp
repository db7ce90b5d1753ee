// SPDX-License-Identifier: BSD-3-Clause
#include "interrupt_guard.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <array>
#include <system_error>
#include <utility>

namespace pcl::sedr::tools {

InterruptGuard::InterruptGuard()
{
  sigset_t interrupts;
  sigemptyset(&interrupts);
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action {};
    sigaction(number, nullptr, &action);
    if (action.sa_handler != SIG_IGN)
      sigaddset(&interrupts, number);
  }
  pthread_sigmask(SIG_BLOCK, &interrupts, &before_);
  interrupts_ = signalfd(-1, &interrupts, SFD_CLOEXEC);
  stopped_ = eventfd(0, EFD_CLOEXEC);
}

void
InterruptGuard::watch(std::function<void()> clean)
{
  try {
    if (interrupts_ >= 0 && stopped_ >= 0)
      thread_ = std::thread([this, clean = std::move(clean)] { wait(clean); });
  }
  catch (const std::system_error&) {
  }
  if (!thread_.joinable()) // no thread or file is left: interrupts end the process
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

void
InterruptGuard::wait(const std::function<void()>& clean)
{
  std::array<pollfd, 2> awaited{{{stopped_, POLLIN, 0}, {interrupts_, POLLIN, 0}}};
  while (poll(awaited.data(), awaited.size(), -1) < 0) {
  }
  signalfd_siginfo interrupt{};
  if (awaited[0].revents != 0 || is_over_.exchange(true) ||
      read(interrupts_, &interrupt, sizeof interrupt) != sizeof interrupt)
    return;
  clean();
  const int number = static_cast<int>(interrupt.ssi_signo);
  std::signal(number, SIG_DFL);
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  raise(number);
}

void
InterruptGuard::stop()
{
  if (!is_stopped_ && is_over_.exchange(true) && thread_.joinable())
    thread_.join(); // it ends the process
  is_stopped_ = true;
}

InterruptGuard::~InterruptGuard()
{
  stop();
  eventfd_write(stopped_, 1);
  if (thread_.joinable())
    thread_.join();
  close(interrupts_);
  close(stopped_);
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

} // namespace pcl::sedr::tools
