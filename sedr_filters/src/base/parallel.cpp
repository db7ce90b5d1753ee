// SPDX-License-Identifier: BSD-3-Clause
#include "parallel.h"

#include <boost/asio/post.hpp>
#include <boost/asio/thread_pool.hpp>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>

namespace pcl::sedr {

namespace {

using Body = std::function<void(std::size_t, std::size_t)>;

/** @brief The threads that work on a call and on the calls nested in it; together no
 * more than the outermost call requested. */
class Crew {
public:
  explicit Crew(std::size_t others)
      : idle_(others)
  {}

  /** @brief Engages up to `count` idle threads.
   * @return number of threads engaged */
  std::size_t engage(std::size_t count)
  {
    std::size_t idle = idle_;
    std::size_t engaged = std::min(idle, count);
    while (!idle_.compare_exchange_weak(idle, idle - engaged))
      engaged = std::min(idle, count);
    return engaged;
  }

  void release() { ++idle_; }

private:
  std::atomic<std::size_t> idle_;
};

/** @brief The crew of this thread, null outside of all calls. */
thread_local std::shared_ptr<Crew> own_crew;

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
 * takes time from working threads when other programs run. */
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
  void attach(std::size_t count)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    try {
      for (; threads_ < count; ++threads_)
        std::thread([this] { pool_.attach(); }).detach();
    }
    catch (const std::system_error&) { // the existing threads do the work
    }
  }

  /** @brief Lets `count` threads of a crew help with blocks; fewer if memory is short,
   * because the caller can work alone. */
  void help(const std::shared_ptr<Blocks>& blocks,
            const std::shared_ptr<Crew>& crew,
            std::size_t count)
  {
    try {
      for (std::size_t k = 0; k < count; ++k)
        boost::asio::post(pool_, [blocks, crew] {
          own_crew = crew;
          blocks->work();
          own_crew.reset();
          crew->release();
        });
    }
    catch (const std::bad_alloc&) {
    }
  }

private:
  /** @brief At least two: in a pool of one thread, work posted by that thread waits
   * until its current work is done. */
  static constexpr std::size_t first_threads = 2;

  Helpers()
      : pool_(first_threads)
  {}

  boost::asio::thread_pool pool_;
  std::mutex mutex_;
  std::size_t threads_ = first_threads;
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
    own_crew = std::make_shared<Crew>(resolveThreads(threads) - 1);
    // One thread replaces the caller, which sleeps when no block is left.
    Helpers::shared().attach(resolveThreads(threads));
  }
  if (const std::size_t others = own_crew->engage(team - 1))
    Helpers::shared().help(blocks, own_crew, others);
  blocks->work();
  if (is_outermost) {
    own_crew->release();
    own_crew.reset();
  }
  blocks->finish();
}

} // namespace pcl::sedr
