// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief The bytes of a file, read as they are needed. A file that is missing, a
 * folder or empty is a ToolError of one sentence. */
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

private:
  const std::uint8_t* data_ = nullptr;
  std::size_t size_ = 0;
};

} // namespace tools
} // namespace sedr
} // namespace pcl
