// SPDX-License-Identifier: BSD-3-Clause
#include "plain_text.h"
#include "record_reader.h"
#include "scan_formats.h"
#include "tool_error.h"

#include "bytes/text_lines.h"
#include "text/text_reader.h"

#include <map>

namespace pcl::sedr::tools {

namespace {

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  StoredRow row;                    ///< of a list the type of its values
  std::vector<std::uint8_t> counts; ///< types of the lists' counts, 0 for other fields

  bool hasLists() const
  {
    return std::any_of(counts.begin(), counts.end(), [](auto type) { return type; });
  }
};

struct PlyHeader {
  std::string format;
  std::vector<PlyElement> elements;
  std::size_t data_begin = 0;
  Origin origin; ///< from a comment
};

[[noreturn]] void
refusePly(const InputFile& file, const std::string& reason)
{
  throw ToolError("cannot read '" + file.path() + "' as PLY: " + reason);
}

std::uint8_t
plyType(std::string_view name, const InputFile& file)
{
  using Field = pcl::PCLPointField;
  static const std::map<std::string_view, std::uint8_t> types{
      {"char", Field::INT8},      {"int8", Field::INT8},
      {"uchar", Field::UINT8},    {"uint8", Field::UINT8},
      {"short", Field::INT16},    {"int16", Field::INT16},
      {"ushort", Field::UINT16},  {"uint16", Field::UINT16},
      {"int", Field::INT32},      {"int32", Field::INT32},
      {"uint", Field::UINT32},    {"uint32", Field::UINT32},
      {"float", Field::FLOAT32},  {"float32", Field::FLOAT32},
      {"double", Field::FLOAT64}, {"float64", Field::FLOAT64}};
  const auto it = types.find(name);
  if (it == types.end())
    refusePly(file, "the type " + quotedWord(name) + " of a property is unknown");
  return it->second;
}

void
addProperty(const std::vector<std::string_view>& words,
            const InputFile& file,
            PlyHeader& header)
{
  const bool is_list = words.size() > 1 && words[1] == "list";
  if (header.elements.empty() || words.size() < (is_list ? 5 : 3))
    refusePly(file, "its header holds a property without an element, type or name");
  std::string name(words[is_list ? 4 : 2]);
  if (name == "nx" || name == "ny" || name == "nz") // as PCL calls them
    name = "normal_" + name.substr(1);
  PlyElement& element = header.elements.back();
  element.row.add(name, plyType(words[is_list ? 3 : 1], file));
  element.counts.push_back(is_list ? plyType(words[2], file) : std::uint8_t{0});
  if (element.counts.back() >= pcl::PCLPointField::FLOAT32)
    refusePly(file, "the list " + quotedWord(name) + " counts its values as " +
                        quotedWord(words[2]) + ", which is no whole number");
}

PlyHeader
readPlyHeader(const InputFile& file)
{
  PlyHeader header;
  LineReader lines(file);
  std::string_view line;
  lines.next(line);
  while (lines.next(line)) {
    const auto words = wordsOf(line);
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info")
      Origin::fromComment(std::string(line.substr(0, 256)), header.origin);
    else if (words[0] == "end_header") {
      header.data_begin = lines.position();
      return header;
    }
    else if (words[0] == "format" && words.size() > 1)
      header.format = std::string(words[1]);
    else if (words[0] == "property")
      addProperty(words, file, header);
    else if (words[0] == "element" && words.size() > 2) {
      PlyElement element;
      element.name = std::string(words[1]);
      if (!isNumber(words[2], element.count))
        refusePly(file, quotedWord(words[2]) + " is no number of elements");
      header.elements.push_back(element);
    }
    else
      refusePly(file, "its header holds a line that is none, before end_header");
  }
  refusePly(file, "its header does not end, the file may be cut off");
}

/** @brief Returns the byte behind an element in text; one without properties has no
 * lines. */
std::size_t
pastLines(const InputFile& file, const PlyElement& element, std::size_t begin)
{
  LineReader lines(file, begin);
  std::uint64_t left = element.row.fields.empty() ? 0 : element.count;
  for (std::string_view line; left > 0 && lines.next(line);)
    left -= wordsOf(line).empty() ? 0 : 1;
  return lines.position();
}

/** @brief Returns `at` moved by `count` values of `size` bytes, to the end of the file
 * at most. */
std::size_t
moved(const InputFile& file, std::size_t at, std::uint64_t count, std::size_t size)
{
  const std::size_t left = file.size() - at;
  return size > 0 && count > left / size ? file.size() : at + count * size;
}

/** @brief Returns the byte behind a binary element. */
std::size_t
pastElement(const InputFile& file,
            const PlyElement& element,
            bool is_big_endian,
            std::size_t at)
{
  if (!element.hasLists())
    return moved(file, at, element.count, element.row.size);
  for (std::uint64_t i = 0; i < element.count && at < file.size(); ++i)
    for (std::size_t f = 0; f < element.counts.size(); ++f) {
      const std::size_t size = fieldSize(element.counts[f]);
      if (size > file.size() - at)
        return file.size();
      std::array<std::uint8_t, sizeof(double)> count{};
      file.read(at, size, count.data());
      if (is_big_endian)
        std::reverse(count.begin(), count.begin() + size);
      const double values = size == 0 ? 1 : readField(count.data(), element.counts[f]);
      if (values < 0)
        refusePly(file, "list " + std::to_string(i + 1) + " of its element " +
                            quotedWord(element.name) + " has fewer than 0 values");
      at = moved(file, at + size, static_cast<std::uint64_t>(values),
                 fieldSize(element.row.fields[f].datatype));
    }
  return at;
}

/** @brief Refuses a header that counts more binary vertices than there are, or fewer if
 * nothing else follows. */
void
checkPlyCount(const InputFile& file,
              const PlyElement& vertices,
              bool are_last,
              std::size_t left)
{
  const std::size_t record = vertices.row.size;
  if (record == 0) // which lacks x, as is told later
    return;
  const std::string promise = "its header promises " + std::to_string(vertices.count) +
                              " vertices of " + std::to_string(record) +
                              " bytes, but " + std::to_string(left) + " bytes follow";
  if (vertices.count > left / record)
    refusePly(file, "the file is cut off, " + promise);
  if (are_last && vertices.count > 0 &&
      areMorePoints(left - vertices.count * record, record, file.path()))
    refusePly(file, promise);
}

} // namespace

bool
looksLikePly(const InputFile& file)
{
  return file.beginsWith("ply\n") || file.beginsWith("ply\r");
}

ScanContent
openPly(const InputFilePtr& file)
{
  const PlyHeader header = readPlyHeader(*file);
  const bool is_ascii = header.format == "ascii";
  const bool is_big_endian = header.format == "binary_big_endian";
  if (!is_ascii && !is_big_endian && header.format != "binary_little_endian")
    refusePly(*file, "its format is " + quotedWord(header.format));
  const auto vertices = std::find_if(header.elements.begin(), header.elements.end(),
                                     [](const auto& e) { return e.name == "vertex"; });
  if (vertices == header.elements.end() || vertices->hasLists())
    refusePly(*file, "it has no element 'vertex' without lists");
  const bool are_last = vertices + 1 == header.elements.end();

  ScanContent content;
  content.counted_from = header.origin;
  for (const PlyElement& element : header.elements)
    if (element.name == "face" || element.name == "tristrips")
      content.faces += element.count;
  std::size_t begin = header.data_begin;
  for (auto e = header.elements.begin(); e != vertices; ++e)
    begin = is_ascii ? pastLines(*file, *e, begin)
                     : pastElement(*file, *e, is_big_endian, begin);
  StoredRow row = vertices->row;
  row.joins_colours = true;
  if (is_ascii) {
    content.points = std::make_unique<TextReader>(
        file, TextColumns::ofHeader("PLY", row, begin, vertices->count, are_last));
    return content;
  }
  checkPlyCount(*file, *vertices, are_last, file->size() - begin);
  content.points =
      std::make_unique<RecordReader>(file, begin, vertices->count, row, is_big_endian);
  return content;
}

} // namespace pcl::sedr::tools
