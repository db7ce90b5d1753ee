// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "panel.h"

#include <string>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief What a stage did, to be looked at: a title, rows of panels, and what the
 * colours mean. The same contents give the same pixels.
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

  /** @brief Panels beside each other, of one height: maps as wide as they need, charts
   * share what is left. */
  void addRow(std::vector<Panel> panels);

  /** @brief Maps of one view in as many rows as let them be largest. */
  void addMaps(const std::vector<Panel>& panels);

  /** @brief What a colour means; in the order in which they are added. */
  void addLegend(const std::string& meaning, Colour colour);

  /** @brief A line of words below the panels. */
  void addNote(const std::string& note) { notes_.push_back(note); }

  /** @brief The panels row by row. */
  const std::vector<std::vector<Panel>>& rows() const { return rows_; }

  Image draw() const;

private:
  struct Row {
    std::vector<Panel> panels;
    std::vector<Box> boxes; ///< of the panels' insides, pixels
  };
  struct Meaning {
    std::string text;
    Colour colour;
  };

  static double heightOfMaps(const std::vector<Panel>& panels, double most);

  /** @brief Places the panels of a row whose top is at `top`.
   * @return where the row ends */
  double place(Row& row, double top) const;

  /** @brief Draws legend and notes below `top`.
   * @return where they end */
  double drawLegend(Canvas& canvas, double top, double width) const;

  std::string title_;
  std::vector<std::vector<Panel>> rows_;
  std::vector<Meaning> legend_;
  std::vector<std::string> notes_;
};

} // namespace tools
} // namespace sedr
} // namespace pcl
