// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "e57_scan.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace pcl::sedr::tools {

/** @brief The values of a field for a range of points. */
class E57Values {
public:
  /** @brief Reads the values [first, first + size), relative to the first one in the
   * range, scaled. */
  void read(std::size_t first, std::size_t size, double* values) const;

private:
  friend class E57Packets;
  const E57Field* field_ = nullptr;
  std::vector<std::uint8_t> bytes_; ///< padded, so that eight can be read at the last
  unsigned first_bit_ = 0;          ///< of the first value in the first byte
};

/** @brief Locates the values of a scan. They are stored in packets of at most 64 KiB
 * with a piece of the stream of every field; values may straddle two packets.
 *
 * All packet headers are read at first, so that any points can be read without those
 * before them. One packet per 64 KiB is remembered. Throws ToolError with a reason on
 * failure. */
class E57Packets {
public:
  /** @param wanted numbers of the fields to read */
  E57Packets(const E57Pages& pages,
             const E57Scan& scan,
             const std::vector<std::size_t>& wanted);

  /** @brief Returns the values of the points [begin, end) for each wanted field, in
   * their order; thread-safe. */
  std::vector<E57Values> read(std::uint64_t begin, std::uint64_t end) const;

  /** @brief Verifies the checksums of all its pages. */
  void check() const;

private:
  /** @brief A data packet with the piece of each wanted stream. */
  struct Packet {
    std::uint64_t place = 0; ///< logical
    std::size_t size = 0;    ///< bytes
    std::vector<std::size_t> begins;
    std::vector<std::size_t> sizes;
  };

  /** @brief A packet that is remembered. */
  struct Mark {
    std::uint64_t place = 0;         ///< logical
    std::vector<std::uint64_t> seen; ///< bytes of each wanted stream before it
  };

  /** @brief Copies bytes of the file from a logical offset. */
  using Read = std::function<void(std::uint64_t begin, std::size_t size, void* to)>;

  /** @brief Reads the header of the next data packet from `place` on, and moves that
   * behind it; false if there is none. */
  bool next(std::uint64_t& place, const Read& read, Packet& packet) const;
  void readPieces(std::size_t streams, const Read& read, Packet& packet) const;

  /** @brief Locates the packets, and checks the number of points. */
  void index();

  /** @brief Throws ToolError unless the streams have the bytes for all points, and not
   * for more. */
  void checkCount(const std::vector<std::uint64_t>& seen) const;

  const E57Field& field(std::size_t wanted) const
  {
    return scan_.fields[wanted_[wanted]];
  }

  /** @brief Returns the last mark before the beginnings of all parts, or the first
   * behind their ends. */
  std::size_t markAt(std::uint64_t point, bool is_end) const;

  const E57Pages& pages_;
  const E57Scan& scan_;
  std::vector<std::size_t> wanted_;
  std::uint64_t begin_ = 0; ///< of the packets, logical
  std::uint64_t end_ = 0;
  std::vector<Mark> marks_; ///< the last one at the end
};

} // namespace pcl::sedr::tools
