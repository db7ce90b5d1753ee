// SPDX-License-Identifier: BSD-3-Clause
#include "output_folder.h"

#include "tool_error.h"

#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <thread>
#include <utility>

namespace pcl::sedr::tools {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void
refuse(const fs::path& folder, const std::string& reason)
{
  throw ToolError("the output folder '" + folder.string() +
                  "' cannot be written to: " + reason);
}

/** @brief Runs `work`, which allocates no memory and returns an error number, in a
 * process that goes on if this one is killed; in this one if there can be no other. */
template <typename Work>
int
runApart(const Work& work)
{
  const pid_t worker = fork();
  if (worker < 0)
    return work();
  if (worker == 0) {
    setsid(); // signals of the terminal do not concern it
    _exit(work());
  }
  int status = 0;
  while (waitpid(worker, &status, 0) < 0 && errno == EINTR)
    ;
  return WIFEXITED(status) ? WEXITSTATUS(status) : EINTR;
}

} // namespace

OutputFolder::OutputFolder(const std::string& path, std::vector<std::string> inputs)
    : path_(path.empty() ? throw ToolError("the output folder has no name")
                         : fs::absolute(path))
    , part_(path_ / ".pcl_sedr.part")
    , inputs_(std::move(inputs))
{
  std::error_code error;
  for (fs::path folder = path_;
       !fs::exists(fs::symlink_status(folder, error)) && folder != folder.root_path();
       folder = folder.parent_path())
    missing_.push_back(folder);
  watch();
  try {
    fs::create_directories(path_, error);
    if (error)
      refuse(path_, error.message());
    lock();
    for (const auto& entry : fs::directory_iterator(part_)) // of a run that was killed
      fs::remove_all(entry, error);
  }
  catch (...) {
    end();
    throw;
  }
}

OutputFolder::~OutputFolder()
{
  end();
}

void
OutputFolder::end() const
{
  close(lock_);
  close(alive_);
  if (watcher_ < 0 || waitpid(watcher_, nullptr, 0) < 0)
    clean();
}

/** @brief Creates the hidden folder and locks it. */
void
OutputFolder::lock()
{
  for (int tries = 0;;) { // one that was killed may still be cleaned up after
    if (mkdir(part_.c_str(), S_IRWXU | S_IRWXG | S_IRWXO) != 0 && errno != EEXIST)
      refuse(path_, std::strerror(errno));
    lock_ = open(part_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC | O_NOFOLLOW);
    if (lock_ < 0 && errno == ENOENT)
      continue; // the run that has just ended removed it
    if (lock_ < 0)
      refuse(path_, std::strerror(errno));
    if (flock(lock_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      close(std::exchange(lock_, -1));
      if (++tries == 10)
        refuse(path_, "another run is writing into it; wait for its end, or choose "
                      "another output folder");
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
      continue;
    }
    struct stat locked {};
    struct stat found {};
    fstat(lock_, &locked);
    if (stat(part_.c_str(), &found) == 0 && found.st_ino == locked.st_ino)
      return;
    close(std::exchange(lock_, -1));
  }
}

/** @brief Starts a process that cleans up when this one has ended in whatever way. */
void
OutputFolder::watch()
{
  int ends[2] = {-1, -1};
  if (pipe2(ends, O_CLOEXEC) != 0 || (watcher_ = fork()) != 0) {
    close(ends[0]);
    alive_ = ends[1];
    return;
  }
  setsid();
  for (const int signal : {SIGTERM, SIGINT, SIGHUP})
    std::signal(signal, SIG_IGN);
  close(ends[1]);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    close(stream); // others may wait for their end
  char none = 0;
  while (read(ends[0], &none, 1) < 0 && errno == EINTR)
    ;
  clean();
  _exit(0);
}

/** @brief Removes the hidden folder, unless it is that of another run, and the folders
 * that are still empty. */
void
OutputFolder::clean() const
{
  std::error_code error;
  const int part = open(part_.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW);
  int tries = part >= 0 ? 20 : 0; // a process that ends keeps its lock for a moment
  while (tries > 0 && flock(part, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    --tries;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  if (tries > 0)
    fs::remove_all(part_, error);
  close(part);
  for (const auto& folder : missing_)
    fs::remove(folder, error); // only if it is empty
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
  std::error_code error;
  fs::create_directories((part_ / name).parent_path(), error);
  return (part_ / name).string();
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

/** @brief Returns the names of an earlier run's files within the folder. */
std::vector<std::string>
OutputFolder::namesInReport() const
{
  std::ifstream stream(path_ / "report.json", std::ios::binary);
  const auto report = nlohmann::json::parse(stream, nullptr, false);
  std::vector<std::string> names;
  if (report.is_object() && report.value("format", nlohmann::json()) == "sedr-report")
    for (const auto& name : report.value("files", nlohmann::json::array()))
      if (const fs::path path = name.is_string() ? name.get<std::string>() : "";
          !path.empty() && path.is_relative() && *path.begin() != "..")
        names.push_back(path.lexically_normal().string());
  return names;
}

void
OutputFolder::exchange()
{
  const std::vector<std::string> names = written();
  check(names);
  std::vector<std::pair<std::string, std::string>> moves;
  std::error_code error;
  for (const auto& name : names) {
    moves.emplace_back(part_ / name, path_ / name);
    fs::create_directories((path_ / name).parent_path(), error);
  }
  std::vector<std::string> old;
  for (const auto& name : namesInReport())
    if (!std::binary_search(names.begin(), names.end(), name) && !isInput(path_ / name))
      old.push_back(path_ / name);
  std::vector<std::string> emptied; // folders, of which those that are empty go
  for (const auto& file : old)
    if (const fs::path folder = fs::path(file).parent_path(); folder != path_)
      emptied.push_back(folder);
  const int problem = runApart([&] {
    for (const auto& [from, to] : moves)
      if (rename(from.c_str(), to.c_str()) != 0)
        return errno;
    for (const auto& file : old)
      unlink(file.c_str());
    for (const auto& folder : emptied)
      rmdir(folder.c_str());
    return 0;
  });
  if (problem != 0)
    refuse(path_, std::strerror(problem));
}

} // namespace pcl::sedr::tools
