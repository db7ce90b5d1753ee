// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "colour.h"

#include "sedr_filters/src/grids/cell_set.h"
#include "sedr_surface/src/sheet/sheet.h"

#include <string>
#include <utility>
#include <vector>

namespace pcl::sedr::tools {

using Box = Eigen::AlignedBox2d;
using Places = std::vector<Eigen::Vector2d>;

/** @brief A map of a picture: shapes in metres, later ones on top, x to the right and y
 * up. Boxes and points are at least a pixel wide; widths of lines are pixels. */
class Panel {
public:
  explicit Panel(std::string panel_title = "")
      : title(std::move(panel_title))
  {}

  void addBoxes(std::vector<Box> boxes, Colour colour);
  void addCells(const CellSet& cells, double cell_size, Colour colour);

  /** @brief Adds points as squares of `size` metres. */
  void addPoints(const Places& points, Colour colour, double size = 0.04);

  /** @brief Adds a polyline. */
  void addPath(const Places& points, Colour colour, double pixels);

  /** @brief Adds the elements of a loop: segments in one colour, arcs in another. */
  void addLoop(const PlanLoop& loop, Colour segments, Colour arcs, double pixels);

  /** @brief Adds a text at a place, unless it overlaps an earlier one of the panel. */
  void addLabel(const Eigen::Vector2d& place, const std::string& text);

  /** @brief Sets the visible part of the plane; default: all shapes with a margin. */
  void setView(const Box& view) { view_ = view; }

  /** @brief Returns the visible part, never empty. */
  Box view() const;

  /** @brief Draws the map into a box of a sheet. */
  void draw(Sheet& sheet, const Box& box) const;

  std::string title;

private:
  void add(Sheet::Item item, const Places& extent);

  Box view_;
  Box bounds_;                     ///< of all shapes
  std::vector<Sheet::Item> items_; ///< in metres
};

/** @brief A picture of a stage's result: a title, maps, and a legend. The same content
 * gives the same bytes.
 * @code
 * Panel map("ceiling");
 * map.addCells(cells, 0.05, colours::ceiling);
 * Picture picture("one room");
 * picture.addMaps({map});
 * picture.addLegend("ceiling", colours::ceiling);
 * @endcode */
class Picture {
public:
  explicit Picture(std::string title)
      : title_(std::move(title))
  {}

  /** @brief Adds maps in as many rows as make them largest, all with the same view if
   * that is not empty. */
  void addMaps(std::vector<Panel> panels, const Box& view = {});

  /** @brief Adds a legend entry, in the order of calls. */
  void addLegend(const std::string& meaning, Colour colour)
  {
    legend_.emplace_back(meaning, colour);
  }

  const std::vector<std::vector<Panel>>& rows() const { return rows_; }

  /** @brief Returns the picture as a sheet whose unit is a pixel. */
  Sheet draw() const;

  std::string png() const { return sheetPng(draw()); }

private:
  std::string title_;
  std::vector<std::vector<Panel>> rows_;
  std::vector<std::pair<std::string, Colour>> legend_;
};

/** @brief Formats a count: "1 room", "3 rooms". */
inline std::string
counted(std::size_t number, const std::string& thing)
{
  return std::to_string(number) + " " + thing + (number == 1 ? "" : "s");
}

/** @brief Returns a box grown by `margin` on every side; empty stays empty. */
Box grown(const Box& box, double margin);

/** @brief Returns the extent of cells without outliers, since a scan may hold points
 * hundreds of metres away: a hundredth of the cells at each end is cut off if that
 * halves the view.
 * @return empty for no cells */
Box viewOf(const CellSet& cells, double cell_size);

} // namespace pcl::sedr::tools
