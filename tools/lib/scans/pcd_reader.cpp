// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_readers.h"
#include "plain_text.h"
#include "tool_error.h"

#include "sedr_filters/src/base/field_access.h"
#include <pcl/io/lzf.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <map>

namespace pcl::sedr::tools {

namespace {

using Words = std::vector<std::string_view>;

/** @brief Header lines by keyword, and the offset of the data. */
struct PcdHeader {
  std::map<std::string, Words, std::less<>> lines;
  std::size_t data_begin = 0;
  Origin origin;   ///< from a comment
  Words viewpoint; ///< from a comment, empty if there is none

  const Words* find(std::string_view keyword) const
  {
    const auto it = lines.find(keyword);
    return it == lines.end() ? nullptr : &it->second;
  }
};

[[noreturn]] void
refusePcd(const std::string& path, const std::string& reason)
{
  throw ToolError("cannot read '" + path + "' as PCD: " + reason);
}

bool
isKeyword(std::string_view word)
{
  constexpr std::array<std::string_view, 11> keywords{
      "VERSION", "FIELDS", "COLUMNS",   "SIZE",   "TYPE", "COUNT",
      "WIDTH",   "HEIGHT", "VIEWPOINT", "POINTS", "DATA"};
  return std::find(keywords.begin(), keywords.end(), word) != keywords.end();
}

PcdHeader
readPcdHeader(const MappedFile& file, const std::string& path)
{
  PcdHeader header;
  TextCursor cursor(file, 0);
  for (std::string_view line; cursor.nextLine(line);) {
    const Words words = wordsOf(line);
    if (!words.empty() && words[0][0] == '#')
      Origin::fromComment(std::string(line.substr(0, 256)), header.origin);
    if (words.size() > 2 && words[0] == "#" && words[1] == "sedr_viewpoint")
      header.viewpoint.assign(words.begin() + 2, words.end());
    if (words.empty() || words[0][0] == '#')
      continue;
    if (!isKeyword(words[0]))
      refusePcd(path, "its header holds a line that is none, before DATA");
    const std::string keyword(words[0] == "COLUMNS" ? "FIELDS" : words[0]);
    header.lines[keyword] = Words(words.begin() + 1, words.end());
    if (keyword == "DATA") {
      header.data_begin = cursor.position();
      return header;
    }
  }
  refusePcd(path, "its header ends without a DATA line, the file may be cut off");
}

std::uint64_t
wholeNumber(std::string_view word, const std::string& what, const std::string& path)
{
  std::uint64_t value = 0;
  const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
  if (result.ec != std::errc() || result.ptr != word.data() + word.size())
    refusePcd(path, what + " is " + quotedWord(word) + ", not a whole number");
  return value;
}

std::uint8_t
dataType(char type, std::uint64_t size)
{
  using Field = pcl::PCLPointField;
  const std::map<std::pair<char, std::uint64_t>, std::uint8_t> types{
      {{'I', 1}, Field::INT8},    {{'I', 2}, Field::INT16},  {{'I', 4}, Field::INT32},
      {{'I', 8}, Field::INT64},   {{'U', 1}, Field::UINT8},  {{'U', 2}, Field::UINT16},
      {{'U', 4}, Field::UINT32},  {{'U', 8}, Field::UINT64}, {{'F', 4}, Field::FLOAT32},
      {{'F', 8}, Field::FLOAT64}, {{'B', 1}, Field::BOOL}};
  const auto it = types.find({type, size});
  return it == types.end() ? 0 : it->second;
}

std::vector<pcl::PCLPointField>
readFields(const PcdHeader& header, const std::string& path)
{
  const Words* names = header.find("FIELDS");
  const Words* sizes = header.find("SIZE");
  const Words* types = header.find("TYPE");
  const Words* counts = header.find("COUNT");
  if (!names || !sizes || !types)
    refusePcd(path, "its header lacks FIELDS, SIZE or TYPE");
  if (sizes->size() != names->size() || types->size() != names->size() ||
      (counts && counts->size() != names->size()))
    refusePcd(path, "its header names " + std::to_string(names->size()) +
                        " fields, but " + std::to_string(sizes->size()) + " sizes, " +
                        std::to_string(types->size()) + " types and " +
                        std::to_string(counts ? counts->size() : 0) + " counts");
  constexpr std::uint64_t max_values = 1 << 16;
  std::vector<pcl::PCLPointField> fields;
  for (std::size_t i = 0; i < names->size(); ++i) {
    pcl::PCLPointField field;
    field.name = std::string((*names)[i]);
    const auto count = counts ? wholeNumber((*counts)[i], "a COUNT", path) : 1;
    field.datatype = dataType((*types)[i][0], wholeNumber((*sizes)[i], "a SIZE", path));
    if (field.datatype == 0 || count == 0 || count > max_values)
      refusePcd(path, "field " + quotedWord(field.name) + " is of type " +
                          quotedWord((*types)[i]) + ", size " +
                          quotedWord((*sizes)[i]) + ", count " + std::to_string(count) +
                          ", which is unknown");
    field.count = static_cast<pcl::uindex_t>(count);
    fields.push_back(field);
  }
  return fields;
}

std::uint64_t
readSize(const PcdHeader& header, const std::string& path)
{
  const auto number = [&](const char* keyword, std::uint64_t otherwise) {
    const Words* words = header.find(keyword);
    return words && !words->empty() ? wholeNumber(words->front(), keyword, path)
                                    : otherwise;
  };
  if (!header.find("WIDTH") && !header.find("POINTS"))
    refusePcd(path, "its header lacks WIDTH and POINTS");
  const std::uint64_t height = number("HEIGHT", 1);
  const std::uint64_t points = number("POINTS", number("WIDTH", 0) * height);
  const std::uint64_t width = number("WIDTH", points);
  constexpr std::uint64_t most = std::uint64_t{1} << 32;
  if (width > most || height > most)
    refusePcd(path, "its header gives " + std::to_string(width) + " x " +
                        std::to_string(height) + " points, more than can be counted");
  if (width * height != points)
    refusePcd(path, "its header gives " + std::to_string(width) + " x " +
                        std::to_string(height) + " points in rows, but " +
                        std::to_string(points) + " in all");
  return points;
}

/** @brief Reads a place and a quaternion; false if the words are anything else, also
 * numbers that no float holds. */
bool
readViewpoint(const Words& words, FileLayout& layout)
{
  std::array<double, 7> v{};
  if (words.size() != v.size())
    return false;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const auto& word = words[i];
    const char* const end = word.data() + word.size();
    if (readNumber(word.data(), end, v[i]).ptr != end ||
        !std::isfinite(static_cast<float>(v[i])))
      return false;
  }
  layout.viewpoint = Eigen::Vector3d(v[0], v[1], v[2]);
  layout.orientation = Eigen::Quaterniond(v[3], v[4], v[5], v[6]).cast<float>();
  return true;
}

/** @brief Reads where the scanner stood. A VIEWPOINT that is 0 or the origin, as in
 * files written here, says nothing of it; then a comment counts. */
void
readScannerPosition(const PcdHeader& header, FileLayout& layout)
{
  const Words* words = header.find("VIEWPOINT");
  const bool is_read = words && readViewpoint(*words, layout);
  const Origin& origin = header.origin;
  if (is_read && !layout.viewpoint->isZero(0) &&
      (origin.isZero() ||
       layout.viewpoint->cast<float>() != origin.place.cast<float>()))
    return;
  layout.viewpoint.reset();
  readViewpoint(header.viewpoint, layout);
}

/** @brief Refuses a header that counts more binary points than follow it, or fewer. */
void
checkCount(const std::string& path, const pcl::PCLPointCloud2& blob, std::size_t left)
{
  const std::size_t needed = std::size_t{blob.width} * blob.point_step;
  const std::string promise = "its header promises " + std::to_string(blob.width) +
                              " points of " + std::to_string(blob.point_step) +
                              " bytes, " + std::to_string(needed) + " bytes, but " +
                              std::to_string(left) + " bytes follow";
  if (left < needed)
    refusePcd(path, "the file is cut off, " + promise);
  if (areMorePoints(left - needed, blob.point_step, path))
    refusePcd(path, promise);
}

} // namespace

bool
looksLikePcd(const MappedFile& file)
{
  TextCursor cursor(file, 0);
  for (std::string_view line; cursor.nextLine(line);) {
    const Words words = wordsOf(line.substr(0, 256));
    if (!words.empty() && words[0][0] != '#')
      return isKeyword(words[0]);
  }
  return false;
}

FileLayout
readPcdLayout(const MappedFile& file, const std::string& path)
{
  const PcdHeader header = readPcdHeader(file, path);
  FileLayout layout;
  auto& blob = layout.blob;
  blob.fields = readFields(header, path);
  layOut(blob, readSize(header, path), path);
  readScannerPosition(header, layout);
  layout.counted_from = header.origin;
  layout.has_floats =
      std::all_of(blob.fields.begin(), blob.fields.end(), [](const auto& field) {
        return (field.name != "x" && field.name != "y" && field.name != "z") ||
               field.datatype == pcl::PCLPointField::FLOAT32;
      });
  layout.begin = header.data_begin;

  const Words& format = *header.find("DATA");
  const std::string_view name = format.empty() ? std::string_view() : format.front();
  const std::size_t left = file.size() - layout.begin;
  if (name == "ascii")
    layout.data = FileData::Ascii;
  else if (name == "binary_compressed")
    layout.data = FileData::Compressed;
  else if (name != "binary")
    refusePcd(path, "its DATA is " + quotedWord(name) + ", not ascii or binary");
  else
    checkCount(path, blob, left);
  return layout;
}

void
readAsciiPcd(const MappedFile& file,
             const FileLayout& layout,
             const std::string& path,
             pcl::PCLPointCloud2& blob)
{
  const std::size_t begin = layout.begin;
  std::size_t values = 0;
  for (const auto& field : blob.fields)
    values += field.count;
  // A number and a blank take two bytes, which limits the number of points.
  if ((file.size() - begin + 1) / 2 < std::size_t{blob.width} * values)
    refusePcd(path, "the file is cut off, its header promises " +
                        std::to_string(blob.width) + " points, but " +
                        std::to_string(file.size() - begin) + " bytes follow");
  blob.data.resize(std::size_t{blob.width} * blob.point_step);
  TextCursor cursor(file, begin);
  std::size_t point = 0;
  for (std::string_view line; cursor.nextLine(line);) {
    if (wordsOf(line.substr(0, 64)).empty())
      continue;
    if (point == blob.width)
      refusePcd(path, "its header promises " + std::to_string(blob.width) +
                          " points, but more lines follow");
    readNumbers(line, blob, path, point, blob.data.data() + point * blob.point_step);
    ++point;
  }
  if (point < blob.width)
    refusePcd(path, "the file is cut off, its header promises " +
                        std::to_string(blob.width) + " points, it holds " +
                        std::to_string(point));
}

void
readCompressedPcd(const MappedFile& file,
                  const FileLayout& layout,
                  const std::string& path,
                  pcl::PCLPointCloud2& blob)
{
  const std::size_t begin = layout.begin;
  std::uint32_t compressed = 0;
  std::uint32_t whole = 0;
  const std::size_t left = file.size() - begin;
  if (left < sizeof compressed + sizeof whole)
    refusePcd(path, "the file is cut off, " + std::to_string(left) +
                        " bytes follow the header");
  std::memcpy(&compressed, file.data() + begin, sizeof compressed);
  std::memcpy(&whole, file.data() + begin + sizeof compressed, sizeof whole);
  const std::size_t data = begin + sizeof compressed + sizeof whole;
  if (file.size() - data < compressed)
    refusePcd(path, "the file is cut off, " + std::to_string(compressed) +
                        " bytes of compressed points are promised, " +
                        std::to_string(file.size() - data) + " follow");
  const std::size_t needed = std::size_t{blob.width} * blob.point_step;
  if (whole != needed)
    refusePcd(path, "its " + std::to_string(blob.width) + " points take " +
                        std::to_string(needed) + " bytes, the compressed ones hold " +
                        std::to_string(whole));
  // Three bytes decompress to at most 264, so larger claims allocate no memory.
  constexpr std::uint64_t max_expansion = 88;
  if (whole > max_expansion * compressed)
    refusePcd(path, "its compressed points are damaged, " + std::to_string(compressed) +
                        " bytes cannot hold " + std::to_string(whole));
  std::vector<std::uint8_t> by_field(whole);
  if (pcl::lzfDecompress(file.data() + data, compressed, by_field.data(), whole) !=
      whole)
    refusePcd(path, "its compressed points are damaged");
  blob.data.resize(needed);
  std::size_t from = 0;
  for (const auto& field : blob.fields) {
    const std::size_t size = fieldSize(field.datatype) * field.count;
    for (std::size_t i = 0; i < blob.width; ++i, from += size)
      std::memcpy(&blob.data[i * blob.point_step + field.offset],
                  by_field.data() + from, size);
  }
}

} // namespace pcl::sedr::tools
