// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bytes/input_file.h"
#include "point_reader.h"

#include <memory>
#include <string>

namespace pcl::sedr::tools {

/** @brief Where the points of a file stand, records of one size one behind the other,
 * as its header tells. */
struct Records {
  std::string format; ///< in messages
  StoredRow row;
  std::size_t begin = 0; ///< byte of the first record
  std::uint64_t points = 0;
  std::uint64_t end = 0; ///< byte behind what may be points
  bool are_last = true;  ///< whether nothing else comes before `end`
  bool is_big_endian = false;
};

/** @brief The points of binary PCD and PLY and of LAS. */
class RecordReader : public PointReader {
public:
  /** @brief Throws ToolError if the header counts more points than there are, or fewer:
   * a whole number of records follows the last. Warns of other bytes there, unless they
   * are less than a record. */
  RecordReader(std::shared_ptr<const InputFile> file, const Records& records);

protected:
  void read(Chunk& chunk) const override;

private:
  std::shared_ptr<const InputFile> file_;
  std::size_t begin_;
  bool is_big_endian_;
};

} // namespace pcl::sedr::tools
