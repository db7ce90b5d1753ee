// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "e57_scan.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr::tools {

/** @brief The values of a field for a range of points. */
struct E57Values {
  const E57Field* field = nullptr; ///< null: the scan does not have it
  std::vector<std::uint8_t> bytes; ///< padded, so that nine can be read at the last
  unsigned first_bit = 0;          ///< of the first value in the first byte

  /** @brief Reads the values [first, first + size), relative to the first one in the
   * range, scaled. */
  void read(std::size_t first, std::size_t size, double* values) const;
};

/** @brief Locates the values of a scan. They are stored in packets of at most 64 KiB
 * with a piece of the stream of every field; values may straddle two packets.
 *
 * All packet headers are read at first, so that any points can be read without those
 * before them. Throws ToolError with a reason on failure. */
class E57Streams {
public:
  /** @param fields numbers of the fields to read; -1 for none */
  E57Streams(const E57Pages& pages,
             const E57Scan& scan,
             const std::vector<int>& fields);

  /** @brief Returns the values of the points [begin, end) for each field, in their
   * order; thread-safe. */
  std::vector<E57Values> read(std::uint64_t begin, std::uint64_t end) const;

  /** @brief Verifies the checksums of all pages of the scan. */
  void check() const;

private:
  /** @brief A part of a stream in one packet. */
  struct Piece {
    std::uint64_t place = 0; ///< logical
    std::uint64_t first = 0; ///< bytes of the stream before it
  };

  void findPieces();
  void addPieces(std::uint64_t packet, std::size_t size, std::size_t streams);

  /** @brief Throws ToolError unless the streams have the bytes for all points, and not
   * for more. */
  void checkCount() const;

  const E57Pages& pages_;
  const E57Scan& scan_;
  std::vector<const E57Field*> fields_; ///< null for none
  std::vector<int> numbers_;
  std::uint64_t begin_ = 0; ///< of the packets, logical
  std::uint64_t end_ = 0;
  std::vector<std::vector<Piece>> pieces_; ///< by field; the last one at the end
};

} // namespace pcl::sedr::tools
