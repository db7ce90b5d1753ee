// SPDX-License-Identifier: BSD-3-Clause
#include "scan_formats.h"
#include "tool_error.h"

#include "bytes/input_file.h"
#include "text/text_reader.h"
#include <pcl/io/lzf.h>

#include <array>
#include <cmath>
#include <cstring>
#include <map>

namespace pcl::sedr::tools {

namespace {

using PcdWords = std::vector<std::string>;

/** @brief Header lines by keyword, and the offset of the data. */
struct PcdHeader {
  std::map<std::string, PcdWords> lines;
  std::size_t data_begin = 0;
  Origin origin;      ///< from a comment
  PcdWords viewpoint; ///< from a comment, empty if there is none

  /** @brief Returns the words behind a keyword; none if it is missing. */
  const PcdWords& at(const std::string& keyword) const
  {
    static const PcdWords none;
    const auto it = lines.find(keyword);
    return it == lines.end() ? none : it->second;
  }
};

[[noreturn]] void
refusePcd(const InputFile& file, const std::string& reason)
{
  throw ToolError("cannot read '" + file.path() + "' as PCD: " + reason);
}

bool
isPcdKeyword(std::string_view word)
{
  constexpr std::array<std::string_view, 11> keywords{
      "VERSION", "FIELDS", "COLUMNS",   "SIZE",   "TYPE", "COUNT",
      "WIDTH",   "HEIGHT", "VIEWPOINT", "POINTS", "DATA"};
  return std::find(keywords.begin(), keywords.end(), word) != keywords.end();
}

PcdHeader
readPcdHeader(const InputFile& file)
{
  PcdHeader header;
  LineReader lines(file);
  for (std::string_view line; lines.next(line);) {
    const auto found = wordsOf(line);
    PcdWords words(found.begin(), found.end());
    if (words.empty())
      continue;
    if (words[0][0] == '#') {
      Origin::fromComment(std::string(line.substr(0, 256)), header.origin);
      if (words.size() > 2 && words[0] == "#" && words[1] == "sedr_viewpoint")
        header.viewpoint.assign(words.begin() + 2, words.end());
      continue;
    }
    if (!isPcdKeyword(words[0]))
      refusePcd(file, "its header holds a line that is none, before DATA");
    const std::string keyword = words[0] == "COLUMNS" ? "FIELDS" : words[0];
    words.erase(words.begin());
    header.lines[keyword] = words;
    if (keyword == "DATA") {
      header.data_begin = lines.position();
      return header;
    }
  }
  refusePcd(file, "its header ends without a DATA line, the file may be cut off");
}

std::uint64_t
pcdNumber(const std::string& word, const std::string& what, const InputFile& file)
{
  std::uint64_t value = 0;
  if (!isNumber(word, value))
    refusePcd(file, what + " is " + quotedWord(word) + ", not a whole number");
  return value;
}

std::uint8_t
pcdType(const std::string& type, std::uint64_t size)
{
  using Field = pcl::PCLPointField;
  static const std::map<std::string, std::uint8_t> types{
      {"I1", Field::INT8},    {"I2", Field::INT16},  {"I4", Field::INT32},
      {"I8", Field::INT64},   {"U1", Field::UINT8},  {"U2", Field::UINT16},
      {"U4", Field::UINT32},  {"U8", Field::UINT64}, {"F4", Field::FLOAT32},
      {"F8", Field::FLOAT64}, {"B1", Field::BOOL}};
  const auto it = types.find(type.substr(0, 1) + std::to_string(size));
  return it == types.end() ? std::uint8_t{0} : it->second;
}

StoredRow
readPcdFields(const PcdHeader& header, const InputFile& file)
{
  const PcdWords& names = header.at("FIELDS");
  const PcdWords& sizes = header.at("SIZE");
  const PcdWords& types = header.at("TYPE");
  PcdWords counts = header.at("COUNT");
  if (header.lines.count("COUNT") == 0)
    counts.assign(names.size(), "1");
  if (names.empty() || sizes.size() != names.size() || types.size() != names.size() ||
      counts.size() != names.size())
    refusePcd(file, "its header names " + std::to_string(names.size()) +
                        " fields, but " + std::to_string(sizes.size()) + " sizes, " +
                        std::to_string(types.size()) + " types and " +
                        std::to_string(counts.size()) + " counts");
  constexpr std::uint64_t max_values = 1 << 16;
  StoredRow row;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::uint64_t count = pcdNumber(counts[i], "a COUNT", file);
    const std::uint8_t type = pcdType(types[i], pcdNumber(sizes[i], "a SIZE", file));
    if (type == 0 || count == 0 || count > max_values)
      refusePcd(file, "field " + quotedWord(names[i]) + " is of type " +
                          quotedWord(types[i]) + ", size " + quotedWord(sizes[i]) +
                          ", count " + std::to_string(count) + ", which is unknown");
    row.add(names[i], type, count);
  }
  constexpr std::size_t largest = std::size_t{1} << 22; // bytes
  if (row.size > largest)
    refusePcd(file, "its points have " + std::to_string(row.size) + " bytes, at most " +
                        std::to_string(largest) + " can be read");
  return row;
}

std::uint64_t
readPcdSize(const PcdHeader& header, const InputFile& file)
{
  const auto number = [&](const char* keyword, std::uint64_t otherwise) {
    const PcdWords& words = header.at(keyword);
    return words.empty() ? otherwise : pcdNumber(words.front(), keyword, file);
  };
  if (header.at("WIDTH").empty() && header.at("POINTS").empty())
    refusePcd(file, "its header lacks WIDTH and POINTS");
  constexpr std::uint64_t most = std::uint64_t{1} << 32;
  const std::uint64_t height = number("HEIGHT", 1);
  const std::uint64_t points = number("POINTS", number("WIDTH", 0) * height);
  const std::uint64_t width = number("WIDTH", points);
  if (width > most || height > most || width * height != points)
    refusePcd(file, "its header gives " + std::to_string(width) + " x " +
                        std::to_string(height) + " points in rows, but " +
                        std::to_string(points) + " in all");
  return points;
}

/** @brief Reads a place and a quaternion; false if the words are anything else, also
 * numbers that no float holds. */
bool
readViewpoint(const PcdWords& words, ScanContent& content)
{
  std::array<double, 7> v{};
  if (words.size() != v.size())
    return false;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const char* const end = words[i].data() + words[i].size();
    if (readNumber(words[i].data(), end, v[i]).ptr != end ||
        !std::isfinite(static_cast<float>(v[i])))
      return false;
  }
  content.viewpoint = Eigen::Vector3d(v[0], v[1], v[2]);
  content.orientation = Eigen::Quaterniond(v[3], v[4], v[5], v[6]).cast<float>();
  return true;
}

/** @brief Reads where the scanner stood. A VIEWPOINT that is 0 or the origin, as in
 * files written here, says nothing of it; then a comment counts. */
void
readScannerPosition(const PcdHeader& header, ScanContent& content)
{
  const Origin& origin = header.origin;
  const bool is_read = readViewpoint(header.at("VIEWPOINT"), content);
  if (is_read && !content.viewpoint->isZero(0) &&
      (origin.isZero() ||
       content.viewpoint->cast<float>() != origin.place.cast<float>()))
    return;
  content.viewpoint.reset();
  readViewpoint(header.viewpoint, content);
}

/** @brief Unpacks the points of a binary_compressed PCD, which are in it field by
 * field. */
std::vector<std::uint8_t>
unpackedPcd(const InputFile& file,
            std::size_t begin,
            std::uint64_t points,
            const StoredRow& row)
{
  constexpr std::size_t sizes = 2 * sizeof(std::uint32_t);
  const std::size_t left = file.size() - begin;
  const std::uint32_t packed = left < sizes ? 0 : file.numberAt<std::uint32_t>(begin);
  if (left < sizes || packed > left - sizes)
    refusePcd(file, "the file is cut off, " + std::to_string(packed) +
                        " bytes of compressed points are promised, " +
                        std::to_string(left) + " bytes follow the header");
  const auto whole = file.numberAt<std::uint32_t>(begin + sizeof packed);
  // Three bytes become at most 264, so larger claims take no memory.
  constexpr std::uint64_t max_expansion = 88;
  if (points > whole / row.size || points * row.size != whole ||
      whole > max_expansion * packed)
    refusePcd(file, "its " + std::to_string(points) + " points take " +
                        std::to_string(row.size) + " bytes each, its " +
                        std::to_string(packed) + " compressed bytes promise " +
                        std::to_string(whole));
  std::vector<std::uint8_t> bytes(packed);
  std::vector<std::uint8_t> by_field(whole);
  file.read(begin + sizes, packed, bytes.data());
  if (pcl::lzfDecompress(bytes.data(), packed, by_field.data(), whole) != whole)
    refusePcd(file, "its compressed points are damaged");
  bytes.resize(whole);
  const auto* from = by_field.data();
  for (const StoredField& field : row.fields) {
    const std::size_t size = fieldSize(field.datatype) * field.count;
    for (std::size_t i = 0; i < points; ++i, from += size)
      std::memcpy(&bytes[i * row.size + field.offset], from, size);
  }
  return bytes;
}

} // namespace

bool
looksLikePcd(const InputFile& file)
{
  LineReader lines(file);
  for (std::string_view line; lines.next(line);) {
    const auto words = wordsOf(line.substr(0, 256));
    if (!words.empty() && words[0][0] != '#')
      return isPcdKeyword(words[0]);
  }
  return false;
}

ScanContent
openPcd(const InputFilePtr& file)
{
  const PcdHeader header = readPcdHeader(*file);
  const StoredRow row = readPcdFields(header, *file);
  const std::uint64_t points = readPcdSize(header, *file);
  const std::size_t begin = header.data_begin;
  const PcdWords& format = header.at("DATA");
  const std::string data = format.empty() ? "" : format.front();

  ScanContent content;
  content.counted_from = header.origin;
  readScannerPosition(header, content);
  content.may_be_local =
      header.origin.isZero() &&
      std::all_of(row.fields.begin(), row.fields.end(), [](const auto& field) {
        return (field.name != "x" && field.name != "y" && field.name != "z") ||
               field.datatype == pcl::PCLPointField::FLOAT32;
      });
  Records records{"PCD", row, begin, points, file->size()};
  if (data == "ascii")
    content.points = std::make_unique<TextReader>(
        file, TextColumns::ofHeader("PCD", row, begin, points));
  else if (data == "binary")
    content.points = std::make_unique<RecordReader>(file, records);
  else if (data == "binary_compressed") {
    const auto unpacked = std::make_shared<InputFile>(
        file->path(), unpackedPcd(*file, begin, points, row));
    records.begin = 0;
    records.end = unpacked->size();
    content.points = std::make_unique<RecordReader>(unpacked, records);
  }
  else
    refusePcd(*file, "its DATA is " + quotedWord(data) + ", not ascii or binary");
  return content;
}

} // namespace pcl::sedr::tools
