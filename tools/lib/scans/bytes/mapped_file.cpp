// SPDX-License-Identifier: BSD-3-Clause
#include "mapped_file.h"

#include "standard_input.h"
#include "tool_error.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace pcl::sedr::tools {

MappedFile::MappedFile(const std::string& path)
    : path_(path)
{
  const auto refuse = [&](const std::string& reason) {
    throw ToolError("cannot read '" + path + "': " + reason);
  };
  const int file = isStandardInput(path)
                       ? openStandardInput()
                       : open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (file < 0)
    refuse(errno == ENOENT ? "there is no such file" : std::strerror(errno));
  struct stat status {};
  const bool known = fstat(file, &status) == 0;
  void* mapped = MAP_FAILED;
  if (known && S_ISREG(status.st_mode) && status.st_size > 0)
    mapped = mmap(nullptr, static_cast<std::size_t>(status.st_size), PROT_READ,
                  MAP_PRIVATE, file, 0);
  const int map_error = errno;
  close(file);
  if (!known || S_ISDIR(status.st_mode))
    refuse("that is a folder, not a file");
  if (!S_ISREG(status.st_mode))
    refuse("that is no ordinary file");
  if (status.st_size == 0)
    refuse("the file is empty (0 bytes)");
  if (mapped == MAP_FAILED)
    refuse(std::strerror(map_error));
  data_ = static_cast<const std::uint8_t*>(mapped);
  size_ = static_cast<std::size_t>(status.st_size);
  device_ = status.st_dev;
  number_ = status.st_ino;
  lost_ = std::make_unique<LostPages>(data_, size_);
}

void
MappedFile::checkWhole() const
{
  // The rest of its last page reads as zeros, without a signal. Another file that has
  // taken its name does not matter.
  struct stat status {};
  const bool is_shorter = !isStandardInput(path_) &&
                          stat(path_.c_str(), &status) == 0 &&
                          status.st_dev == device_ && status.st_ino == number_ &&
                          static_cast<std::size_t>(status.st_size) < size_;
  if (!lost_->any() && !is_shorter)
    return;
  throw ToolError("'" + path_ + "' could not be read to its end: " +
                  (is_shorter ? "it has become shorter meanwhile, " +
                                    std::to_string(status.st_size) + " of its " +
                                    std::to_string(size_) + " bytes are left"
                              : "some of its " + std::to_string(size_) +
                                    " bytes cannot be had from the disk"));
}

namespace {

/** @brief Gives a hint for the pages between two bytes of a mapping; it may fail. */
void
advise(const std::uint8_t* data, std::size_t begin, std::size_t end, int advice)
{
  static const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  begin = begin / page * page;
  if (begin < end)
    madvise(const_cast<std::uint8_t*>(data) + begin, end - begin, advice);
}

} // namespace

void
MappedFile::expect(std::size_t begin, std::size_t size) const
{
  advise(data_, std::min(begin, size_), std::min(begin + size, size_), MADV_WILLNEED);
}

void
MappedFile::release(std::size_t begin, std::size_t size) const
{
  advise(data_, std::min(begin, size_), std::min(begin + size, size_), MADV_DONTNEED);
}

MappedFile::~MappedFile()
{
  lost_.reset(); // before the address range is reused
  munmap(const_cast<std::uint8_t*>(data_), size_);
}

} // namespace pcl::sedr::tools
