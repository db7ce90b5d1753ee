// SPDX-License-Identifier: BSD-3-Clause
#include "record_reader.h"

#include "run_tool.h"
#include "tool_error.h"

#include "sedr_filters/src/base/parallel.h"

namespace pcl::sedr::tools {

RecordReader::RecordReader(std::shared_ptr<const InputFile> file,
                           const Records& records)
    : file_(std::move(file))
    , begin_(records.begin)
    , is_big_endian_(records.is_big_endian)
{
  row_ = records.row;
  size_ = records.points;
  if (row_.size == 0) // which lacks x, as is told later
    return;
  const std::uint64_t bytes = records.end - records.begin;
  const auto refuse = [&](const std::string& reason) {
    throw ToolError("cannot read '" + file_->path() + "' as " + records.format + ": " +
                    reason + "its header promises " + std::to_string(size_) +
                    " points of " + std::to_string(row_.size) + " bytes, but " +
                    std::to_string(bytes) + " bytes follow");
  };
  if (size_ > bytes / row_.size)
    refuse("the file is cut off, ");
  const std::uint64_t surplus = bytes - size_ * row_.size;
  if (!records.are_last || size_ == 0 || surplus < row_.size)
    return;
  if (surplus % row_.size == 0)
    refuse("");
  warnOnce("'" + file_->path() + "' has " + std::to_string(surplus) +
           " bytes behind its points, which are left out; no whole number of points "
           "of " +
           std::to_string(row_.size) + " bytes");
}

void
RecordReader::read(Chunk& chunk) const
{
  constexpr std::size_t rows_at_once = std::size_t{1} << 14;
  chunk.rows.resize(chunk.size * row_.size);
  file_->read(begin_ + chunk.first * row_.size, chunk.rows.size(), chunk.rows.data());
  if (is_big_endian_)
    parallelFor(chunk.size, rows_at_once, 0, [&](std::size_t i) {
      for (const StoredField& field : row_.fields) {
        auto* const first = &chunk.rows[i * row_.size + field.offset];
        std::reverse(first, first + fieldSize(field.datatype));
      }
    });
}

} // namespace pcl::sedr::tools
