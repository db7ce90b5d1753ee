// SPDX-License-Identifier: BSD-3-Clause
#include "input_file.h"
#include "tool_error.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
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

/** @brief Returns the number of bytes before the end of the first line. */
std::size_t
lengthOfLine(std::string_view text)
{
  constexpr std::size_t stride = 256; // a file may have only one of the two signs
  for (std::size_t at = 0; at < text.size(); at += stride) {
    std::string_view part = text.substr(at, stride);
    const std::size_t feed = part.find('\n');
    part = part.substr(0, feed);
    const std::size_t back = part.find('\r');
    if (feed != part.npos || back != part.npos)
      return at + std::min(feed, back);
  }
  return text.size();
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

bool
takeLine(std::string_view& text, std::string_view& line)
{
  if (text.empty())
    return false;
  line = text.substr(0, lengthOfLine(text));
  text.remove_prefix(line.size());
  if (!text.empty())
    text.remove_prefix(text.substr(0, 2) == "\r\n" ? 2 : 1);
  return true;
}

bool
LineReader::next(std::string_view& line)
{
  constexpr std::size_t longest = std::size_t{1} << 20;
  constexpr std::size_t step = std::size_t{1} << 12; // bytes
  // A line feed that belongs to the carriage return at the buffer's end may follow.
  while (end_ < file_.size() && rest_.size() < longest &&
         lengthOfLine(rest_) + 1 >= rest_.size()) {
    const std::size_t kept = rest_.size();
    const std::size_t more = std::min(step + kept, file_.size() - end_);
    buffer_ = std::string(rest_) + std::string(more, '\0');
    file_.read(end_, more, buffer_.data() + kept);
    end_ += more;
    rest_ = buffer_;
  }
  return takeLine(rest_, line);
}

std::vector<std::string_view>
wordsOf(std::string_view line)
{
  constexpr std::string_view blanks = " \t\r";
  std::vector<std::string_view> words;
  for (std::size_t at = line.find_first_not_of(blanks); at != line.npos;
       at = line.find_first_not_of(blanks, at)) {
    const std::size_t end = std::min(line.find_first_of(blanks, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = end;
  }
  return words;
}

std::from_chars_result
readNumber(const char* begin, const char* end, double& value)
{
  const auto result = std::from_chars(begin, end, value);
  if (result.ec != std::errc::result_out_of_range)
    return result;
  value = std::strtod(std::string(begin, result.ptr).c_str(), nullptr);
  return {result.ptr, std::errc()};
}

} // namespace pcl::sedr::tools
