// SPDX-License-Identifier: BSD-3-Clause
#include "text_reader.h"

#include "cloud_readers.h"
#include "tool_error.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace pcl::sedr::tools {

TextReader::TextReader(const MappedFile& file,
                       const std::string& path,
                       const std::string& columns)
    : file_(file)
    , path_(path)
    , columns_(findColumns(file, path, columns))
{
  layFields();
  countLines();
}

void
TextReader::layFields()
{
  const auto& names = columns_.names;
  const auto columnOf = [&](const std::string& name) {
    const auto it = std::find(names.begin(), names.end(), name);
    return static_cast<std::size_t>(it - names.begin());
  };
  for (const char* axis : {"x", "y", "z"})
    xyz_.push_back(columnOf(axis));
  for (const char* name : {"blue", "green", "red"})
    colour_.push_back(columnOf(name));
  if (*std::max_element(colour_.begin(), colour_.end()) == names.size())
    colour_.clear();
  std::vector<std::string> more;
  for (std::size_t c = 0; c < names.size(); ++c) {
    const bool is_taken = std::count(xyz_.begin(), xyz_.end(), c) > 0 ||
                          std::count(colour_.begin(), colour_.end(), c) > 0;
    if (is_taken || names[c] == "_")
      continue;
    others_.push_back(c);
    more.push_back(names[c]);
  }
  if (!colour_.empty())
    more.emplace_back("rgb");
  fields_ = decodedFields(more);
}

void
TextReader::countLines()
{
  constexpr std::size_t stride = std::size_t{1} << 16; // bytes
  TextCursor cursor(file_, columns_.begin);
  std::size_t place = columns_.begin;
  std::uint64_t promised = columns_.promised;
  std::size_t begin = 0; // first row of those that are promised
  for (std::string_view line; cursor.nextLine(line); place = cursor.position()) {
    std::uint64_t count = 0;
    if (columns_.has_counts && readCount(line, count)) {
      checkCount(promised, begin);
      promised = count;
      begin = size_;
    }
    if (!holdsPoint(line))
      continue;
    if (marks_.empty() || place - marks_.back().place >= stride)
      marks_.push_back({place, size_});
    ++size_;
  }
  checkCount(promised, begin);
}

bool
TextReader::holdsPoint(std::string_view line) const
{
  std::uint64_t count = 0;
  return mayHoldNumbers(line) && !(columns_.has_counts && readCount(line, count));
}

void
TextReader::checkCount(std::uint64_t promised, std::size_t begin) const
{
  if (columns_.has_counts && promised != size_ - begin)
    throw ToolError("cannot read '" + path_ +
                    "' as columns of numbers: " + std::to_string(promised) +
                    " points are promised before point " + std::to_string(begin + 1) +
                    ", but " + std::to_string(size_ - begin) + " follow");
}

const TextReader::Mark&
TextReader::markBefore(std::size_t row) const
{
  const auto it =
      std::upper_bound(marks_.begin(), marks_.end(), row,
                       [](std::size_t r, const Mark& mark) { return r < mark.row; });
  return *(it - 1);
}

std::size_t
TextReader::placeOf(std::size_t row) const
{
  return row >= size_ ? file_.size() : markBefore(row).place;
}

void
TextReader::read(std::size_t first, std::size_t size, std::uint8_t* rows) const
{
  const std::size_t columns = columns_.names.size();
  const bool is_exact = columns_.is_nothing_else;
  const std::size_t expected = is_exact ? columns_.numbers : columns;
  std::vector<double> numbers(std::max(expected, columns));
  const std::size_t row_size =
      xyz_.size() * sizeof(double) + (fields_.size() - xyz_.size()) * sizeof(float);
  const Mark& mark = markBefore(first);
  TextCursor cursor(file_, mark.place);
  std::size_t row = mark.row;
  for (std::string_view line; row < first + size && cursor.nextLine(line);) {
    if (!holdsPoint(line))
      continue;
    if (row++ < first)
      continue;
    bool is_all = false;
    const std::size_t read = readColumns(line, columns_.has_decimal_comma, expected,
                                         numbers.data(), &is_all);
    if (read < expected || (is_exact && !is_all))
      throw ToolError("cannot read '" + path_ + "' as columns of numbers: point " +
                      std::to_string(row) + " has " +
                      (read < expected ? std::to_string(read) + " of " : "more than ") +
                      std::to_string(expected) + " numbers");
    writeRow(numbers.data(), rows + (row - 1 - first) * row_size);
  }
  if (row < first + size)
    throw ToolError("cannot read '" + path_ +
                    "' as columns of numbers: it ends after " + std::to_string(row) +
                    " of " + std::to_string(size_) + " points");
}

void
TextReader::writeRow(const double* numbers, std::uint8_t* row) const
{
  for (const std::size_t column : xyz_) {
    std::memcpy(row, &numbers[column], sizeof(double));
    row += sizeof(double);
  }
  for (const std::size_t column : others_) {
    const auto value = static_cast<float>(numbers[column]);
    std::memcpy(row, &value, sizeof value);
    row += sizeof value;
  }
  if (colour_.empty())
    return;
  constexpr double most = 255;
  for (std::size_t k = 0; k < colour_.size(); ++k) {
    const double value = numbers[colour_[k]];
    row[k] = static_cast<std::uint8_t>(value >= most ? most
                                       : value > 0   ? std::round(value)
                                                     : 0);
  }
  row[3] = 0xff;
}

} // namespace pcl::sedr::tools
