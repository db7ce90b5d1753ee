// SPDX-License-Identifier: BSD-3-Clause
#include "repair_picture.h"

#include "map_cells.h"
#include "plan_layers.h"
#include "scale.h"
#include "unrolled_walls.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::sedr::tools {

namespace {

/** @brief Returns the share of a column that was filled, 0 to 1. */
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

Colour
colourOfStrip(const NamedStrip& strip)
{
  return tools::colourOf(strip.parts.front()->label);
}

Panel
elevationPanel(const std::vector<NamedStrip>& strips,
               const std::vector<bool>& is_seen,
               double sheet_width,
               double sheet_height)
{
  Panel panel("all walls unrolled, as they look from inside");
  const StripLines lines = breakIntoLines(strips, sheet_width, sheet_height);
  for (std::size_t i = 0; i < strips.size(); ++i) {
    StripBoxes boxes = boxesOf(strips[i], is_seen, lines.origins[i]);
    panel.addBoxes(std::move(boxes.seen), colourOfStrip(strips[i]));
    panel.addBoxes(std::move(boxes.filled), colours::recovered);
    panel.addLabel(lines.origins[i] +
                       Eigen::Vector2d(strips[i].length / 2, nameHeight(strips[i])),
                   strips[i].name);
  }
  panel.setView(lines.view);
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
  for (const auto& strip : strips) {
    const auto& columns = strip.parts.front()->columns;
    const double width = strip.length / static_cast<double>(columns.size());
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const double share =
          std::round(filledShare(columns[c], is_seen) * shades) / shades;
      const double start = static_cast<double>(c) * width;
      panel.addPath(
          {strip.element().pointAt(start), strip.element().pointAt(start + width)},
          mixed(colourOfStrip(strip), colours::recovered, share), 4);
    }
  }
  for (const auto& strip : strips)
    if (strip.kind() == VerticalKind::Wall) {
      const double middle = strip.length / 2;
      panel.addLabel(strip.element().pointAt(middle) +
                         0.25 * strip.element().normalAt(middle),
                     strip.name);
    }
  panel.setView(viewOf(plan, margin));
  return panel;
}

/** @brief Adds plan and walls side by side if the plan is narrow, else below each
 * other. */
void
addPanels(const std::vector<NamedStrip>& strips,
          const std::vector<bool>& is_seen,
          const Floorplan& plan,
          Picture& picture)
{
  // Approximate, pixels.
  constexpr double sheet_width = 1150;
  constexpr double sheet_height = 480;
  const Panel where = planPanel(plan, strips, is_seen);
  const double plan_width =
      sheet_height * where.view().size().x() / where.view().size().y();
  const bool is_narrow = plan_width < 0.5 * sheet_width;
  const Panel walls =
      elevationPanel(strips, is_seen,
                     is_narrow ? sheet_width - plan_width : sheet_width, sheet_height);
  if (is_narrow)
    picture.addRow({where, walls});
  else {
    picture.addRow({where});
    picture.addRow({walls});
  }
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
  for (const auto& strip : surfaces.strips)
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
  if (!strips.empty())
    addPanels(strips, surfaces.is_seen, plan, picture);
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
