// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bytes/mapped_file.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief The bytes of an E57 file (ASTM E2807) without the checksums at the end of its
 * pages, which are compared as they are passed. Offsets are counted without them
 * (logical) unless they are called physical. What is amiss is a ToolError that says
 * why, without the name of the file. */
class E57Pages {
public:
  /** @brief Reads the 48 bytes that every E57 file begins with. */
  explicit E57Pages(const MappedFile& file);

  /** @brief Bytes without checksums. */
  std::uint64_t size() const { return pages_ * payload_; }

  std::uint64_t xmlBegin() const { return xml_begin_; }
  std::uint64_t xmlSize() const { return xml_size_; }

  /** @brief The logical offset of the physical one; `what` begins there, in words. */
  std::uint64_t logical(std::uint64_t physical, const std::string& what) const;

  /** @brief The physical offset of the logical one. */
  std::uint64_t physical(std::uint64_t logical) const
  {
    return logical / payload_ * page_size_ + logical % payload_;
  }

  /** @brief Copies bytes, and compares the checksums of their pages; from several
   * threads at once. */
  void copy(std::uint64_t begin, std::size_t size, std::uint8_t* to) const;

  /** @brief Compares the checksums of the pages of these bytes. */
  void check(std::uint64_t begin, std::uint64_t size) const;

private:
  void checkPage(std::uint64_t page) const;

  const MappedFile& file_;
  std::uint64_t page_size_ = 0;
  std::uint64_t payload_ = 0; ///< bytes of a page without its checksum
  std::uint64_t pages_ = 0;
  std::uint64_t xml_begin_ = 0;
  std::uint64_t xml_size_ = 0;
};

bool looksLikeE57(const MappedFile& file);

} // namespace tools
} // namespace sedr
} // namespace pcl
