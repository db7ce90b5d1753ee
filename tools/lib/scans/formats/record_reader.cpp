// SPDX-License-Identifier: BSD-3-Clause
#include "record_reader.h"

#include "run_tool.h"

#include "sedr_filters/src/base/parallel.h"

namespace pcl::sedr::tools {

RecordReader::RecordReader(std::shared_ptr<const InputFile> file,
                           std::size_t begin,
                           std::uint64_t points,
                           const StoredRow& record,
                           bool is_big_endian)
    : file_(std::move(file))
    , begin_(begin)
    , is_big_endian_(is_big_endian)
{
  row_ = record;
  size_ = points;
}

void
RecordReader::read(Chunk& chunk) const
{
  const std::size_t bytes = chunk.size * row_.size;
  const std::size_t begin = begin_ + chunk.first * row_.size;
  chunk.rows.resize(bytes);
  file_->read(begin, bytes, chunk.rows.data());
  file_->expect(begin + bytes, bytes);
  if (is_big_endian_)
    swapBytes(chunk);
}

void
RecordReader::swapBytes(Chunk& chunk) const
{
  constexpr std::size_t rows_at_once = std::size_t{1} << 14;
  parallelBlocks(chunk.size, rows_at_once, 0, [&](std::size_t from, std::size_t to) {
    for (; from < to; ++from)
      for (const StoredField& field : row_.fields) {
        auto* const first = &chunk.rows[from * row_.size + field.offset];
        std::reverse(first, first + fieldSize(field.datatype));
      }
  });
}

bool
areMorePoints(std::uint64_t surplus, std::uint64_t record, const std::string& path)
{
  if (surplus >= record && surplus % record != 0)
    warnOnce("'" + path + "' has " + std::to_string(surplus) +
             " bytes behind its points, which are left out; no whole number of points "
             "of " +
             std::to_string(record) + " bytes");
  return surplus >= record && surplus % record == 0;
}

} // namespace pcl::sedr::tools
