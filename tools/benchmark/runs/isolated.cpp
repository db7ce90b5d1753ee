// SPDX-License-Identifier: BSD-3-Clause
#include "isolated.h"

#ifdef __linux__
#include <sys/prctl.h>
#endif
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <stdexcept>

namespace pcl::sedr::benchmark {

namespace {

void
writeAll(int file, const std::string& text)
{
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t n = write(file, text.data() + done, text.size() - done);
    if (n <= 0 && errno != EINTR)
      return; // the caller has ended
    done += n > 0 ? static_cast<std::size_t>(n) : 0;
  }
}

std::string
readAll(int file)
{
  std::string text;
  std::array<char, 4096> buffer{};
  for (;;) {
    const ssize_t n = read(file, buffer.data(), buffer.size());
    if (n > 0)
      text.append(buffer.data(), static_cast<std::size_t>(n));
    else if (n == 0 || errno != EINTR)
      return text;
  }
}

/** @brief Runs the work in the child process. It never returns to the caller's code,
 * because it must not touch the caller's files and buffers. */
[[noreturn]] void
work(const std::function<void()>& work, int answer)
{
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL); // the result is useless without the caller
#endif
  try {
    work();
    _exit(0);
  }
  catch (const std::exception& error) {
    writeAll(answer, error.what());
  }
  catch (...) {
    writeAll(answer, "failed for an unknown reason");
  }
  _exit(1);
}

int
waitFor(pid_t process)
{
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

} // namespace

void
runIsolated(const std::function<void()>& task)
{
  int ends[2];
  if (pipe(ends) != 0)
    throw std::runtime_error(std::string("no pipe could be made: ") +
                             std::strerror(errno));
  std::fflush(nullptr); // otherwise the child process writes the buffered text again
  const pid_t process = fork();
  if (process == 0) {
    close(ends[0]);
    work(task, ends[1]);
  }
  const int error = errno;
  close(ends[1]);
  const std::string answer = process > 0 ? readAll(ends[0]) : "";
  close(ends[0]);
  if (process < 0)
    throw std::runtime_error(std::string("no process could be started: ") +
                             std::strerror(error));
  const int status = waitFor(process);
  if (WIFSIGNALED(status))
    throw std::runtime_error("the run was ended by signal " +
                             std::to_string(WTERMSIG(status)) + " (" +
                             strsignal(WTERMSIG(status)) + ")");
  if (WEXITSTATUS(status) != 0)
    throw std::runtime_error(answer);
}

} // namespace pcl::sedr::benchmark
