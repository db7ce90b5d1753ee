// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "panel.h"

#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief A picture of a stage's result: a title, rows of panels, and a legend. The
 * same content gives the same bytes.
 * @code
 * Panel map("ceiling");
 * map.addCells(cells, 0.05, colours::ceiling);
 * Picture picture("one room");
 * picture.addMaps({map});
 * picture.addLegend("ceiling", colours::ceiling);
 * savePicture("room.png", picture);
 * @endcode */
class Picture {
public:
  explicit Picture(std::string title)
      : title_(std::move(title))
  {}

  /** @brief Adds panels of equal height side by side. Maps are as wide as needed;
   * charts share the rest. */
  void addRow(std::vector<Panel> panels);

  /** @brief Adds maps with the same view in as many rows as make them largest. */
  void addMaps(const std::vector<Panel>& panels);

  /** @brief Adds a legend entry, in the order of calls. */
  void addLegend(const std::string& meaning, Colour colour);

  /** @brief Adds a line of text below the panels. */
  void addNote(const std::string& note) { notes_.push_back(note); }

  /** @brief Returns the panels row by row. */
  const std::vector<std::vector<Panel>>& rows() const { return rows_; }

  /** @brief Returns the picture as a sheet whose unit is a pixel. */
  Sheet draw() const;

  std::string png() const { return sheetPng(draw()); }

private:
  struct Meaning {
    std::string text;
    Colour colour;
  };

  /** @brief Draws a row below `top`; places count downwards from there.
   * @return the bottom of the row */
  double drawRow(Sheet& sheet, const std::vector<Panel>& row, double top) const;
  double drawLegend(Sheet& sheet, double top) const;

  std::string title_;
  std::vector<std::vector<Panel>> rows_;
  std::vector<Meaning> legend_;
  std::vector<std::string> notes_;
};

} // namespace pcl::sedr::tools
