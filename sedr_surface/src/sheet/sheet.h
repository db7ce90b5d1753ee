// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Core>

#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace pcl::sedr {

/** @brief Lines and arcs of a sheet with the same look, one of sheet_looks. Coordinates
 * are millimetres of paper from the lower left corner, y up. */
struct SheetPath {
  std::string look;
  std::vector<PlanLoop> chains; ///< consecutive elements are connected
  bool is_closed = false;
};

enum class TextAnchor { Middle, Start };

/** @brief A line of text of a sheet, with one of text_looks. */
struct SheetText {
  std::string look;
  Eigen::Vector2d place = Eigen::Vector2d::Zero(); ///< anchor, at half letter height
  double font = 0;                                 ///< font size, millimetres
  std::string text;                                ///< UTF-8
  double degrees = 0;                              ///< counter-clockwise
  TextAnchor anchor = TextAnchor::Middle;
  bool has_halo = false; ///< lines are interrupted around it
};

/** @brief Starts a group of items, up to the next SheetGroup; without a name it ends
 * one. */
struct SheetGroup {
  std::string name; ///< such as "room_1"
};

/** @brief A drawing on paper, for any format. */
struct Sheet {
  Eigen::Vector2d size = Eigen::Vector2d::Zero(); ///< millimetres
  std::string title;
  std::string description; ///< metadata; may be empty
  std::vector<std::variant<SheetPath, SheetText, SheetGroup>> items{};

  template <typename Item>
  void add(Item item)
  {
    items.emplace_back(std::move(item));
  }

  /** @brief Adds a polyline. */
  void addLine(const std::string& look,
               const std::vector<Eigen::Vector2d>& places,
               bool is_closed = false);
};

/** @brief Writes the sheet as SVG in millimetres. */
std::string sheetSvg(const Sheet& sheet);

/** @brief Writes the sheet as a page of PDF 1.4 in Helvetica, which every viewer has.
 * Letters outside Western European become "?". The same sheet gives the same bytes. */
std::string sheetPdf(const Sheet& sheet);

} // namespace pcl::sedr
