// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bytes/input_file.h"
#include "point_reader.h"

#include <memory>

namespace pcl::sedr::tools {

/** @brief Points that are records of one size, one behind the other: those of binary
 * PCD and PLY and of LAS. */
class RecordReader : public PointReader {
public:
  /** @param begin byte of the first record */
  RecordReader(std::shared_ptr<const InputFile> file,
               std::size_t begin,
               std::uint64_t points,
               const StoredRow& record,
               bool is_big_endian = false);

protected:
  void read(Chunk& chunk) const override;

private:
  void swapBytes(Chunk& chunk) const;

  std::shared_ptr<const InputFile> file_;
  std::size_t begin_;
  bool is_big_endian_;
};

/** @brief Tells what the bytes behind the points of a file are: more points than its
 * header promises, if they are a whole number of `record` bytes. Else prints a warning
 * that the file has bytes of something else, unless it is less than a point. */
bool
areMorePoints(std::uint64_t surplus, std::uint64_t record, const std::string& path);

} // namespace pcl::sedr::tools
