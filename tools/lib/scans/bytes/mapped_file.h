// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lost_pages.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief The bytes of a file, read as they are needed; "-" is the standard input. A
 * file that is missing, a folder or empty is a ToolError of one sentence. */
class MappedFile {
public:
  explicit MappedFile(const std::string& path);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  const std::uint8_t* data() const { return data_; }

  std::size_t size() const { return size_; }

  /** @brief Tells that these bytes will soon be read. */
  void expect(std::size_t begin, std::size_t size) const;

  /** @brief Tells that these bytes are not needed now: their pages are no longer this
   * program's, and are read again if they are. */
  void release(std::size_t begin, std::size_t size) const;

  /** @brief Throws a ToolError if bytes that were looked at could not be read: they
   * were zeros then, as the file has become shorter or its disk has failed. */
  void checkWhole() const;

private:
  std::string path_;
  const std::uint8_t* data_ = nullptr;
  std::size_t size_ = 0;
  std::unique_ptr<LostPages> lost_;
};

} // namespace tools
} // namespace sedr
} // namespace pcl
