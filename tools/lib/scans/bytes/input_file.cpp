// SPDX-License-Identifier: BSD-3-Clause
#include "input_file.h"

#include "tool_error.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace pcl::sedr::tools {

namespace {

[[noreturn]] void
refuseInput(const std::string& path, const std::string& reason)
{
  throw ToolError("cannot read " +
                  (isStandardInput(path) ? "the standard input" : "'" + path + "'") +
                  ": " + reason);
}

/** @brief Returns a descriptor of the standard input that can be read anywhere: what
 * comes by a pipe is kept in memory, once per process. */
int
openStandardInput()
{
  if (isatty(STDIN_FILENO) != 0)
    refuseInput("-", "it is a terminal, a scan is to be piped into the program");
  static const int kept = [] {
    if (lseek(STDIN_FILENO, 0, SEEK_CUR) == 0)
      return STDIN_FILENO; // a file that is redirected
    const int memory = memfd_create("scan", MFD_CLOEXEC);
    std::vector<char> bytes(std::size_t{1} << 20);
    ssize_t size = 0;
    while ((size = ::read(STDIN_FILENO, bytes.data(), bytes.size())) > 0)
      if (write(memory, bytes.data(), static_cast<std::size_t>(size)) != size)
        break;
    if (size != 0)
      refuseInput("-", std::string("it cannot be kept: ") + std::strerror(errno));
    return memory;
  }();
  return fcntl(kept, F_DUPFD_CLOEXEC, 0);
}

} // namespace

InputFile::InputFile(const std::string& path)
    : path_(path)
    , file_(isStandardInput(path)
                ? openStandardInput()
                : open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK))
{
  if (file_ < 0)
    refuseInput(path, errno == ENOENT ? "there is no such file" : std::strerror(errno));
  struct stat status {};
  const bool is_known = fstat(file_, &status) == 0;
  const bool is_file = is_known && S_ISREG(status.st_mode);
  if (!is_file || status.st_size == 0) {
    close(file_);
    refuseInput(path, is_file ? "the file is empty (0 bytes)"
                      : is_known && S_ISDIR(status.st_mode)
                          ? "that is a folder, not a file"
                          : "that is no ordinary file");
  }
  size_ = static_cast<std::size_t>(status.st_size);
  posix_fadvise(file_, 0, 0, POSIX_FADV_SEQUENTIAL);
}

InputFile::InputFile(const std::string& path, std::vector<std::uint8_t> unpacked)
    : path_(path)
    , size_(unpacked.size())
    , unpacked_(std::move(unpacked))
{}

InputFile::~InputFile()
{
  if (file_ >= 0)
    close(file_);
}

void
InputFile::read(std::size_t begin, std::size_t size, void* to) const
{
  auto* bytes = static_cast<std::uint8_t*>(to);
  if (file_ < 0) {
    std::copy_n(unpacked_.data() + begin, size, bytes);
    return;
  }
  while (size > 0) {
    const ssize_t part = pread(file_, bytes, size, static_cast<off_t>(begin));
    if (part < 0 && errno == EINTR)
      continue;
    if (part <= 0)
      throw ToolError("'" + path_ + "' could not be read to its end: " +
                      (part < 0 ? std::strerror(errno)
                                : "it has become shorter meanwhile, byte " +
                                      std::to_string(begin) + " of its " +
                                      std::to_string(size_) + " bytes is missing"));
    bytes += part;
    begin += static_cast<std::size_t>(part);
    size -= static_cast<std::size_t>(part);
  }
}

bool
InputFile::beginsWith(std::string_view text) const
{
  std::string begin(std::min(text.size(), size_), '\0');
  read(0, begin.size(), begin.data());
  return begin == text;
}

} // namespace pcl::sedr::tools
