// SPDX-License-Identifier: BSD-3-Clause
#include "title_block.h"

#include "plan_layers.h"
#include "sedr_filters/src/base/number_text.h"

#include <algorithm>

namespace pcl::sedr {
namespace {

using namespace sheet_measures;

constexpr double row_height = title_height / 3;
constexpr double indent = 1.5;     ///< of texts within their cell
constexpr double north_width = 20; ///< of the cell with the arrow
constexpr SheetColour grey = 0x777777;

/** @brief Draws the strip, row by row from the top. */
class TitleStrip {
public:
  TitleStrip(Sheet& sheet, const SheetLayout& layout)
      : sheet_(sheet)
      , layout_(layout)
      , low_(margin_left, margin)
      , width_(layout.size.x() - margin_left - margin - north_width)
  {
    const Eigen::Vector2d high = layout.size - Eigen::Vector2d::Constant(margin);
    sheet.addBox(looks::frame, {low_, high});
    sheet.addBox(looks::cell, {low_, Eigen::Vector2d(high.x(), margin + title_height)});
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
    sheet_.addBox(looks::cell, {corner, corner + Eigen::Vector2d(width, row_height)});
    addText(grey, corner + Eigen::Vector2d(indent, row_height - 1.9), smallest_font,
            caption, width);
    addText(ink, corner + Eigen::Vector2d(indent, 3), font, text, width);
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
      sheet_.addBox({k % 2 == 0 ? ink : paper_colour, ink, 0.15},
                    {start + Eigen::Vector2d(k * part, 0),
                     start + Eigen::Vector2d((k + 1) * part, 1.3)});
    for (int k = 0; k <= 4; k += 2)
      sheet_.add(SheetText{0x444444, start + Eigen::Vector2d(k * part, 3.6),
                           smallest_font,
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
    sheet_.addLine({ink}, {at(0, 6), at(2.6, -6), at(0, -3.6), at(-2.6, -6)}, true);
    sheet_.add(SheetText{ink, at(0, 9), small_font, origin.isZero() ? "y" : "N"});
  }

private:
  Eigen::Vector2d cornerOf(int row, double share) const
  {
    return low_ + Eigen::Vector2d(share * width_, (2 - row) * row_height);
  }

  void addText(SheetColour colour,
               const Eigen::Vector2d& place,
               double font,
               const std::string& text,
               double width)
  {
    if (text.empty())
      return;
    const double fitting = (width - 2 * indent) / textWidth(text);
    sheet_.add(
        SheetText{colour, place, std::min(font, fitting), text, 0, TextAnchor::Start});
  }

  Sheet& sheet_;
  const SheetLayout& layout_;
  Eigen::Vector2d low_;
  double width_;
};

} // namespace

void
addTitleBlock(Sheet& sheet,
              const SheetLayout& layout,
              const DrawingSettings& settings,
              const TitleTexts& texts)
{
  TitleStrip strip(sheet, layout);
  const SheetTexts& given = settings.texts;
  const bool has_title = !given.title.empty();
  strip.addCell(0, 0, 0.3, has_title ? texts.usual_title : "Title",
                has_title ? given.title : texts.usual_title, large_font);
  strip.addCell(0, 0.3, 0.5, "Project", given.project, large_font);
  strip.addCell(0, 0.5, 0.7, "Client", given.client, large_font);
  strip.addCell(0, 0.7, 0.85, texts.part_caption, texts.part, large_font);
  strip.addCell(0, 0.85, 1, "Scale",
                "1:" + shortDecimalText(layout.scale, 2) + " " + layout.paper,
                large_font);
  strip.addCell(1, 0, 0.3, texts.summary_caption, texts.summary);
  strip.addCell(1, 0.3, 0.4, "Date", given.date);
  strip.addCell(1, 0.4, 0.5, "Drawn", given.drawn_by);
  strip.addCell(1, 0.5, 0.6, "Checked", "");
  strip.addCell(1, 0.6, 1, "", "");
  strip.addScaleBar(1, 0.6);
  const bool has_origin = !settings.origin.isZero();
  strip.addCell(2, 0, has_origin ? 0.65 : 1, "Notes", texts.notes);
  if (has_origin)
    strip.addCell(2, 0.65, 1, "Origin of coordinates, m", settings.origin.text(", "));
  if (texts.has_north)
    strip.addNorth(settings.origin);
}

} // namespace pcl::sedr
