// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_readers.h"
#include "plain_text.h"
#include "tool_error.h"

#include "sedr_filters/src/base/field_access.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <map>

namespace pcl::sedr::tools {

namespace {

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<pcl::PCLPointField> fields; ///< of a list its values, with `count` 0
  std::vector<std::uint8_t> counts; ///< types of the lists' counts, 0 for other fields

  bool hasLists() const
  {
    return std::any_of(counts.begin(), counts.end(),
                       [](auto type) { return type != 0; });
  }
};

struct PlyHeader {
  std::string format;
  std::vector<PlyElement> elements;
  std::size_t data_begin = 0;
  Origin origin; ///< from a comment
};

[[noreturn]] void
refusePly(const std::string& path, const std::string& reason)
{
  throw ToolError("cannot read '" + path + "' as PLY: " + reason);
}

std::uint8_t
dataType(std::string_view name)
{
  using Field = pcl::PCLPointField;
  const std::map<std::string_view, std::uint8_t> types{
      {"char", Field::INT8},      {"int8", Field::INT8},
      {"uchar", Field::UINT8},    {"uint8", Field::UINT8},
      {"short", Field::INT16},    {"int16", Field::INT16},
      {"ushort", Field::UINT16},  {"uint16", Field::UINT16},
      {"int", Field::INT32},      {"int32", Field::INT32},
      {"uint", Field::UINT32},    {"uint32", Field::UINT32},
      {"float", Field::FLOAT32},  {"float32", Field::FLOAT32},
      {"double", Field::FLOAT64}, {"float64", Field::FLOAT64}};
  const auto it = types.find(name);
  return it == types.end() ? 0 : it->second;
}

void
addProperty(const std::vector<std::string_view>& words,
            const std::string& path,
            PlyHeader& header)
{
  if (header.elements.empty() || words.size() < 3)
    refusePly(path, "its header holds a property without an element or a name");
  const bool is_list = words[1] == "list";
  if (is_list && words.size() < 5)
    refusePly(path, "its header holds a list without types or a name");
  const auto knownType = [&](std::string_view type) {
    const std::uint8_t known = dataType(type);
    if (known == 0)
      refusePly(path, "property " + quotedWord(words.back()) +
                          " is of the unknown type " + quotedWord(type));
    return known;
  };
  pcl::PCLPointField field;
  field.name = std::string(words[is_list ? 4 : 2]);
  field.count = is_list ? 0 : 1;
  field.datatype = knownType(words[is_list ? 3 : 1]);
  auto& element = header.elements.back();
  element.fields.push_back(field);
  const std::uint8_t count = is_list ? knownType(words[2]) : std::uint8_t{0};
  if (count == pcl::PCLPointField::FLOAT32 || count == pcl::PCLPointField::FLOAT64)
    refusePly(path, "the list " + quotedWord(words.back()) + " counts its values as " +
                        quotedWord(words[2]) + ", which is no whole number");
  element.counts.push_back(count);
}

PlyHeader
readPlyHeader(const MappedFile& file, const std::string& path)
{
  PlyHeader header;
  TextCursor cursor(file, 0);
  std::string_view line;
  cursor.nextLine(line);
  while (cursor.nextLine(line)) {
    const auto words = wordsOf(line);
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info") {
      Origin::fromComment(std::string(line.substr(0, 256)), header.origin);
      continue;
    }
    if (words[0] == "end_header") {
      header.data_begin = cursor.position();
      return header;
    }
    if (words[0] == "format" && words.size() > 1)
      header.format = std::string(words[1]);
    else if (words[0] == "property")
      addProperty(words, path, header);
    else if (words[0] == "element" && words.size() > 2) {
      PlyElement element;
      element.name = std::string(words[1]);
      const auto& n = words[2];
      const auto result = std::from_chars(n.data(), n.data() + n.size(), element.count);
      if (result.ec != std::errc() || result.ptr != n.data() + n.size())
        refusePly(path, quotedWord(n) + " is no number of elements");
      header.elements.push_back(element);
    }
    else
      refusePly(path, "its header holds a line that is none, before end_header");
  }
  refusePly(path, "its header does not end, the file may be cut off");
}

bool
isEmpty(std::string_view line)
{
  return wordsOf(line.substr(0, 64)).empty();
}

/** @brief Returns the byte behind an element in text; one without properties has no
 * lines. */
std::size_t
pastLines(const MappedFile& file, const PlyElement& element, std::size_t begin)
{
  TextCursor cursor(file, begin);
  std::uint64_t left = element.fields.empty() ? 0 : element.count;
  for (std::string_view line; left > 0 && cursor.nextLine(line);)
    left -= isEmpty(line) ? 0 : 1;
  return cursor.position();
}

/** @brief Returns the bytes of `rows` rows from `at` on, at most those of the file. */
std::size_t
bytesOf(const MappedFile& file, std::size_t at, std::uint64_t rows, std::uint64_t row)
{
  const std::size_t left = file.size() - at;
  return row > 0 && rows > left / row ? left : static_cast<std::size_t>(rows * row);
}

/** @brief Returns the byte behind a binary element of any lists; the end of the file at
 * most. */
std::size_t
pastElement(const MappedFile& file,
            const PlyElement& element,
            bool is_big_endian,
            std::size_t begin,
            const std::string& path)
{
  std::size_t at = begin;
  if (!element.hasLists()) {
    std::uint64_t row = 0;
    for (const auto& field : element.fields)
      row += fieldSize(field.datatype);
    return at + bytesOf(file, at, element.count, row);
  }
  for (std::uint64_t i = 0; i < element.count && at < file.size(); ++i)
    for (std::size_t f = 0; f < element.fields.size(); ++f) {
      const std::uint8_t type = element.counts[f];
      const std::size_t count_size = type == 0 ? 0 : fieldSize(type);
      if (count_size > file.size() - at)
        return file.size();
      std::array<std::uint8_t, sizeof(double)> count{};
      std::copy_n(file.data() + at, count_size, count.begin());
      if (is_big_endian)
        std::reverse(count.begin(), count.begin() + static_cast<int>(count_size));
      at += count_size;
      const double values = type == 0 ? 1 : readField(count.data(), type);
      if (values < 0)
        refusePly(path, "list " + std::to_string(i + 1) + " of its element " +
                            quotedWord(element.name) + " has " +
                            std::to_string(std::llround(values)) + " values");
      at += bytesOf(file, at, static_cast<std::uint64_t>(values),
                    fieldSize(element.fields[f].datatype));
    }
  return at;
}

[[noreturn]] void
refuseCutOff(const std::string& path, std::uint64_t vertices, const std::string& found)
{
  refusePly(path, "the file is cut off, its header promises " +
                      std::to_string(vertices) + " vertices, " + found);
}

/** @brief Renames the properties to PCL's fields. */
void
renameNormals(std::vector<pcl::PCLPointField>& fields)
{
  for (auto& field : fields)
    for (const char axis : {'x', 'y', 'z'})
      if (field.name == std::string("n") + axis)
        field.name = std::string("normal_") + axis;
}

/** @brief Joins one-byte red, green, blue and alpha into `rgb`, or `rgba` with
 * alpha. */
void
joinColours(pcl::PCLPointCloud2& blob)
{
  const std::array<const char*, 4> names{"blue", "green", "red",
                                         "alpha"}; // low byte first
  std::array<int, 4> offsets{-1, -1, -1, -1};
  for (std::size_t c = 0; c < names.size(); ++c)
    for (const auto& field : blob.fields)
      if (field.name == names[c] && field.datatype == pcl::PCLPointField::UINT8)
        offsets[c] = static_cast<int>(field.offset);
  if (offsets[0] < 0 || offsets[1] < 0 || offsets[2] < 0)
    return;
  const bool has_alpha = offsets[3] >= 0;

  pcl::PCLPointCloud2 joined = blob;
  joined.fields.clear();
  for (const auto& field : blob.fields)
    if (std::find(names.begin(), names.end(), field.name) == names.end())
      joined.fields.push_back(field);
  const std::vector<pcl::PCLPointField> others = joined.fields;
  pcl::PCLPointField colour;
  colour.name = has_alpha ? "rgba" : "rgb";
  colour.datatype =
      has_alpha ? pcl::PCLPointField::UINT32 : pcl::PCLPointField::FLOAT32;
  colour.count = 1;
  joined.fields.push_back(colour);
  layOut(joined, blob.width, "");
  joined.data.assign(std::size_t{joined.width} * joined.point_step, 0);
  for (std::size_t i = 0; i < blob.width; ++i) {
    const auto* from = &blob.data[i * blob.point_step];
    auto* to = &joined.data[i * joined.point_step];
    for (std::size_t f = 0; f < others.size(); ++f)
      std::memcpy(to + joined.fields[f].offset, from + others[f].offset,
                  fieldSize(others[f].datatype));
    for (std::size_t c = 0; c < names.size(); ++c)
      to[joined.fields.back().offset + c] =
          offsets[c] >= 0 ? from[offsets[c]] : std::uint8_t{0xff};
  }
  blob = std::move(joined);
}

} // namespace

bool
looksLikePly(const MappedFile& file)
{
  TextCursor cursor(file, 0);
  std::string_view line;
  return cursor.nextLine(line) && line == "ply";
}

FileLayout
readPlyLayout(const MappedFile& file, const std::string& path)
{
  const PlyHeader header = readPlyHeader(file, path);
  const bool ascii = header.format == "ascii";
  if (!ascii && header.format != "binary_little_endian" &&
      header.format != "binary_big_endian")
    refusePly(path, "its format is " + quotedWord(header.format));
  const auto vertices = std::find_if(header.elements.begin(), header.elements.end(),
                                     [](const auto& e) { return e.name == "vertex"; });
  if (vertices == header.elements.end() || vertices->hasLists())
    refusePly(path, "it has no element 'vertex' without lists");

  FileLayout layout;
  layout.is_ply = true;
  layout.counted_from = header.origin;
  for (const auto& element : header.elements)
    if (element.name == "face" || element.name == "tristrips")
      layout.faces += element.count;
  layout.are_last = vertices + 1 == header.elements.end();
  auto& blob = layout.blob;
  blob.fields = vertices->fields;
  layOut(blob, vertices->count, path);
  layout.data = ascii                                  ? FileData::Ascii
                : header.format == "binary_big_endian" ? FileData::BinaryBigEndian
                                                       : FileData::Binary;
  layout.begin = header.data_begin;
  for (auto e = header.elements.begin(); e != vertices; ++e) {
    layout.begin = ascii
                       ? pastLines(file, *e, layout.begin)
                       : pastElement(file, *e, layout.data == FileData::BinaryBigEndian,
                                     layout.begin, path);
  }
  if (ascii)
    return layout;
  const std::size_t needed = std::size_t{blob.width} * blob.point_step;
  const std::size_t left = file.size() - layout.begin;
  const std::string sizes =
      std::to_string(needed) + " bytes, but " + std::to_string(left) + " bytes follow";
  if (left < needed)
    refuseCutOff(path, vertices->count, sizes);
  if (layout.are_last && areMorePoints(left - needed, blob.point_step, path))
    refusePly(path, "its header promises " + std::to_string(vertices->count) +
                        " vertices, " + sizes);
  return layout;
}

void
readAsciiPly(const MappedFile& file,
             const FileLayout& layout,
             const std::string& path,
             pcl::PCLPointCloud2& blob)
{
  TextCursor cursor(file, layout.begin);
  const std::size_t values = blob.fields.size();
  const std::size_t left = file.size() - std::min(cursor.position(), file.size());
  if ((left + 1) / 2 < std::size_t{blob.width} * values)
    refuseCutOff(path, blob.width, "but " + std::to_string(left) + " bytes follow");
  blob.data.resize(std::size_t{blob.width} * blob.point_step);
  std::size_t point = 0;
  for (std::string_view line; point < blob.width && cursor.nextLine(line);) {
    if (isEmpty(line))
      continue;
    readNumbers(line, blob, path, point, blob.data.data() + point * blob.point_step);
    ++point;
  }
  if (point < blob.width)
    refuseCutOff(path, blob.width, "it holds " + std::to_string(point));
  for (std::string_view line; layout.are_last && cursor.nextLine(line);)
    if (!isEmpty(line))
      refusePly(path, "its header promises " + std::to_string(blob.width) +
                          " vertices, but more lines follow");
}

void
swapBytes(pcl::PCLPointCloud2& blob)
{
  for (std::size_t i = 0; i < blob.width; ++i)
    for (const auto& field : blob.fields) {
      auto* first = &blob.data[i * blob.point_step + field.offset];
      std::reverse(first, first + fieldSize(field.datatype));
    }
}

void
nameAsPcl(pcl::PCLPointCloud2& blob)
{
  renameNormals(blob.fields);
  joinColours(blob);
}

} // namespace pcl::sedr::tools
