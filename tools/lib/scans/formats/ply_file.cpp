// SPDX-License-Identifier: BSD-3-Clause
#include "plain_text.h"
#include "record_reader.h"
#include "scan_formats.h"
#include "tool_error.h"

#include "bytes/text_lines.h"
#include "text/text_reader.h"

#include "sedr_filters/src/base/ply_header.h"

namespace pcl::sedr::tools {

namespace {

[[noreturn]] void
refusePly(const InputFile& file, const std::string& reason)
{
  throw ToolError("cannot read '" + file.path() + "' as PLY: " + reason);
}

/** @brief Reads a header, and the origin that a comment states.
 * @return the byte behind it */
std::size_t
readPlyHeader(const InputFile& file, PlyHeader& header, Origin& origin)
{
  LineReader lines(file);
  std::string_view line;
  lines.next(line); // "ply"
  while (!header.is_complete && lines.next(line)) {
    Origin::fromComment(std::string(line.substr(0, 256)), origin);
    const std::string reason = header.take(line);
    if (!reason.empty())
      refusePly(file, reason);
  }
  if (!header.is_complete)
    refusePly(file, "its header does not end, the file may be cut off");
  return lines.position();
}

/** @brief Returns the row of an element; a list counts as one value. */
StoredRow
rowOf(const PlyElement& element)
{
  StoredRow row;
  for (const PlyProperty& property : element.properties) {
    const std::string& name = property.name;
    const bool is_normal = name == "nx" || name == "ny" || name == "nz";
    row.add(is_normal ? "normal_" + name.substr(1) : name, property.type);
  }
  return row;
}

/** @brief Returns the byte behind an element in text; one without properties has no
 * lines. */
std::size_t
pastLines(const InputFile& file, const PlyElement& element, std::size_t begin)
{
  LineReader lines(file, begin);
  std::uint64_t left = element.properties.empty() ? 0 : element.count;
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
    return moved(file, at, element.count, rowOf(element).size);
  for (std::uint64_t i = 0; i < element.count && at < file.size(); ++i)
    for (const PlyProperty& property : element.properties) {
      const std::size_t size = fieldSize(property.count_type);
      if (size > file.size() - at)
        return file.size();
      std::array<std::uint8_t, sizeof(double)> count{};
      file.read(at, size, count.data());
      if (is_big_endian)
        std::reverse(count.begin(), count.begin() + size);
      const double values =
          size == 0 ? 1 : readField(count.data(), property.count_type);
      if (values < 0)
        refusePly(file, "list " + std::to_string(i + 1) + " of its element " +
                            quotedWord(element.name) + " has fewer than 0 values");
      at = moved(file, at + size, static_cast<std::uint64_t>(values),
                 fieldSize(property.type));
    }
  return at;
}

/** @brief Refuses a header that counts more binary vertices than there are, or fewer if
 * nothing else follows. */
void
checkPlyCount(const InputFile& file,
              const PlyElement& vertices,
              std::size_t record,
              bool are_last,
              std::size_t left)
{
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
  PlyHeader header;
  ScanContent content;
  std::size_t begin = readPlyHeader(*file, header, content.counted_from);
  const bool is_ascii = header.format == "ascii";
  const bool is_big_endian = header.format == "binary_big_endian";
  const auto vertices = std::find_if(header.elements.begin(), header.elements.end(),
                                     [](const auto& e) { return e.name == "vertex"; });
  if (vertices == header.elements.end() || vertices->hasLists())
    refusePly(*file, "it has no element 'vertex' without lists");
  const bool are_last = vertices + 1 == header.elements.end();

  for (const PlyElement& element : header.elements)
    if (element.name == "face" || element.name == "tristrips")
      content.faces += element.count;
  for (auto e = header.elements.begin(); e != vertices; ++e)
    begin = is_ascii ? pastLines(*file, *e, begin)
                     : pastElement(*file, *e, is_big_endian, begin);
  StoredRow row = rowOf(*vertices);
  row.joins_colours = true;
  if (is_ascii) {
    content.points = std::make_unique<TextReader>(
        file, TextColumns::ofHeader("PLY", row, begin, vertices->count, are_last));
    return content;
  }
  checkPlyCount(*file, *vertices, row.size, are_last, file->size() - begin);
  content.points =
      std::make_unique<RecordReader>(file, begin, vertices->count, row, is_big_endian);
  return content;
}

} // namespace pcl::sedr::tools
