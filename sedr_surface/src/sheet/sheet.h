// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Core>

#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Lines and arcs of a sheet that look alike: one of sheet_looks. Places are
 * millimetres of paper from its lower left corner, y up. */
struct SheetPath {
  std::string look;
  std::vector<PlanLoop> chains; ///< each goes on where the last element ended
  bool is_closed = false;
};

enum class TextAnchor { Middle, Start };

/** @brief A line of text of a sheet: one of text_looks. */
struct SheetText {
  std::string look;
  Eigen::Vector2d place = Eigen::Vector2d::Zero(); ///< half the letters' height up
  double font = 0;                                 ///< millimetres
  std::string text;                                ///< UTF-8
  double degrees = 0;                              ///< against the clock
  TextAnchor anchor = TextAnchor::Middle;
  bool has_halo = false; ///< lines stop before it
};

/** @brief What follows belongs together, until a SheetGroup without a name. */
struct SheetGroup {
  std::string name; ///< such as "room_1"
};

/** @brief A drawing on paper, for any format. */
struct Sheet {
  Eigen::Vector2d size = Eigen::Vector2d::Zero(); ///< millimetres
  std::string title;
  std::string description; ///< for programs; may be empty
  std::vector<std::variant<SheetPath, SheetText, SheetGroup>> items{};

  template <typename Item>
  void add(Item item)
  {
    items.emplace_back(std::move(item));
  }

  /** @brief Straight lines from place to place. */
  void addLine(const std::string& look,
               const std::vector<Eigen::Vector2d>& places,
               bool is_closed = false);
};

/** @brief The sheet as SVG in millimetres. */
std::string sheetSvg(const Sheet& sheet);

/** @brief The sheet as a page of PDF 1.4, in Helvetica, which every viewer has. Letters
 * that are not of Western Europe become "?". The same sheet gives the same bytes. */
std::string sheetPdf(const Sheet& sheet);

} // namespace sedr
} // namespace pcl
