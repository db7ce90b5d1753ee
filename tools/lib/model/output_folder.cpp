// SPDX-License-Identifier: BSD-3-Clause
#include "output_folder.h"

#include "result_exchange.h"
#include "run_tool.h"
#include "tool_error.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

namespace pcl::sedr::tools {

namespace fs = std::filesystem;

namespace {

const int end_of_run = SIGRTMIN; ///< sent to the thread that awaits interrupts

/** @brief Returns interrupts, except those that the process ignores, as under nohup. */
sigset_t
awaitedSignals()
{
  sigset_t awaited;
  sigemptyset(&awaited);
  sigaddset(&awaited, end_of_run);
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action {};
    sigaction(number, nullptr, &action);
    if (action.sa_handler != SIG_IGN)
      sigaddset(&awaited, number);
  }
  return awaited;
}

[[noreturn]] void
refuse(const fs::path& folder, const std::string& reason)
{
  throw ToolError("the output folder '" + folder.string() +
                  "' cannot be written to: " + reason);
}

} // namespace

OutputFolder::OutputFolder(const std::string& path, std::vector<std::string> inputs)
    : path_(path.empty() ? throw ToolError("the output folder has no name")
                         : fs::absolute(path))
    , part_(path_ / hidden_folder)
    , inputs_(std::move(inputs))
{
  // Threads that are started later leave interrupts to the one that awaits them.
  const sigset_t awaited = awaitedSignals();
  pthread_sigmask(SIG_BLOCK, &awaited, &blocked_before_);
  std::error_code error;
  for (fs::path folder = path_;
       !fs::exists(fs::symlink_status(folder, error)) && folder != folder.root_path();
       folder = folder.parent_path())
    missing_.push_back(folder);
  fs::create_directories(path_, error);
  try {
    if (error)
      refuse(path_, error.message());
    lock();
    if (isExchangeBegun(path_))
      finishExchange(path_);
    for (const auto& entry : fs::directory_iterator(part_)) // of a run that was killed
      fs::remove_all(entry, error);
    startAwaiting(awaited);
  }
  catch (...) {
    clean();
    pthread_sigmask(SIG_SETMASK, &blocked_before_, nullptr);
    throw;
  }
}

/** @brief Starts the thread that awaits interrupts. Where none can be started, an
 * interrupt ends the process as it would any other. */
void
OutputFolder::startAwaiting(const sigset_t& awaited)
{
  try {
    interrupts_ = std::thread([this, awaited] { awaitInterrupt(awaited); });
  }
  catch (const std::system_error&) {
    pthread_sigmask(SIG_SETMASK, &blocked_before_, nullptr);
  }
}

OutputFolder::~OutputFolder()
{
  if (interrupts_.joinable()) {
    pthread_kill(interrupts_.native_handle(), end_of_run);
    interrupts_.join(); // or an interrupt ends the process
  }
  clean();
  pthread_sigmask(SIG_SETMASK, &blocked_before_, nullptr);
}

/** @brief Creates the hidden folder and locks it. */
void
OutputFolder::lock()
{
  if (mkdir(part_.c_str(), S_IRWXU | S_IRWXG | S_IRWXO) != 0 && errno != EEXIST)
    refuse(path_, std::strerror(errno));
  lock_ = open(part_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC | O_NOFOLLOW);
  if (lock_ >= 0 && flock(lock_, LOCK_EX | LOCK_NB) == 0)
    return;
  const int problem = errno;
  if (lock_ >= 0)
    close(std::exchange(lock_, -1));
  refuse(path_, problem == EWOULDBLOCK
                    ? "another run is writing into it; wait for its end, or choose "
                      "another output folder"
                    : std::strerror(problem));
}

/** @brief Removes the hidden folder, unless it is that of another run, and the folders
 * that are still empty. */
void
OutputFolder::clean() const
{
  std::error_code error;
  if (lock_ >= 0) {
    removeHidden();
    close(lock_);
  }
  for (const auto& folder : missing_)
    fs::remove(folder, error); // only if it is empty
}

/** @brief Removes the hidden folder, unless what is in it belongs to the results. */
void
OutputFolder::removeHidden() const
{
  std::error_code error;
  if (!isExchangeBegun(path_) && fs::remove_all(part_, error) != 0 && error)
    fs::remove(part_, error); // an empty one, which needs no memory
}

/** @brief Removes the hidden folder at an interrupt, while other threads may still
 * write into it, then lets the interrupt end the process. */
void
OutputFolder::awaitInterrupt(sigset_t awaited)
{
  int number = 0;
  if (sigwait(&awaited, &number) != 0 || number == end_of_run)
    return;
  const std::lock_guard<std::mutex> lock(moving_);
  constexpr int most_tries = 1000;
  std::error_code error;
  for (int k = 0; k < most_tries && fs::exists(part_, error); ++k)
    removeHidden();
  for (const auto& folder : missing_)
    fs::remove(folder, error); // only if it is empty
  if (!is_moved_)
    say("interrupted: nothing was written");
  std::signal(number, SIG_DFL);
  pthread_sigmask(SIG_SETMASK, &blocked_before_, nullptr);
  raise(number);
}

bool
OutputFolder::isInput(const fs::path& file) const
{
  return std::any_of(inputs_.begin(), inputs_.end(), [&](const std::string& input) {
    std::error_code error; // a missing file is equivalent to none
    return fs::equivalent(file, input, error);
  });
}

void
OutputFolder::check(const std::vector<std::string>& names) const
{
  std::error_code error;
  for (const auto& name : names) {
    const fs::path file = path_ / name;
    if (isInput(file))
      throw ToolError("'" + file.string() + "' would be written over by the result " +
                      name + ": choose another output folder");
    if (fs::is_directory(file, error))
      refuse(path_, "'" + file.string() + "' is a folder");
    const fs::path folder = file.parent_path();
    if (fs::exists(folder, error) && !fs::is_directory(folder, error))
      refuse(path_, "'" + folder.string() + "' is no folder");
  }
}

std::string
OutputFolder::file(const std::string& name) const
{
  const fs::path path = part_ / name;
  std::error_code error;
  if (path.parent_path() != part_) // which an interrupt may have removed
    fs::create_directory(path.parent_path(), error);
  return path.string();
}

std::vector<std::string>
OutputFolder::written() const
{
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(part_))
    if (!entry.is_directory())
      names.push_back(entry.path().lexically_relative(part_).string());
  std::sort(names.begin(), names.end());
  return names;
}

void
OutputFolder::exchange(std::vector<std::string> removed)
{
  const std::vector<std::string> names = written();
  check(names);
  for (const auto& name : writtenFiles(path_))
    if (!std::binary_search(names.begin(), names.end(), name) && !isInput(path_ / name))
      removed.push_back(name);
  const std::lock_guard<std::mutex> lock(moving_); // interrupts wait
  beginExchange(path_, names, removed);
  is_moved_ = true;
  finishExchange(path_);
}

} // namespace pcl::sedr::tools
