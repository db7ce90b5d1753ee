// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "e57_scan.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Bytes of one stream for a range of points, padded so that eight can be read
 * at the last one. */
struct E57Bytes {
  std::vector<std::uint8_t> bytes;
  unsigned first_bit = 0; ///< position of the first value in the first byte
};

/** @brief Locates the values of a scan. They are stored in packets of at most 64 KiB
 * with a piece of every stream; values may straddle two packets.
 *
 * All packet headers are read at first, so that any points can be read without those
 * before them. One packet per 256 KiB is remembered. Throws ToolError with a reason on
 * failure. */
class E57Packets {
public:
  /** @param wanted numbers of the fields to read, which must have bytes for all
   * points */
  E57Packets(const E57Pages& pages,
             const E57Scan& scan,
             std::vector<std::size_t> wanted);

  /** @brief Returns the bytes of the points [begin, end), a list per wanted field;
   * thread-safe. */
  std::vector<E57Bytes> read(std::uint64_t begin, std::uint64_t end) const;

  /** @brief Returns the approximate logical offset of a point. */
  std::uint64_t placeOf(std::uint64_t point) const;

  /** @brief Verifies the checksums of all its pages. */
  void check() const { pages_.check(begin_, end_ - begin_); }

private:
  struct Packet;
  class Walk;

  /** @brief A wanted range of a stream: bytes from its beginning. */
  struct Part {
    std::uint64_t begin = 0;
    std::uint64_t end = 0;
  };

  std::uint64_t bitsOf(std::size_t wanted) const
  {
    return scan_.fields[wanted_[wanted]].bits;
  }

  std::vector<Part> partsOf(std::uint64_t begin, std::uint64_t end) const;

  /** @brief Returns the last remembered packet at or before the beginning of all
   * parts. */
  std::size_t markBefore(const std::vector<Part>& parts) const;

  /** @brief Locates the packets, and checks the number of points. */
  void index();

  /** @brief Throws ToolError unless the streams have the bytes for all points, and not
   * for more. */
  void checkCount(const std::vector<std::uint64_t>& seen) const;

  const E57Pages& pages_;
  const E57Scan& scan_;
  std::vector<std::size_t> wanted_;
  std::uint64_t begin_ = 0; ///< of the packets, logical
  std::uint64_t end_ = 0;
  std::vector<std::uint64_t> mark_places_; ///< logical offsets of remembered packets
  std::vector<std::uint64_t> mark_bytes_;  ///< per wanted stream, before these packets
};

} // namespace pcl::sedr::tools
