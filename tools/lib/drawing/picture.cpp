// SPDX-License-Identifier: BSD-3-Clause
#include "picture.h"

#include "scale.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr::tools {
namespace {

// Pixels.
constexpr double width = 1200;
constexpr double narrowest = 528;
constexpr double margin = 16;
constexpr double gap = 24;
constexpr double title_height = 40;
constexpr double panel_title_height = 28;
constexpr double bar_height = 26;      ///< below a map, for its scale bar
constexpr double axis_height = 46;     ///< below a chart, for its numbers
constexpr double axis_width = 46;      ///< beside a chart, likewise
constexpr double chart_width = 330;    ///< minimum, including numbers
constexpr double chart_height = 240;   ///< minimum, without numbers
constexpr double tallest = 620;        ///< of a row of maps
constexpr double tallest_of_all = 800; ///< of all rows of maps together
constexpr double line_height = 24;
constexpr double inside = width - 2 * margin;
constexpr double font = 14;

double
aspectOf(const Panel& map)
{
  const Eigen::Vector2d size = map.view().sizes();
  return std::clamp(size.x() / size.y(), 0.05, 20.0);
}

/** @brief Returns the height of the maps of a row of panels. */
double
heightOf(const std::vector<Panel>& row, double most)
{
  double aspects = 0;
  double room = inside - gap * static_cast<double>(row.size() - 1);
  for (const Panel& panel : row)
    (panel.isChart() ? room : aspects) +=
        panel.isChart() ? -chart_width : aspectOf(panel);
  return aspects > 0 ? std::min({most, tallest, std::max(room, 100.0) / aspects}) : 0;
}

/** @brief Adds a text, made smaller to be at most `most` pixels wide. */
void
addText(Sheet& sheet,
        const std::string& text,
        double x,
        double y,
        double size = font,
        TextAnchor anchor = TextAnchor::Start,
        double most = inside)
{
  SheetText t{colours::ink.number(), {x, y}, size, text};
  t.anchor = anchor;
  t.is_bold = size > font;
  t.font = std::min(size, most / textWidth(text, t.is_bold));
  sheet.add(t);
}

/** @brief Draws a scale bar of a round length below the left corner of a map. */
void
drawScaleBar(Sheet& sheet, const Panel& map, const Box& box)
{
  constexpr double longest = 160;
  const double per_metre = box.sizes().x() / map.view().sizes().x();
  const double length = roundStep(std::min(longest, 0.4 * box.sizes().x()) / per_metre);
  const Eigen::Vector2d start(box.min().x(), box.min().y() - bar_height / 2);
  const Eigen::Vector2d end = start + Eigen::Vector2d(length * per_metre, 0);
  const Eigen::Vector2d up(0, 5);
  const SheetLook line{no_colour, colours::ink.number(), 2};
  for (const auto& [a, b] : {std::pair(start, end),
                             {Eigen::Vector2d(start - up), Eigen::Vector2d(start + up)},
                             {Eigen::Vector2d(end - up), Eigen::Vector2d(end + up)}})
    sheet.addLine(line, {a, b});
  addText(sheet, lengthText(length), end.x() + 8, end.y());
}

/** @brief Draws numbers along one axis of a chart, with grid lines. */
void
drawTicks(Sheet& sheet, const Panel& chart, const Box& box, int axis)
{
  const Box view = chart.view();
  const double range = view.sizes()[axis];
  const double pixels = box.sizes()[axis];
  const double step = roundStep(range * (axis == 0 ? 90 : 45) / pixels);
  for (double k = std::ceil(view.min()[axis] / step - 1e-9);
       k * step <= view.max()[axis] + 1e-9 * step; ++k) {
    Eigen::Vector2d from = box.min();
    from[axis] += (k * step - view.min()[axis]) / range * pixels;
    Eigen::Vector2d to = from;
    to[1 - axis] = box.max()[1 - axis];
    sheet.addLine({no_colour, lightened(colours::faint, 0.5).number(), 1}, {from, to});
    const std::string number = fixedText(k * step, digitsOf(step));
    if (axis == 0)
      addText(sheet, number, from.x(), from.y() - 12, font, TextAnchor::Middle);
    else
      addText(sheet, number, from.x() - 6, from.y(), font, TextAnchor::End);
  }
}

} // namespace

void
Picture::addRow(std::vector<Panel> panels)
{
  if (!panels.empty())
    rows_.push_back(std::move(panels));
}

void
Picture::addMaps(const std::vector<Panel>& panels)
{
  const auto n = static_cast<std::ptrdiff_t>(panels.size());
  const auto begin = panels.begin();
  std::ptrdiff_t best_columns = n;
  double best_height = 0;
  for (std::ptrdiff_t columns = n; columns >= 1; --columns) {
    const std::ptrdiff_t rows = (n + columns - 1) / columns;
    const double height =
        heightOf({begin, begin + columns}, tallest_of_all / static_cast<double>(rows));
    // More rows are used only if maps become much larger, as adjacent panels compare
    // better.
    const double worth = n % columns == 0 ? 1.5 : 2;
    if (height > worth * best_height) {
      best_height = height;
      best_columns = columns;
    }
  }
  for (std::ptrdiff_t first = 0; first < n; first += best_columns)
    addRow({begin + first, begin + std::min(n, first + best_columns)});
}

void
Picture::addLegend(const std::string& meaning, Colour colour)
{
  legend_.push_back({meaning, colour});
}

double
Picture::drawRow(Sheet& sheet, const std::vector<Panel>& row, double top) const
{
  const auto rows_of_maps =
      std::count_if(rows_.begin(), rows_.end(), [](const std::vector<Panel>& panels) {
        return !std::all_of(panels.begin(), panels.end(),
                            [](const Panel& panel) { return panel.isChart(); });
      });
  const double height =
      heightOf(row, tallest_of_all /
                        static_cast<double>(std::max<std::ptrdiff_t>(1, rows_of_maps)));
  double charts = 0;
  double room = inside - gap * static_cast<double>(row.size() - 1);
  for (const Panel& panel : row)
    panel.isChart() ? ++charts : room -= aspectOf(panel) * height;
  double left = margin;
  double bottom = top;
  for (const Panel& panel : row) {
    const double across = panel.isChart() ? room / charts : aspectOf(panel) * height;
    const double high = top - panel_title_height;
    const double tall = panel.isChart() ? std::max(chart_height, height) : height;
    const Box box(
        Eigen::Vector2d(left + (panel.isChart() ? axis_width : 0), high - tall),
        Eigen::Vector2d(left + across, high));
    addText(sheet, panel.title, left, high + panel_title_height / 2, 15,
            TextAnchor::Start, across + gap - 6);
    for (int axis = 0; axis < 2 && panel.isChart(); ++axis)
      drawTicks(sheet, panel, box, axis);
    panel.draw(sheet, box);
    sheet.addBox({no_colour, colours::faint.number(), 1}, box);
    if (panel.isChart())
      addText(sheet, panel.xAxis(), box.max().x(), box.min().y() - 32, font,
              TextAnchor::End);
    else
      drawScaleBar(sheet, panel, box);
    bottom =
        std::min(bottom, box.min().y() - (panel.isChart() ? axis_height : bar_height));
    left += across + gap;
  }
  sheet.size.x() =
      std::min(width, std::max(sheet.size.x(), std::ceil(left - gap + margin)));
  return bottom - 6;
}

double
Picture::drawLegend(Sheet& sheet, double top) const
{
  double x = margin;
  double y = top - line_height / 2;
  for (const Meaning& meaning : legend_) {
    const double across = 22 + font * textWidth(meaning.text) + 24;
    if (x > margin && x + across > sheet.size.x() - margin) {
      x = margin;
      y -= line_height;
    }
    sheet.addBox({meaning.colour.number()},
                 {Eigen::Vector2d(x, y - 7), Eigen::Vector2d(x + 14, y + 7)});
    addText(sheet, meaning.text, x + 22, y);
    x += across;
  }
  y -= legend_.empty() ? 0 : line_height;
  for (const std::string& note : notes_) {
    addText(sheet, note, margin, y);
    y -= line_height;
  }
  return y + line_height / 2;
}

Sheet
Picture::draw() const
{
  // Drawn downwards from the top at y = 0; its height is known then.
  Sheet sheet;
  sheet.title = title_;
  constexpr double title_font = 19;
  addText(sheet, title_, margin, -title_height / 2 - 2, title_font);
  double widest = std::max(narrowest, title_font * textWidth(title_, true));
  for (const std::string& note : notes_)
    widest = std::max(widest, font * textWidth(note));
  sheet.size.x() = std::min(width, std::ceil(widest + 2 * margin));
  double bottom = -title_height;
  for (const std::vector<Panel>& row : rows_)
    bottom = drawRow(sheet, row, bottom);
  bottom = drawLegend(sheet, bottom) - margin / 2;
  sheet.size.y() = std::ceil(-bottom);
  sheet.bottom = -sheet.size.y();
  return sheet;
}

} // namespace pcl::sedr::tools
