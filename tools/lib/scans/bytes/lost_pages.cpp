// SPDX-License-Identifier: BSD-3-Clause
#include "lost_pages.h"

#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstdint>
#include <mutex>

namespace pcl::sedr::tools {

namespace {

struct Mapping {
  std::atomic<bool> is_taken{false};
  std::atomic<std::uintptr_t> begin{0};
  std::atomic<std::uintptr_t> end{0}; ///< 0: unused
  std::atomic<bool> has_lost{false};
};

constexpr std::size_t max_mappings = 4096;  // more files are not open at a time
std::array<Mapping, max_mappings> mappings; // all that the handler may access
std::atomic<std::uintptr_t> page_size{4096};

/** @brief Replaces the unreadable page and all that follow by zeros. */
extern "C" void
replacePage(int signal, siginfo_t* info, void*)
{
  const auto place = reinterpret_cast<std::uintptr_t>(info->si_addr);
  for (Mapping& mapping : mappings) {
    const std::uintptr_t end = mapping.end;
    if (place < mapping.begin || place >= end)
      continue;
    mapping.has_lost = true;
    const std::uintptr_t page = place - place % page_size;
    void* const zeros =
        mmap(reinterpret_cast<void*>(page), end - page, PROT_READ,
             MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED | MAP_NORESERVE, -1, 0);
    if (zeros != MAP_FAILED)
      return;
  }
  std::signal(signal, SIG_DFL); // not ours: recurs and ends the program
}

void
installHandler()
{
  page_size = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  struct sigaction action {};
  action.sa_sigaction = &replacePage;
  action.sa_flags = SA_SIGINFO | SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(SIGBUS, &action, nullptr);
}

} // namespace

LostPages::LostPages(const void* begin, std::size_t size)
    : place_(0)
{
  static std::once_flag once;
  std::call_once(once, installHandler);
  for (; place_ < max_mappings; ++place_) {
    Mapping& mapping = mappings[place_];
    if (mapping.is_taken.exchange(true))
      continue;
    mapping.has_lost = false;
    mapping.begin = reinterpret_cast<std::uintptr_t>(begin);
    mapping.end = mapping.begin + size;
    return;
  }
}

LostPages::~LostPages()
{
  if (place_ == max_mappings)
    return;
  mappings[place_].end = 0;
  mappings[place_].is_taken = false;
}

bool
LostPages::any() const
{
  return place_ < max_mappings && mappings[place_].has_lost;
}

} // namespace pcl::sedr::tools
