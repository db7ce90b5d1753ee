// SPDX-License-Identifier: BSD-3-Clause
#include "repair_picture.h"

#include "map_cells.h"
#include "plan_layers.h"
#include "scale.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace pcl::sedr::tools {
namespace {

constexpr double strip_gap = 0.15; ///< between strips in a line, metres
constexpr double line_gap = 0.7;   ///< between lines, with the names of the strips

/** @brief A wall, column face, riser or niche side; the parts above and below a niche
 * in one wall are one. */
struct NamedStrip {
  std::vector<const RepairedStrip*> parts;
  std::string name; ///< "2.3": wall 3 of room 2; c columns, d risers, s steps, n niches
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  const RepairedStrip& first() const { return *parts.front(); }
  double length() const { return first().element.length(); }
  double height() const { return high - low; }
};

std::string
letterOf(VerticalKind kind)
{
  return kind == VerticalKind::ColumnFace     ? "c"
         : kind == VerticalKind::CeilingRiser ? "d"
         : kind == VerticalKind::FloorRiser   ? "s"
         : kind == VerticalKind::NicheSide    ? "n"
                                              : "";
}

/** @brief Names the strips that have cells. */
std::vector<NamedStrip>
nameStrips(const std::vector<RepairedStrip>& strips)
{
  std::vector<NamedStrip> named;
  std::map<std::pair<std::uint32_t, VerticalKind>, std::size_t> count;
  for (const RepairedStrip& strip : strips) {
    const auto isSameWall = [&](const NamedStrip& other) {
      return strip.kind == VerticalKind::WallAboveNiche &&
             other.first().kind == VerticalKind::Wall &&
             other.first().room == strip.room &&
             other.first().element.start == strip.element.start &&
             other.first().element.end == strip.element.end;
    };
    auto wall = std::find_if(named.begin(), named.end(), isSameWall);
    if (wall == named.end()) {
      named.emplace_back();
      wall = named.end() - 1;
      wall->name = std::to_string(strip.room) + "." + letterOf(strip.kind) +
                   std::to_string(++count[{strip.room, strip.kind}]);
    }
    wall->parts.push_back(&strip);
    for (const auto& column : strip.columns)
      if (column.cells > 0) {
        wall->low = std::min(wall->low, column.low);
        wall->high = std::max(wall->high, column.high);
      }
  }
  named.erase(std::remove_if(named.begin(), named.end(),
                             [](const NamedStrip& s) { return !(s.height() > 0); }),
              named.end());
  // From inside, the walls of a room follow each other clockwise.
  for (auto first = named.begin(); first != named.end();) {
    const auto last = std::find_if(first, named.end(), [&](const NamedStrip& s) {
      return s.first().room != first->first().room ||
             s.first().kind != first->first().kind;
    });
    std::reverse(first, last);
    first = last;
  }
  return named;
}

/** @brief Returns the lower left corners of strips that are broken into lines of a
 * length like words; the first line ends at y = 0, the others are below. */
Places
cornersOf(const std::vector<NamedStrip>& strips, double length)
{
  Places corners;
  double top = 0;
  for (std::size_t first = 0; first < strips.size();) {
    double x = 0;
    double height = 0;
    std::size_t last = first;
    for (; last < strips.size() && (x == 0 || x + strips[last].length() <= length);
         ++last) {
      corners.emplace_back(x, 0);
      x += strips[last].length() + strip_gap;
      height = std::max(height, strips[last].height());
    }
    for (; first < last; ++first)
      corners[first].y() = top - height;
    top -= height + line_gap;
  }
  return corners;
}

/** @brief Calls `use(box, is_seen)` for runs of cells of a strip seen from inside. */
template <typename Use>
void
forEachRun(const NamedStrip& strip,
           const std::vector<bool>& is_seen,
           const Eigen::Vector2d& corner,
           Use use)
{
  for (const RepairedStrip* part : strip.parts) {
    const double width = strip.length() / static_cast<double>(part->columns.size());
    for (std::size_t c = 0; c < part->columns.size(); ++c) {
      const RepairedStrip::Column& column = part->columns[c];
      const double left = strip.length() - static_cast<double>(c + 1) * width;
      const double cell =
          (column.high - column.low) / static_cast<double>(column.cells);
      for (std::size_t from = 0, to = 0; from < column.cells; from = to) {
        const bool seen = is_seen[column.first + from];
        while (to < column.cells && is_seen[column.first + to] == seen)
          ++to;
        const auto at = [&](double x, std::size_t row) -> Eigen::Vector2d {
          return corner + Eigen::Vector2d(x, column.low - strip.low +
                                                 cell * static_cast<double>(row));
        };
        use(Box(at(left, from), at(left + width, to)), seen);
      }
    }
  }
}

/** @brief Draws all strips in so many lines that they are largest on a sheet. */
Panel
elevationPanel(const std::vector<NamedStrip>& strips,
               const std::vector<bool>& is_seen,
               const Eigen::Vector2d& sheet)
{
  constexpr int max_lines = 40;
  double whole = 0;
  for (const NamedStrip& strip : strips)
    whole += strip.length() + strip_gap;
  Places corners;
  Box view;
  double most = 0;
  for (int lines = 1; lines <= max_lines; ++lines) {
    const Places tried = cornersOf(strips, 1.05 * whole / lines);
    Box box(Eigen::Vector2d(-strip_gap, 0), Eigen::Vector2d(0, line_gap));
    for (std::size_t i = 0; i < strips.size(); ++i)
      box.extend(Eigen::Vector2d(tried[i] +
                                 Eigen::Vector2d(strips[i].length() + strip_gap, 0)))
          .extend(Eigen::Vector2d(tried[i] - Eigen::Vector2d(0, line_gap / 2)));
    const double scale = sheet.cwiseQuotient(box.sizes()).minCoeff();
    if (scale <= most)
      continue;
    most = scale;
    corners = tried;
    view = box;
  }
  Panel panel("all walls unrolled, as they look from inside");
  for (std::size_t i = 0; i < strips.size(); ++i) {
    std::vector<Box> seen;
    std::vector<Box> filled;
    forEachRun(strips[i], is_seen, corners[i], [&](const Box& box, bool is_of_scan) {
      (is_of_scan ? seen : filled).push_back(box);
    });
    panel.addBoxes(std::move(seen), colourOf(strips[i].first().label));
    panel.addBoxes(std::move(filled), colours::recovered);
    panel.addLabel(corners[i] + Eigen::Vector2d(strips[i].length() / 2,
                                                strips[i].height() + line_gap / 2),
                   strips[i].name);
  }
  panel.setView(view);
  return panel;
}

/** @brief Draws the plan with every stretch of wall coloured by its filled share. */
Panel
planPanel(const Floorplan& plan,
          const std::vector<NamedStrip>& strips,
          const std::vector<bool>& is_seen)
{
  constexpr int shades = 5;
  constexpr double margin = 0.4;
  Panel panel("where walls were filled");
  for (const NamedStrip& strip : strips) {
    const PlanElement& element = strip.first().element;
    const auto& columns = strip.first().columns;
    const double width = strip.length() / static_cast<double>(columns.size());
    const auto shadeOf = [&](const RepairedStrip::Column& column) {
      const auto first = is_seen.begin() + static_cast<std::ptrdiff_t>(column.first);
      const auto cells = static_cast<std::ptrdiff_t>(column.cells);
      const auto filled = static_cast<double>(std::count(first, first + cells, false));
      return cells > 0 ? std::round(filled / static_cast<double>(cells) * shades) : 0;
    };
    for (std::size_t from = 0, to = 0; from < columns.size(); from = to) {
      Places path{element.pointAt(static_cast<double>(from) * width)};
      const double shade = shadeOf(columns[from]);
      while (to < columns.size() && shadeOf(columns[to]) == shade)
        path.push_back(element.pointAt(static_cast<double>(++to) * width));
      panel.addPath(
          path,
          mixed(colourOf(strip.first().label), colours::recovered, shade / shades), 4);
    }
  }
  for (const NamedStrip& strip : strips)
    if (strip.first().kind == VerticalKind::Wall) {
      const double middle = strip.length() / 2;
      panel.addLabel(strip.first().element.pointAt(middle) +
                         0.25 * strip.first().element.normalAt(middle),
                     strip.name);
    }
  panel.setView(viewOf(plan, margin));
  return panel;
}

} // namespace

RepairedSurfaces&
RepairedSurfaces::operator+=(const RepairedSurfaces& other)
{
  for (RepairedStrip strip : other.strips) {
    for (auto& column : strip.columns)
      column.first += is_seen.size();
    strips.push_back(std::move(strip));
  }
  is_seen.insert(is_seen.end(), other.is_seen.begin(), other.is_seen.end());
  repaired_floor += other.repaired_floor;
  repaired_ceiling += other.repaired_ceiling;
  return *this;
}

Picture
drawRepair(const RepairedSurfaces& surfaces, const Floorplan& plan)
{
  const std::vector<NamedStrip> strips = nameStrips(surfaces.strips);
  std::size_t cells = 0;
  std::size_t filled = 0;
  for (const RepairedStrip& strip : surfaces.strips)
    for (const auto& column : strip.columns) {
      cells += column.cells;
      for (std::size_t r = 0; r < column.cells; ++r)
        filled += surfaces.is_seen[column.first + r] ? 0 : 1;
    }
  const double share = 100 * static_cast<double>(filled) /
                       static_cast<double>(std::max<std::size_t>(1, cells));
  Picture picture("Hole repair: " + std::to_string(filled) + " of " +
                  counted(cells, "cell") + " of vertical surfaces filled, " +
                  fixedText(share, 0) + " %");
  if (!strips.empty()) {
    // Side by side if the plan is narrow, else below each other; pixels.
    Eigen::Vector2d sheet(1150, 480);
    const Panel where = planPanel(plan, strips, surfaces.is_seen);
    const Eigen::Vector2d size = where.view().sizes();
    const double across = sheet.y() * size.x() / size.y();
    const bool is_narrow = across < 0.5 * sheet.x();
    sheet.x() -= is_narrow ? across : 0;
    const Panel walls = elevationPanel(strips, surfaces.is_seen, sheet);
    picture.addRow(is_narrow ? std::vector<Panel>{where, walls}
                             : std::vector<Panel>{where});
    if (!is_narrow)
      picture.addRow({walls});
  }
  picture.addLegend("wall, seen", colours::wall);
  picture.addLegend("column, seen", colours::column);
  picture.addLegend("riser or niche, seen", colours::detail);
  picture.addLegend("filled", colours::recovered);
  picture.addNote("Besides, " + counted(surfaces.repaired_floor, "cell") +
                  " of floors and " + counted(surfaces.repaired_ceiling, "cell") +
                  " of ceilings were filled.");
  return picture;
}

} // namespace pcl::sedr::tools
