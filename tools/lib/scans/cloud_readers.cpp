// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_readers.h"

#include "run_tool.h"
#include "tool_error.h"

#include "sedr_filters/src/base/field_access.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <limits>

namespace pcl::sedr::tools {

namespace {

bool
isBlank(char c)
{
  return c == ' ' || c == '\t' || c == '\r';
}

/** @brief Returns the number of bytes before the end of a line, at most `left`. */
std::size_t
lengthOfLine(const char* begin, std::size_t left)
{
  constexpr std::size_t stride = 256; // a file may have only one of the two signs
  for (std::size_t at = 0; at < left; at += stride) {
    std::size_t size = std::min(stride, left - at);
    const auto* feed = static_cast<const char*>(std::memchr(begin + at, '\n', size));
    if (feed)
      size = static_cast<std::size_t>(feed - begin) - at;
    const auto* back = static_cast<const char*>(std::memchr(begin + at, '\r', size));
    if (feed || back)
      return static_cast<std::size_t>((back ? back : feed) - begin);
  }
  return left;
}

} // namespace

bool
TextCursor::nextLine(std::string_view& line)
{
  if (position_ >= file_.size())
    return false;
  const char* begin = reinterpret_cast<const char*>(file_.data()) + position_;
  const std::size_t left = file_.size() - position_;
  const std::size_t length = lengthOfLine(begin, left);
  position_ += length;
  if (length < left)
    position_ +=
        begin[length] == '\r' && length + 1 < left && begin[length + 1] == '\n' ? 2 : 1;
  line = {begin, length};
  return true;
}

std::vector<std::string_view>
wordsOf(std::string_view line)
{
  std::vector<std::string_view> words;
  const char* c = line.data();
  const char* const end = c + line.size();
  while (c != end) {
    c = std::find_if_not(c, end, isBlank);
    const char* const word_end = std::find_if(c, end, isBlank);
    if (c != word_end)
      words.emplace_back(c, static_cast<std::size_t>(word_end - c));
    c = word_end;
  }
  return words;
}

std::from_chars_result
readNumber(const char* begin, const char* end, double& value)
{
  const auto result = std::from_chars(begin, end, value);
  if (result.ec != std::errc::result_out_of_range)
    return result;
  value = std::strtod(std::string(begin, result.ptr).c_str(), nullptr);
  return {result.ptr, std::errc()};
}

void
readNumbers(std::string_view line,
            const pcl::PCLPointCloud2& blob,
            const std::string& path,
            std::size_t point,
            std::uint8_t* row)
{
  const char* c = line.data();
  const char* const end = c + line.size();
  std::size_t values = 0;
  for (const auto& field : blob.fields)
    values += field.count;
  const auto refuse = [&](const std::string& found) {
    throw ToolError("cannot read '" + path + "': point " + std::to_string(point + 1) +
                    " has " + found + " numbers");
  };
  std::size_t read = 0;
  const auto readValue = [&](const pcl::PCLPointField& field, std::uint8_t* to) {
    c = std::find_if_not(c, end, isBlank);
    if (c != end && *c == '+')
      ++c;
    double value = 0;
    const auto result = readNumber(c, end, value);
    if (result.ec != std::errc() || (result.ptr != end && !isBlank(*result.ptr)))
      refuse(std::to_string(read) + " of " + std::to_string(values));
    c = result.ptr;
    writeField(to, field.datatype, value);
    ++read;
  };
  for (const auto& field : blob.fields)
    for (std::size_t k = 0; k < field.count; ++k)
      readValue(field, row + field.offset + k * fieldSize(field.datatype));
  if (std::find_if_not(c, end, isBlank) != end)
    refuse("more than " + std::to_string(values));
}

pcl::PCLPointCloud2
readPoints(const MappedFile& file, const FileLayout& layout, const std::string& path)
{
  pcl::PCLPointCloud2 blob = layout.blob;
  if (layout.data == FileData::Compressed)
    readCompressedPcd(file, layout, path, blob);
  else if (layout.data == FileData::Ascii)
    layout.is_ply ? readAsciiPly(file, layout, path, blob)
                  : readAsciiPcd(file, layout, path, blob);
  else {
    const auto* first = file.data() + layout.begin;
    blob.data.assign(first, first + std::size_t{blob.width} * blob.point_step);
  }
  return blob;
}

bool
areMorePoints(std::uint64_t surplus, std::uint64_t row, const std::string& path)
{
  if (surplus >= row && surplus % row != 0)
    warnOnce("'" + path + "' has " + std::to_string(surplus) +
             " bytes behind its points, which are left out; no whole number of points "
             "of " +
             std::to_string(row) + " bytes");
  return surplus >= row && surplus % row == 0;
}

void
layOut(pcl::PCLPointCloud2& blob, std::uint64_t points, const std::string& path)
{
  constexpr std::uint64_t most = 0x7fffffff;
  if (points > most)
    throw ToolError("'" + path + "' promises " + std::to_string(points) +
                    " points, more than 2147483647 cannot be indexed");
  if (points == 0)
    throw ToolError("'" + path + "' has 0 points");
  std::size_t step = 0;
  for (auto& field : blob.fields) {
    field.offset = static_cast<pcl::uindex_t>(step);
    step += fieldSize(field.datatype) * field.count;
  }
  if (step == 0)
    throw ToolError("'" + path + "' promises " + std::to_string(points) +
                    " points of 0 bytes: it has no field");
  constexpr std::size_t largest = std::numeric_limits<pcl::uindex_t>::max();
  if (step > largest)
    throw ToolError("'" + path + "' promises points of " + std::to_string(step) +
                    " bytes, at most " + std::to_string(largest) + " can be read");
  blob.point_step = static_cast<pcl::uindex_t>(step);
  blob.height = 1;
  blob.width = static_cast<pcl::uindex_t>(points);
  blob.row_step = blob.width * blob.point_step;
  blob.is_dense = 0;
}

} // namespace pcl::sedr::tools
