// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Geometry>

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace pcl::sedr {

/** @brief A colour 0xRRGGBB, or none. */
using SheetColour = std::int32_t;
constexpr SheetColour no_colour = -1;
constexpr SheetColour paper_colour = 0xffffff;
constexpr SheetColour ink = 0x111111;

/** @brief How lines and areas look; widths and dashes in units of the sheet. */
struct SheetLook {
  SheetColour fill = no_colour;
  SheetColour stroke = no_colour;
  double width = 0;
  std::vector<double> dash{}; ///< strokes and gaps in turn; empty: solid
};

/** @brief Lines and arcs with one look, or the area within them (even-odd). */
struct SheetPath {
  SheetLook look;
  std::vector<PlanLoop> chains; ///< consecutive elements are connected
  bool is_closed = false;
};

/** @brief Filled boxes of one colour without seams between them, such as cells and
 * points; each is at least a unit of the sheet wide and high. */
struct SheetBoxes {
  SheetColour fill = ink;
  std::vector<Eigen::AlignedBox2d> boxes;
};

enum class TextAnchor { Start, Middle, End };

/** @brief A line of text. */
struct SheetText {
  SheetColour colour = ink;
  Eigen::Vector2d place = Eigen::Vector2d::Zero(); ///< anchor, at half letter height
  double font = 0;                                 ///< font size
  std::string text;                                ///< UTF-8
  double degrees = 0;                              ///< counter-clockwise
  TextAnchor anchor = TextAnchor::Middle;
  SheetColour ground = no_colour; ///< of a box that hides lines behind the text
  bool is_bold = false;
};

/** @brief Starts a group of items, up to the next one; SVG names it. */
struct SheetGroup {
  std::string name; ///< such as "room_1"; may be empty
};

/** @brief Paths and boxes that follow are in the coordinates of `view`, which fills
 * `box` of the sheet, and are seen only there; texts and widths of lines stay in those
 * of the sheet. Both have the same proportions. An empty box or a group ends that. */
struct SheetView {
  Eigen::AlignedBox2d box;
  Eigen::AlignedBox2d view;
};

/** @brief A drawing for any format: items in the order in which they are drawn. x runs
 * to the right from the left edge, y upwards. The unit is a millimetre of paper
 * for SVG and PDF; for PNG it is a pixel. */
struct Sheet {
  using Item = std::variant<SheetPath, SheetBoxes, SheetText, SheetGroup, SheetView>;

  Eigen::Vector2d size = Eigen::Vector2d::Zero();
  double bottom = 0; ///< y of the lower edge
  std::string title{};
  std::string description{}; ///< metadata; may be empty
  std::vector<Item> items{};

  void add(Item item) { items.push_back(std::move(item)); }

  /** @brief Adds a polyline. */
  void addLine(const SheetLook& look,
               const std::vector<Eigen::Vector2d>& places,
               bool is_closed = false);

  /** @brief Adds the outline or area of a box. */
  void addBox(const SheetLook& look, const Eigen::AlignedBox2d& box);
};

/** @brief Returns the sheet as SVG. Texts stay texts, groups have their names as ids.
 * The same sheet gives the same bytes, as in the other formats. */
std::string sheetSvg(const Sheet& sheet);

/** @brief Returns the sheet as a page of PDF with the letters that it needs. */
std::string sheetPdf(const Sheet& sheet);

/** @brief Returns the sheet as PNG.
 * @param pixels per unit */
std::string sheetPng(const Sheet& sheet, double pixels = 1);

/** @brief Returns the width of a line of text over its font size. */
double textWidth(const std::string& utf8, bool is_bold = false);

/** @brief Loads the fonts, which crashes in fontconfig where memory ends: before the
 * points of a scan take it. */
void loadFonts();

} // namespace pcl::sedr
