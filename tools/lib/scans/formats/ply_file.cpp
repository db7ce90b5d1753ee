// SPDX-License-Identifier: BSD-3-Clause
#include "scan_formats.h"
#include "tool_error.h"

#include "bytes/input_file.h"
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

/** @brief Returns the row of an element without lists. */
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
  const std::size_t begin = readPlyHeader(*file, header, content.counted_from);
  if (header.elements.empty() || header.elements.front().name != "vertex" ||
      header.elements.front().hasLists())
    refusePly(*file, "its first element is not 'vertex', without lists");
  const PlyElement& vertices = header.elements.front();
  for (const PlyElement& element : header.elements)
    if (element.name == "face" || element.name == "tristrips")
      content.faces += element.count;
  Records records{"PLY", rowOf(vertices), begin, vertices.count, file->size()};
  records.row.joins_colours = true;
  records.are_last = header.elements.size() == 1;
  records.is_big_endian = header.format == "binary_big_endian";
  if (header.format == "ascii")
    content.points = std::make_unique<TextReader>(
        file, TextColumns::ofHeader("PLY", records.row, begin, vertices.count,
                                    records.are_last));
  else
    content.points = std::make_unique<RecordReader>(file, records);
  return content;
}

} // namespace pcl::sedr::tools
