// SPDX-License-Identifier: BSD-3-Clause
#include "unrolled_walls.h"

#include <algorithm>
#include <map>
#include <utility>

namespace pcl::sedr::tools {

namespace {

constexpr double strip_gap = 0.15; ///< between strips in a line, metres
constexpr double line_gap = 0.7;   ///< between lines, with the names of the strips

const char*
letterOf(VerticalKind kind)
{
  switch (kind) {
  case VerticalKind::ColumnFace:
    return "c";
  case VerticalKind::CeilingRiser:
    return "d";
  case VerticalKind::FloorRiser:
    return "s";
  case VerticalKind::NicheSide:
    return "n";
  default:
    return "";
  }
}

/** @brief Computes the height range of a strip.
 * @return false for a strip without cells */
bool
findHeights(NamedStrip& strip)
{
  bool has_cells = false;
  for (const auto* part : strip.parts)
    for (const auto& column : part->columns) {
      if (column.cells == 0)
        continue;
      strip.low = has_cells ? std::min(strip.low, column.low) : column.low;
      strip.high = has_cells ? std::max(strip.high, column.high) : column.high;
      has_cells = true;
    }
  return has_cells;
}

StripLines
linesOf(const std::vector<NamedStrip>& strips, double length)
{
  StripLines lines;
  double x = 0;
  double top = 0;
  double height = 0;
  double right = 0;
  std::size_t first = 0;
  const auto endLine = [&](std::size_t end) {
    for (std::size_t i = first; i < end; ++i)
      lines.origins[i].y() = top - height;
    top -= height + line_gap;
    x = height = 0;
    first = end;
  };
  for (std::size_t i = 0; i < strips.size(); ++i) {
    if (x > 0 && x + strips[i].length > length)
      endLine(i);
    lines.origins.emplace_back(x, 0);
    x += strips[i].length + strip_gap;
    height = std::max(height, strips[i].high - strips[i].low);
    right = std::max(right, x);
  }
  endLine(strips.size());
  lines.view = {{-strip_gap, top + line_gap / 2}, {right, line_gap}};
  return lines;
}

} // namespace

std::vector<NamedStrip>
nameStrips(const std::vector<RepairedStrip>& strips)
{
  std::vector<NamedStrip> named;
  std::map<std::pair<std::uint32_t, VerticalKind>, std::size_t> count;
  for (const auto& strip : strips) {
    const auto isSameWall = [&](const NamedStrip& other) {
      return other.parts.front()->room == strip.room &&
             other.kind() == VerticalKind::Wall &&
             other.element().start == strip.element.start &&
             other.element().end == strip.element.end;
    };
    const auto wall = strip.kind == VerticalKind::WallAboveNiche
                          ? std::find_if(named.begin(), named.end(), isSameWall)
                          : named.end();
    if (wall != named.end()) {
      wall->parts.push_back(&strip);
      continue;
    }
    NamedStrip next;
    next.parts = {&strip};
    next.length = strip.element.length();
    next.name = std::to_string(strip.room) + "." + letterOf(strip.kind) +
                std::to_string(++count[{strip.room, strip.kind}]);
    named.push_back(std::move(next));
  }
  // From inside, a wall runs from its end on the left to its start on the right.
  for (auto first = named.begin(); first != named.end();) {
    const auto last = std::find_if(first, named.end(), [&](const NamedStrip& s) {
      return s.parts.front()->room != first->parts.front()->room ||
             s.kind() != first->kind();
    });
    std::reverse(first, last);
    first = last;
  }
  named.erase(std::remove_if(named.begin(), named.end(),
                             [](NamedStrip& strip) { return !findHeights(strip); }),
              named.end());
  return named;
}

StripBoxes
boxesOf(const NamedStrip& strip,
        const std::vector<bool>& is_seen,
        const Eigen::Vector2d& origin)
{
  StripBoxes boxes;
  for (const auto* part : strip.parts) {
    const double width = strip.length / static_cast<double>(part->columns.size());
    for (std::size_t c = 0; c < part->columns.size(); ++c) {
      const RepairedStrip::Column& column = part->columns[c];
      const double left = strip.length - static_cast<double>(c + 1) * width;
      const double height = (column.high - column.low) /
                            static_cast<double>(std::max<std::size_t>(1, column.cells));
      for (std::size_t r = 0; r < column.cells; ++r) {
        const std::size_t at = column.first + r;
        const double bottom = column.low - strip.low + static_cast<double>(r) * height;
        const Eigen::Vector2d low = origin + Eigen::Vector2d(left, bottom);
        auto& side = is_seen[at] ? boxes.seen : boxes.filled;
        if (r == 0 || is_seen[at] != is_seen[at - 1])
          side.push_back({low, low});
        side.back().high = low + Eigen::Vector2d(width, height);
      }
    }
  }
  return boxes;
}

StripLines
breakIntoLines(const std::vector<NamedStrip>& strips,
               double sheet_width,
               double sheet_height)
{
  constexpr int max_lines = 40;
  double whole = 0;
  for (const auto& strip : strips)
    whole += strip.length + strip_gap;
  StripLines best;
  double most = 0;
  for (int count = 1; count <= max_lines; ++count) {
    StripLines lines = linesOf(strips, 1.05 * whole / count);
    const Eigen::Vector2d size = lines.view.size();
    const double scale = std::min(sheet_width / size.x(), sheet_height / size.y());
    if (scale <= most)
      continue;
    most = scale;
    best = std::move(lines);
  }
  return best;
}

double
nameHeight(const NamedStrip& strip)
{
  return strip.high - strip.low + line_gap / 2;
}

} // namespace pcl::sedr::tools
