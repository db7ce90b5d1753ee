// SPDX-License-Identifier: BSD-3-Clause
#include "title_block.h"

#include "../formats/decimal_text.h"
#include "text_places.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {
namespace {

using namespace sheet_measures;

constexpr double row_height = title_height / 3;
constexpr double caption_font = 1.8;
constexpr double indent = 1.5;     ///< of texts within their cell
constexpr double north_width = 20; ///< of the cell with the arrow

/** @brief Draws the strip, row by row. */
class TitleStrip {
public:
  TitleStrip(Sheet& sheet, const SheetLayout& layout)
      : sheet_(sheet)
      , layout_(layout)
      , low_(margin_left, margin)
      , width_(layout.size.x() - margin_left - margin - north_width)
  {}

  void addFrame()
  {
    const Eigen::Vector2d high = layout_.size - Eigen::Vector2d::Constant(margin);
    addBox("frame", low_, high);
    addBox("cell", low_, {high.x(), low_.y() + title_height});
    addBox("cell", {high.x() - north_width, low_.y()},
           {high.x(), low_.y() + title_height});
  }

  /** @brief Adds a cell between two shares of the width; its text is made to fit. */
  void addCell(int row,
               double from,
               double to,
               const std::string& caption,
               const std::string& text,
               double font = small_font)
  {
    const Eigen::Vector2d corner = cornerOf(row, from);
    const double width = (to - from) * width_;
    addBox("cell", corner, corner + Eigen::Vector2d(width, row_height));
    addText("caption", corner + Eigen::Vector2d(indent, row_height - 1.9), caption_font,
            caption, width);
    addText("title", corner + Eigen::Vector2d(indent, 3), font, text, width);
  }

  /** @brief Adds a scale bar of 25 to 62.5 mm in four parts. */
  void addScaleBar(int row, double from)
  {
    const double per_metre = 1000 / layout_.scale;
    double length = 0.01;
    for (int k = 0; length * per_metre < 25; ++k)
      length *= k % 3 == 1 ? 2.5 : 2; // 1, 2, 5, 10
    const double part = length * per_metre / 4;
    const Eigen::Vector2d start = cornerOf(row, from) + Eigen::Vector2d(4, 2.2);
    for (int k = 0; k < 4; ++k)
      addBox(k % 2 == 0 ? "bar_dark" : "bar_light",
             start + Eigen::Vector2d(k * part, 0),
             start + Eigen::Vector2d((k + 1) * part, 1.3));
    for (int k = 0; k <= 4; k += 2)
      sheet_.add(SheetText{"size", start + Eigen::Vector2d(k * part, 3.6), caption_font,
                           shortDecimalText(length * k / 4, 3) + (k == 4 ? " m" : "")});
  }

  /** @brief Adds an arrow along y of the plan, which is north if the origin belongs to
   * a map grid. */
  void addNorth(const Origin& origin)
  {
    const Eigen::Vector2d middle(layout_.size.x() - margin - north_width / 2,
                                 margin + title_height / 2);
    const Eigen::Rotation2Dd turn(layout_.frame.turn);
    const auto at = [&](double x, double y) -> Eigen::Vector2d {
      return middle + turn * Eigen::Vector2d(x, y);
    };
    sheet_.addLine("north",
                   {at(0, 6), at(2.6, -6), at(0, -3.6), at(-2.6, -6), at(0, 6)}, true);
    sheet_.add(SheetText{"title", at(0, 9), small_font, origin.isZero() ? "y" : "N"});
  }

private:
  Eigen::Vector2d cornerOf(int row, double share) const
  {
    return low_ + Eigen::Vector2d(share * width_, (2 - row) * row_height);
  }

  void addBox(const char* look, const Eigen::Vector2d& low, const Eigen::Vector2d& high)
  {
    sheet_.addLine(look, {low, {high.x(), low.y()}, high, {low.x(), high.y()}, low},
                   true);
  }

  void addText(const char* look,
               const Eigen::Vector2d& place,
               double font,
               const std::string& text,
               double width)
  {
    if (text.empty())
      return;
    const double fitting = (width - 2 * indent) / (2 * halfSizeOf({text}).x());
    sheet_.add(
        SheetText{look, place, std::min(font, fitting), text, 0, TextAnchor::Start});
  }

  Sheet& sheet_;
  const SheetLayout& layout_;
  Eigen::Vector2d low_;
  double width_;
};

std::string
scaleText(const SheetLayout& layout)
{
  return "1:" + shortDecimalText(layout.scale, 2) +
         (layout.paper.empty() ? "" : "  " + layout.paper);
}

std::string
notesText(const TitleBlock& block)
{
  std::string text = "Dimensions in metres, from face to face. Dashed: overhead. "
                     "h: height of the ceiling above the floor.";
  if (block.has_slopes)
    text += " Dotted: headroom.";
  return text + " Walls filled where both faces were scanned.";
}

} // namespace

void
addTitleBlock(Sheet& sheet, const SheetLayout& layout, const TitleBlock& block)
{
  TitleStrip strip(sheet, layout);
  strip.addFrame();
  strip.addCell(0, 0, 0.45, "Title", block.title, large_font);
  strip.addCell(0, 0.45, 0.75, "Storey", block.storey.empty() ? "all" : block.storey,
                large_font);
  strip.addCell(0, 0.75, 1, "Scale", scaleText(layout), large_font);
  strip.addCell(1, 0, 0.3, "Rooms, floor area",
                std::to_string(block.rooms) +
                    (block.rooms == 1 ? " room, " : " rooms, ") +
                    decimalText(block.area, 2) + " m²");
  for (const auto& [from, caption] :
       {std::make_pair(0.3, "Date"), std::make_pair(0.4, "Drawn"),
        std::make_pair(0.5, "Checked")})
    strip.addCell(1, from, from + 0.1, caption, "");
  strip.addCell(1, 0.6, 1, "", "");
  strip.addScaleBar(1, 0.6);
  const bool has_origin = !block.origin.isZero();
  strip.addCell(2, 0, has_origin ? 0.65 : 1, "Notes", notesText(block));
  if (has_origin)
    strip.addCell(2, 0.65, 1, "Origin of coordinates, m", block.origin.text(", "));
  strip.addNorth(block.origin);
}

} // namespace pcl::sedr
