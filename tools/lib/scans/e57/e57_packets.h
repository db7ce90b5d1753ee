// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "e57_scan.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief The bytes of one stream that hold some points, and a few more, so that eight
 * may be read at the last of them. */
struct E57Bytes {
  std::vector<std::uint8_t> bytes;
  unsigned first_bit = 0; ///< of the first value, in the first byte
};

/** @brief Where the values of a scan stand: packets of at most 64 KiB, in each of which
 * every stream has a piece; values may straddle two of them.
 *
 * All packet heads are read at first, so that afterwards any points can be had without
 * those before them; of them one in 256 KiB is remembered. What is amiss is a ToolError
 * that says why. */
class E57Packets {
public:
  /** @param wanted numbers of the fields that are read, for which there must be bytes
   * for all points */
  E57Packets(const E57Pages& pages,
             const E57Scan& scan,
             std::vector<std::size_t> wanted);

  /** @brief The bytes of the points [begin, end), a list for each wanted field; from
   * several threads at once. */
  std::vector<E57Bytes> read(std::uint64_t begin, std::uint64_t end) const;

  /** @brief Logical offset near which these points begin. */
  std::uint64_t placeOf(std::uint64_t point) const;

  /** @brief Compares the checksums of all its pages. */
  void check() const { pages_.check(begin_, end_ - begin_); }

private:
  struct Packet;
  class Walk;

  /** @brief What is wanted of a stream: bytes, counted from its begin. */
  struct Part {
    std::uint64_t begin = 0;
    std::uint64_t end = 0;
  };

  std::uint64_t bitsOf(std::size_t wanted) const
  {
    return scan_.fields[wanted_[wanted]].bits;
  }

  std::vector<Part> partsOf(std::uint64_t begin, std::uint64_t end) const;

  /** @brief The last remembered packet at or before the begin of all parts. */
  std::size_t markBefore(const std::vector<Part>& parts) const;

  void index();

  const E57Pages& pages_;
  const E57Scan& scan_;
  std::vector<std::size_t> wanted_;
  std::uint64_t begin_ = 0; ///< of the packets, logical
  std::uint64_t end_ = 0;
  std::vector<std::uint64_t> mark_places_; ///< logical offsets of remembered packets
  std::vector<std::uint64_t> mark_bytes_;  ///< of each wanted stream before them
};

} // namespace tools
} // namespace sedr
} // namespace pcl
