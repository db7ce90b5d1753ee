// SPDX-License-Identifier: BSD-3-Clause
#include "parallel.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <new>
#include <thread>
#include <utility>

namespace pcl::sedr {

namespace {

using Body = std::function<void(std::size_t, std::size_t)>;

/** @brief The number of threads that may still join a call and the calls nested in it;
 * together they are no more than the outermost call requested. */
using Crew = std::shared_ptr<std::atomic<int>>;

/** @brief The crew of this thread, null outside of all calls. */
thread_local Crew own_crew;

/** @brief The blocks of a call, taken by threads one after another. */
class Blocks {
public:
  Blocks(std::size_t n, std::size_t block, const Body& body)
      : n_(n)
      , block_(block)
      , count_((n + block - 1) / block)
      , body_(body)
  {}

  std::size_t count() const { return count_; }

  /** @brief Works on blocks until none is left. A thread that comes later does nothing
   * and does not access the body, which may no longer exist. */
  void work()
  {
    for (std::size_t b = next_++; b < count_; b = next_++) {
      try {
        body_(b * block_, std::min(n_, (b + 1) * block_));
      }
      catch (...) {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (!failure_)
          failure_ = std::current_exception();
      }
      if (++finished_ == count_) {
        const std::lock_guard<std::mutex> lock(mutex_);
        all_finished_.notify_all();
      }
    }
  }

  /** @brief Waits for the blocks of other threads; rethrows the first exception. */
  void finish()
  {
    std::unique_lock<std::mutex> lock(mutex_);
    all_finished_.wait(lock, [&] { return finished_ == count_; });
    if (failure_)
      std::rethrow_exception(failure_);
  }

private:
  const std::size_t n_;
  const std::size_t block_;
  const std::size_t count_;
  const Body& body_;
  std::atomic<std::size_t> next_{0};
  std::atomic<std::size_t> finished_{0};
  std::mutex mutex_;
  std::condition_variable all_finished_;
  std::exception_ptr failure_;
};

/** @brief Worker threads that sleep until there is work. Active waiting, as in OpenMP,
 * takes time from working threads when other programs run. Where the system allows
 * fewer threads, these do the work; TBB would end the process. */
class Helpers {
public:
  /** @brief Returns the instance, which is never destroyed: a process may end while the
   * threads sleep. */
  static Helpers& shared()
  {
    static auto* const helpers = new Helpers;
    return *helpers;
  }

  /** @brief Starts threads up to `count`, or as many as the system allows. */
  void attach(unsigned count)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    try {
      for (; threads_ < count && !is_refused_; ++threads_)
        std::thread([this] { work(); }).detach();
    }
    catch (const std::exception&) {
      is_refused_ = true;
    }
  }

  /** @brief Lets up to `count` threads of a crew help with blocks; fewer if memory is
   * short, because the caller can work alone. */
  void help(const std::shared_ptr<Blocks>& blocks, const Crew& crew, std::size_t count)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    try {
      for (; threads_ > 0 && count > 0; --count) {
        if (--*crew < 0) {
          ++*crew;
          return;
        }
        jobs_.push_back({blocks, crew});
        has_job_.notify_one();
      }
    }
    catch (const std::bad_alloc&) {
    }
  }

private:
  struct Job {
    std::shared_ptr<Blocks> blocks;
    Crew crew;
  };

  [[noreturn]] void work()
  {
    for (;;) {
      std::unique_lock<std::mutex> lock(mutex_);
      has_job_.wait(lock, [this] { return !jobs_.empty(); });
      const Job job = std::move(jobs_.front());
      jobs_.pop_front();
      lock.unlock();
      own_crew = job.crew;
      job.blocks->work();
      own_crew.reset();
      ++*job.crew;
    }
  }

  std::mutex mutex_;
  std::condition_variable has_job_;
  std::deque<Job> jobs_;
  unsigned threads_ = 0;
  bool is_refused_ = false; ///< whether the system has refused a thread
};

} // namespace

unsigned
resolveThreads(unsigned requested)
{
  return requested > 0 ? requested : std::max(1u, std::thread::hardware_concurrency());
}

void
parallelBlocks(std::size_t n, std::size_t block, unsigned threads, const Body& body)
{
  const auto blocks =
      std::make_shared<Blocks>(n, std::max<std::size_t>(block, 1), body);
  const std::size_t team =
      std::min<std::size_t>(resolveThreads(threads), blocks->count());
  if (team <= 1) {
    blocks->work();
    blocks->finish();
    return;
  }
  const bool is_outermost = !own_crew;
  if (is_outermost) {
    own_crew = std::make_shared<Crew::element_type>(
        static_cast<int>(resolveThreads(threads)) - 1);
    // One thread replaces the caller, which sleeps when no block is left.
    Helpers::shared().attach(resolveThreads(threads));
  }
  Helpers::shared().help(blocks, own_crew, team - 1);
  blocks->work();
  if (is_outermost) {
    ++*own_crew;
    own_crew.reset();
  }
  blocks->finish();
}

} // namespace pcl::sedr
