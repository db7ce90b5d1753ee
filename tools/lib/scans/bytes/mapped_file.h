// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lost_pages.h"

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace pcl::sedr::tools {

/** @brief The bytes of a file, mapped on demand; "-" is the standard input. Throws
 * ToolError if the file is missing, a folder or empty. */
class MappedFile {
public:
  explicit MappedFile(const std::string& path);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  const std::uint8_t* data() const { return data_; }

  std::size_t size() const { return size_; }

  /** @brief Announces that these bytes will soon be read. */
  void expect(std::size_t begin, std::size_t size) const;

  /** @brief Releases the pages of bytes that are not needed now; they are read again on
   * access. */
  void release(std::size_t begin, std::size_t size) const;

  /** @brief Throws ToolError if accessed bytes could not be read and became zeros, as
   * the file has shrunk or its disk failed. */
  void checkWhole() const;

private:
  std::string path_;
  const std::uint8_t* data_ = nullptr;
  std::size_t size_ = 0;
  dev_t device_ = 0; ///< with number_ the file itself, whatever its name
  ino_t number_ = 0;
  std::unique_ptr<LostPages> lost_;
};

} // namespace pcl::sedr::tools
