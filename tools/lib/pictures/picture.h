// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "colour.h"

#include "sedr_filters/src/grids/cell_set.h"
#include "sedr_surface/src/sheet/sheet.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace pcl::sedr::tools {

using Box = Eigen::AlignedBox2d;
using Places = std::vector<Eigen::Vector2d>;
using ColouredCells = std::map<Colour, std::vector<CellKey>>;

/** @brief A map of a picture: shapes in metres, later ones on top, x to the right and y
 * up. Cells and points are at least a pixel wide; widths of lines are pixels. */
struct Panel {
  /** @param view the visible part of the plane; empty: there is nothing to see */
  Panel(std::string title, const Box& view);

  void addCells(const ColouredCells& cells, double cell_size);

  /** @brief Adds points as squares of `size` metres. */
  void addPoints(const Places& points, Colour colour, double size = 0.04);

  void addLines(std::vector<PlanLoop> lines, Colour colour, double pixels)
  {
    shapes.emplace_back(SheetPath{{no_colour, colour, pixels}, std::move(lines)});
  }

  /** @brief Adds the outlines of rooms, niches, columns and details in the colours of
   * their meanings, or all in one. */
  void addPlan(const Floorplan& plan, double pixels, Colour all = no_colour);

  /** @brief Draws the map on a sheet.
   * @param corner the lower left one of the map
   * @param scale pixels per metre */
  void draw(const Eigen::Vector2d& corner, double scale, Sheet& sheet) const;

  std::string title;
  Box view;
  std::vector<Sheet::Item> shapes{}; ///< in metres
  /// Texts at places; what would overlap an earlier one is left out.
  std::vector<std::pair<Eigen::Vector2d, std::string>> labels{};
};

/** @brief A picture of a stage's result: a title, maps at one scale in rows, its bar,
 * and a legend. The same content gives the same bytes. */
struct Picture {
  std::string title;
  std::vector<Panel> maps{};
  std::vector<std::pair<std::string, Colour>> legend{};

  std::string png() const;
};

/** @brief Formats a count: "1 room", "3 rooms". */
inline std::string
counted(std::size_t number, const std::string& thing)
{
  return std::to_string(number) + " " + thing + (number == 1 ? "" : "s");
}

/** @brief Returns the extent of cells, with a margin, without outliers, since a scan
 * may hold points hundreds of metres away: a hundredth of the cells at each end is cut
 * off if that halves the view.
 * @return empty for no cells */
Box viewOf(const CellSet& cells, double cell_size);

/** @brief Returns the extent of the rooms of plans, with a margin. */
Box viewOf(const std::vector<const Floorplan*>& plans);

} // namespace pcl::sedr::tools
