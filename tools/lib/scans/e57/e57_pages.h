// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bytes/input_file.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace pcl::sedr::tools {

/** @brief The bytes of an E57 file (ASTM E2807) without the checksums at the end of its
 * pages, which are verified on reading. Offsets exclude checksums (logical) unless
 * called physical. Throws ToolError with a reason, without the file name. */
class E57Pages {
public:
  /** @brief Reads the header of 48 bytes. */
  explicit E57Pages(std::shared_ptr<const InputFile> file);

  /** @brief Returns the number of bytes without checksums. */
  std::uint64_t size() const { return pages_ * payload_; }

  std::uint64_t xmlBegin() const { return xml_begin_; }
  std::uint64_t xmlSize() const { return xml_size_; }

  /** @brief Converts a physical offset to a logical one; `what` names its content in
   * errors. */
  std::uint64_t logical(std::uint64_t physical, const std::string& what) const;

  /** @brief Converts a logical offset to a physical one. */
  std::uint64_t physical(std::uint64_t logical) const
  {
    return logical / payload_ * page_size_ + logical % payload_;
  }

  /** @brief Copies bytes and verifies the checksums of their pages; thread-safe. */
  void read(std::uint64_t begin, std::size_t size, void* to) const;

private:
  /** @brief Verifies the checksums of `count` pages from `first` on. */
  void check(std::uint64_t first, std::size_t count, const std::uint8_t* bytes) const;

  std::shared_ptr<const InputFile> file_;
  std::uint64_t page_size_ = 0;
  std::uint64_t payload_ = 0; ///< bytes per page without its checksum
  std::uint64_t pages_ = 0;
  std::uint64_t xml_begin_ = 0;
  std::uint64_t xml_size_ = 0;
};

} // namespace pcl::sedr::tools
