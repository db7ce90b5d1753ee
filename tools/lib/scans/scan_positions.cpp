// SPDX-License-Identifier: BSD-3-Clause
#include "scan_file.h"
#include "tool_error.h"

#include "bytes/text_lines.h"

#include <optional>

namespace pcl::sedr::tools {

namespace {

/** @brief A line of a file of positions. */
struct PositionLine {
  Eigen::Vector3d place;
  std::optional<std::size_t> points;
};

std::optional<PositionLine>
positionIn(const std::vector<std::string_view>& words)
{
  PositionLine line;
  if (words.size() != 3 && words.size() != 4)
    return {};
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (!isNumber(words[axis], line.place[static_cast<Eigen::Index>(axis)]))
      return {};
  if (!line.place.cast<float>().allFinite())
    return {};
  if (words.size() == 4 && !isNumber(words[3], line.points.emplace()))
    return {};
  return line;
}

/** @brief Reads a file of positions. A position without a number of points must be the
 * only one. */
std::vector<PositionLine>
readPositionLines(const std::string& path)
{
  const InputFile file(path);
  LineReader reader(file);
  std::vector<PositionLine> lines;
  std::string_view text;
  for (std::size_t number = 1; reader.next(text); ++number) {
    const std::vector<std::string_view> words = wordsOf(text);
    if (words.empty() || words.front().front() == '#')
      continue;
    const std::optional<PositionLine> line = positionIn(words);
    if (!line)
      throw ToolError("line " + std::to_string(number) + " of '" + path +
                      "' is not x y z and a number of points");
    lines.push_back(*line);
  }
  if (lines.empty())
    throw ToolError("'" + path + "' has no positions");
  for (const PositionLine& line : lines)
    if (lines.size() > 1 && !line.points)
      throw ToolError("of " + std::to_string(lines.size()) + " positions in '" + path +
                      "' each must tell its number of points");
  return lines;
}

} // namespace

ScanPositions
ScanFile::positions() const
{
  if (!positions_.empty())
    return positionsIn(positions_, size());
  ScanPositions positions;
  for (const ScanStation& station : content_.points->stations())
    positions.push_back({station.first_row, inMetres(station.position)});
  if (positions.empty() && content_.viewpoint)
    positions.push_back({0, inMetres(*content_.viewpoint)});
  return positions;
}

ScanPositions
ScanFile::positionsIn(const std::string& path, std::size_t rows) const
{
  ScanPositions positions;
  std::size_t row = 0;
  for (const PositionLine& line : readPositionLines(path)) {
    positions.push_back({row, inMetres(line.place)});
    row += line.points.value_or(rows);
  }
  if (row != rows)
    throw ToolError("the positions in '" + path + "' are of " + std::to_string(row) +
                    " points, the scan has " + std::to_string(rows));
  return positions;
}

} // namespace pcl::sedr::tools
