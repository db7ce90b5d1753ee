// SPDX-License-Identifier: BSD-3-Clause
#include "repair_picture.h"

#include "map_cells.h"
#include "plan_layers.h"
#include "scale.h"

#include <algorithm>
#include <array>
#include <map>

namespace pcl {
namespace sedr {
namespace tools {

namespace {

constexpr double strip_gap = 0.15; ///< between strips of a line, metres
constexpr double line_gap = 0.7;   ///< between lines, with the names of the strips

/** @brief A strip with its name and how high it is. */
struct NamedStrip {
  const RepairedStrip* strip;
  std::string name;
  double length;
  double low = 0;  ///< least z, metres
  double high = 0; ///< greatest
};

/** @brief Names the strips that have cells: room and number of the wall, with a c for
 * columns and a d for risers of details; the walls of a room in the order in which one
 * sees them who turns right. */
std::vector<NamedStrip>
nameStrips(const std::vector<RepairedStrip>& strips)
{
  std::vector<NamedStrip> named;
  std::map<std::pair<std::uint32_t, StructureLabel>, std::size_t> count;
  for (const auto& strip : strips) {
    const std::size_t number = ++count[{strip.room, strip.label}];
    NamedStrip s{&strip, "", strip.element.length()};
    bool has_cells = false;
    for (const auto& column : strip.columns) {
      if (column.cells == 0)
        continue;
      s.low = has_cells ? std::min(s.low, column.low) : column.low;
      s.high = has_cells ? std::max(s.high, column.high) : column.high;
      has_cells = true;
    }
    const char* kind = strip.label == StructureLabel::Column   ? "c"
                       : strip.label == StructureLabel::Detail ? "d"
                                                               : "";
    s.name = std::to_string(strip.room) + "." + kind + std::to_string(number);
    if (has_cells)
      named.push_back(std::move(s));
  }
  // From inside a wall runs from its end on the left to its start on the right.
  for (auto first = named.begin(); first != named.end();) {
    const auto last = std::find_if(first, named.end(), [&](const NamedStrip& s) {
      return s.strip->room != first->strip->room ||
             s.strip->label != first->strip->label;
    });
    std::reverse(first, last);
    first = last;
  }
  return named;
}

/** @brief The share of a column that was filled, 0 to 1. */
double
filledShare(const RepairedStrip::Column& column, const std::vector<bool>& is_seen)
{
  std::size_t filled = 0;
  for (std::size_t r = 0; r < column.cells; ++r)
    filled += is_seen[column.first + r] ? 0 : 1;
  return column.cells > 0
             ? static_cast<double>(filled) / static_cast<double>(column.cells)
             : 0;
}

/** @brief Boxes of a strip, seen and filled cells apart, its left end at the origin. */
struct StripBoxes {
  std::vector<Box> seen;
  std::vector<Box> filled;
};

StripBoxes
boxesOf(const NamedStrip& named,
        const std::vector<bool>& is_seen,
        const Eigen::Vector2d& origin)
{
  StripBoxes boxes;
  const auto& columns = named.strip->columns;
  const double width = named.length / static_cast<double>(columns.size());
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const auto& column = columns[c];
    const double left = named.length - static_cast<double>(c + 1) * width;
    const double height = (column.high - column.low) /
                          static_cast<double>(std::max<std::size_t>(1, column.cells));
    for (std::size_t r = 0; r < column.cells; ++r) {
      const Eigen::Vector2d low =
          origin + Eigen::Vector2d(left, column.low - named.low +
                                             static_cast<double>(r) * height);
      auto& side = is_seen[column.first + r] ? boxes.seen : boxes.filled;
      const bool goes_on =
          r > 0 && is_seen[column.first + r] == is_seen[column.first + r - 1];
      if (!goes_on)
        side.push_back({low, low});
      side.back().high = low + Eigen::Vector2d(width, height);
    }
  }
  return boxes;
}

/** @brief Strips in lines of at most that length, and how much plane they take. */
struct Lines {
  std::vector<Eigen::Vector2d> origins; ///< lower left corner of each strip
  Eigen::Vector2d size = Eigen::Vector2d::Zero();
};

Lines
breakIntoLines(const std::vector<NamedStrip>& strips, double length)
{
  Lines lines;
  double x = 0;
  double top = 0;
  double height = 0;
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
    lines.size.x() = std::max(lines.size.x(), x);
  }
  endLine(strips.size());
  lines.size.y() = -top;
  return lines;
}

/** @brief The lines that are drawn largest on a sheet of this shape. */
Lines
bestLines(const std::vector<NamedStrip>& strips)
{
  constexpr double sheet_width = 1150; // pixels
  constexpr double sheet_height = 560;
  double whole = 0;
  for (const auto& strip : strips)
    whole += strip.length + strip_gap;
  Lines best;
  double most = 0;
  for (int count = 1; count <= 40; ++count) {
    Lines lines = breakIntoLines(strips, 1.05 * whole / count);
    const double scale =
        std::min(sheet_width / lines.size.x(), sheet_height / lines.size.y());
    if (scale <= most)
      continue;
    most = scale;
    best = std::move(lines);
  }
  return best;
}

Panel
elevationPanel(const std::vector<NamedStrip>& strips, const std::vector<bool>& is_seen)
{
  Panel panel("all walls unrolled, as they look from inside");
  const Lines lines = bestLines(strips);
  for (std::size_t i = 0; i < strips.size(); ++i) {
    const StripBoxes boxes = boxesOf(strips[i], is_seen, lines.origins[i]);
    panel.addBoxes(boxes.seen, colourOf(strips[i].strip->label));
    panel.addBoxes(boxes.filled, colours::recovered);
    const Eigen::Vector2d above(strips[i].length / 2,
                                strips[i].high - strips[i].low + 0.3);
    panel.addLabel(lines.origins[i] + above, strips[i].name);
  }
  panel.setView({{-strip_gap, -lines.size.y() + line_gap / 2}, {lines.size.x(), 0.6}});
  return panel;
}

/** @brief The plan, every stretch of wall in the colour of how much of it was filled.
 */
Panel
planPanel(const Floorplan& plan,
          const std::vector<NamedStrip>& strips,
          const std::vector<bool>& is_seen)
{
  constexpr int shades = 5;
  constexpr double margin = 0.4;
  Panel panel("where walls were filled, and their names");
  for (const auto& named : strips) {
    const auto& columns = named.strip->columns;
    const double width = named.length / static_cast<double>(columns.size());
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const double share =
          std::round(filledShare(columns[c], is_seen) * shades) / shades;
      const double start = static_cast<double>(c) * width;
      panel.addPath({named.strip->element.pointAt(start),
                     named.strip->element.pointAt(start + width)},
                    mixed(colourOf(named.strip->label), colours::recovered, share), 4);
    }
  }
  for (const auto& named : strips)
    if (named.strip->label == StructureLabel::Wall) {
      const double middle = named.length / 2;
      panel.addLabel(named.strip->element.pointAt(middle) +
                         0.25 * named.strip->element.normalAt(middle),
                     named.name);
    }
  panel.setView(viewOf(plan, margin));
  return panel;
}

} // namespace

Picture
drawRepair(const RepairedSurfaces& surfaces, const Floorplan& plan)
{
  const std::vector<NamedStrip> strips = nameStrips(surfaces.strips);
  std::size_t cells = 0;
  std::size_t filled = 0;
  for (const auto& named : strips)
    for (const auto& column : named.strip->columns) {
      cells += column.cells;
      for (std::size_t r = 0; r < column.cells; ++r)
        filled += surfaces.is_seen[column.first + r] ? 0 : 1;
    }
  const double share = 100 * static_cast<double>(filled) /
                       static_cast<double>(std::max<std::size_t>(1, cells));
  Picture picture("Hole repair: " + std::to_string(filled) + " of " +
                  counted(cells, "cell") + " of upright surfaces filled, " +
                  fixedText(share, 0) + " %");
  picture.addRow({planPanel(plan, strips, surfaces.is_seen)});
  if (!strips.empty())
    picture.addRow({elevationPanel(strips, surfaces.is_seen)});
  picture.addLegend("wall, seen", colours::wall);
  picture.addLegend("column, seen", colours::column);
  picture.addLegend("riser of a detail, seen", colours::detail);
  picture.addLegend("filled", colours::recovered);
  picture.addNote("Besides, " + counted(surfaces.repaired_floor, "cell") +
                  " of floors and " + counted(surfaces.repaired_ceiling, "cell") +
                  " of ceilings were filled.");
  return picture;
}

} // namespace tools
} // namespace sedr
} // namespace pcl
