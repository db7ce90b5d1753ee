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
  /** @param view the visible part of the plane; empty: there is nothing to see */
  Panel(std::string title, const Box& view);

  void addBoxes(std::vector<Box> boxes, Colour colour);
  void addCells(const CellSet& cells, double cell_size, Colour colour);

  /** @brief Adds points as squares of `size` metres. */
  void addPoints(const Places& points, Colour colour, double size = 0.04);

  void addLines(std::vector<PlanLoop> lines, Colour colour, double pixels);

  /** @brief Adds the outlines of rooms, niches, columns and details in the colours of
   * their meanings, or all in one. */
  void addPlan(const Floorplan& plan, double pixels, Colour all = no_colour);

  /** @brief Adds a text at a place, unless it overlaps an earlier one of the panel. */
  void addLabel(const Eigen::Vector2d& place, const std::string& text)
  {
    labels_.emplace_back(place, text);
  }

  const std::string& title() const { return title_; }
  const Box& view() const { return view_; }

  /** @brief Draws the map on a sheet.
   * @param corner the lower left one of the map
   * @param scale pixels per metre */
  void draw(const Eigen::Vector2d& corner, double scale, Sheet& sheet) const;

private:
  std::string title_;
  Box view_;
  std::vector<Sheet::Item> shapes_; ///< in metres
  std::vector<std::pair<Eigen::Vector2d, std::string>> labels_;
};

/** @brief A picture of a stage's result: a title, maps at one scale, its bar, and a
 * legend. The same content gives the same bytes.
 * @code
 * Panel map("ceiling", viewOf(cells, 0.05));
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

  /** @brief Adds maps in a row, or in several where that makes them much larger. */
  void addMaps(std::vector<Panel> maps) { rows_.push_back(std::move(maps)); }

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
  /** @brief Returns the largest scale at which all maps fit, pixels per metre. */
  double scale() const;

  /** @brief Draws the maps below the title; returns the lower edge of the last ones. */
  double drawMaps(Sheet& sheet) const;

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

/** @brief Returns the extent of cells, with a margin, without outliers, since a scan
 * may hold points hundreds of metres away: a hundredth of the cells at each end is cut
 * off if that halves the view.
 * @return empty for no cells */
Box viewOf(const CellSet& cells, double cell_size);

/** @brief Returns the extent of the rooms of plans, with a margin. */
Box viewOf(const std::vector<const Floorplan*>& plans);

} // namespace pcl::sedr::tools
