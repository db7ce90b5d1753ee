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

private:
  const std::uint8_t* data_ = nullptr;
  std::size_t size_ = 0;
};

} // namespace tools
} // namespace sedr
} // namespace pcl
