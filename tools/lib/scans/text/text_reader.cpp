// SPDX-License-Identifier: BSD-3-Clause
#include "text_reader.h"

#include "formats/scan_formats.h"
#include "tool_error.h"

#include "bytes/input_file.h"
#include "sedr_filters/src/base/parallel.h"

#include <algorithm>

namespace pcl::sedr::tools {

TextReader::TextReader(std::shared_ptr<const InputFile> file,
                       const TextColumns& columns)
    : file_(std::move(file))
    , columns_(columns)
{
  row_ = columns.row;
  findBlocks();
  size_ = blocks_.back().first;
  checkPoints();
  size_ = std::min<std::uint64_t>(size_, columns.points.value_or(size_));
}

void
TextReader::refuse(const std::string& reason) const
{
  throw ToolError("cannot read '" + file_->path() + "' as " + columns_.format + ": " +
                  reason);
}

void
TextReader::findBlocks()
{
  constexpr std::size_t block_bytes = std::size_t{1} << 18;
  const std::size_t bytes = file_->size() - columns_.begin;
  const std::size_t count = (bytes + block_bytes - 1) / block_bytes;
  blocks_.assign(count + 1, {file_->size(), 0});
  for (std::size_t b = 0; b < count; ++b) {
    blocks_[b].begin = columns_.begin + b * block_bytes;
    if (b == 0)
      continue;
    // Behind the line that the byte before belongs to.
    LineReader lines(*file_, blocks_[b].begin - 1);
    std::string_view line;
    lines.next(line);
    blocks_[b].begin = lines.position();
  }
  std::vector<std::size_t> points(count, 0);
  parallelBlocks(count, 1, 0, [&](std::size_t b, std::size_t) {
    const std::string text = textOf(b);
    std::string_view rest = text;
    for (std::string_view line; takeLine(rest, line);)
      points[b] += holdsPoint(line) ? 1 : 0;
  });
  for (std::size_t b = 0; b < count; ++b)
    blocks_[b + 1].first = blocks_[b].first + points[b];
}

bool
TextReader::holdsPoint(std::string_view line) const
{
  return mayHoldNumbers(line) && (columns_.points || !isCount(line));
}

std::string
TextReader::textOf(std::size_t block) const
{
  const std::size_t begin = blocks_[block].begin;
  std::string text(blocks_[block + 1].begin - begin, '\0');
  file_->read(begin, text.size(), text.data());
  if (columns_.has_decimal_commas)
    std::replace(text.begin(), text.end(), ',', '.');
  return text;
}

void
TextReader::checkPoints() const
{
  if (!columns_.points)
    return;
  const std::string promise =
      "its header promises " + std::to_string(*columns_.points) + " points, ";
  if (size_ < *columns_.points)
    refuse("the file is cut off, " + promise + "it holds " + std::to_string(size_));
  if (size_ > *columns_.points && columns_.are_last)
    refuse(promise + "but more lines follow");
}

void
TextReader::read(Chunk& chunk) const
{
  const auto isBefore = [](std::size_t row, const Block& block) {
    return row < block.first;
  };
  const auto begin =
      std::upper_bound(blocks_.begin(), blocks_.end(), chunk.first, isBefore) - 1;
  const auto end = std::upper_bound(begin, blocks_.end() - 1,
                                    chunk.first + chunk.size - 1, isBefore);
  const auto first = static_cast<std::size_t>(begin - blocks_.begin());
  chunk.rows.resize(chunk.size * row_.size);
  parallelBlocks(static_cast<std::size_t>(end - begin), 1, 0,
                 [&](std::size_t b, std::size_t) { readBlock(first + b, chunk); });
}

void
TextReader::readBlock(std::size_t block, Chunk& chunk) const
{
  const std::string text = textOf(block);
  std::vector<double> numbers(columns_.numbers);
  std::string_view rest = text;
  const std::size_t end = std::min(chunk.first + chunk.size, blocks_[block + 1].first);
  std::size_t point = blocks_[block].first;
  for (std::string_view line; point < end && takeLine(rest, line);) {
    if (!holdsPoint(line) || point++ < chunk.first)
      continue;
    readLine(line, point, numbers.data());
    auto* const row = &chunk.rows[(point - 1 - chunk.first) * row_.size];
    const std::size_t* column = columns_.columns.data();
    for (const StoredField& field : row_.fields)
      for (std::size_t k = 0; k < field.count; ++k)
        writeField(row + field.offset + k * fieldSize(field.datatype), field.datatype,
                   numbers[*column++]);
  }
  if (point < end)
    refuse("it has changed while it was read");
}

void
TextReader::readLine(std::string_view line, std::size_t point, double* numbers) const
{
  bool is_all = false;
  const std::size_t read = readColumns(line, columns_.numbers, numbers, &is_all);
  if (read < columns_.numbers || (columns_.is_exact && !is_all))
    refuse("point " + std::to_string(point) + " has " +
           (read < columns_.numbers ? std::to_string(read) + " of " : "more than ") +
           std::to_string(columns_.numbers) + " numbers");
}

ScanContent
openText(const std::shared_ptr<const InputFile>& file, const std::string& columns)
{
  ScanContent content;
  content.points =
      std::make_unique<TextReader>(file, TextColumns::find(*file, columns));
  return content;
}

} // namespace pcl::sedr::tools
