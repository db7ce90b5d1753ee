// SPDX-License-Identifier: BSD-3-Clause
#include "standard_input.h"

#include "tool_error.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <vector>

namespace pcl::sedr::tools {

namespace {

[[noreturn]] void
refuse(const std::string& reason)
{
  throw ToolError("cannot read the standard input: " + reason);
}

int
namelessFile()
{
  const char* asked = std::getenv("TMPDIR");
  const std::string folder = asked && *asked != '\0' ? asked : "/tmp";
  std::string name = folder + "/sedr_input_XXXXXX";
  const int file = mkstemp(name.data());
  if (file < 0)
    refuse("no file for it can be made in '" + folder + "': " + std::strerror(errno));
  unlink(name.c_str());
  return file;
}

void
writeAll(int file, const char* bytes, std::size_t size)
{
  while (size > 0) {
    const ssize_t written = write(file, bytes, size);
    if (written < 0 && errno == EINTR)
      continue;
    if (written <= 0)
      refuse(std::string("what was read cannot be kept: ") + std::strerror(errno));
    bytes += written;
    size -= static_cast<std::size_t>(written);
  }
}

int
keptInput()
{
  if (isatty(STDIN_FILENO) != 0)
    refuse("it is a terminal, a scan is to be piped into the program");
  const int file = namelessFile();
  std::vector<char> bytes(std::size_t{1} << 20);
  for (;;) {
    const ssize_t size = read(STDIN_FILENO, bytes.data(), bytes.size());
    if (size < 0 && errno == EINTR)
      continue;
    if (size < 0)
      refuse(std::strerror(errno));
    if (size == 0)
      return file;
    writeAll(file, bytes.data(), static_cast<std::size_t>(size));
  }
}

} // namespace

int
openStandardInput()
{
  static const int kept = keptInput();
  const int file = fcntl(kept, F_DUPFD_CLOEXEC, 0);
  if (file < 0)
    refuse(std::strerror(errno));
  return file;
}

} // namespace pcl::sedr::tools
