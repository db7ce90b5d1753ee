// SPDX-License-Identifier: BSD-3-Clause
#include "picture.h"

#include "scale.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr::tools {

namespace {

// Pixels.
constexpr double widest = 1200;
constexpr double narrowest = 560;
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
constexpr double inside = widest - 2 * margin;

double
aspectOf(const Panel& map)
{
  const Eigen::Vector2d size = map.view().size();
  return std::clamp(size.x() / size.y(), 0.05, 20.0);
}

bool
hasMap(const std::vector<Panel>& row)
{
  return std::any_of(row.begin(), row.end(),
                     [](const Panel& panel) { return !panel.isChart(); });
}

Text
textAt(const std::string& line, double x, double y, int size)
{
  Text text;
  text.line = line;
  text.x = x;
  text.y = y;
  text.size = size;
  return text;
}

/** @brief Adds a text, shrunk to at most `most` pixels. */
void
addFitted(Text text, double most, Canvas& canvas)
{
  while (text.size > 10 && widthOf(text) > most)
    --text.size;
  canvas.addText(text);
}

void
drawFrame(const Box& box, Canvas& canvas)
{
  canvas.setClip({{0, 0}, {widest, 1e9}});
  const Eigen::Vector2d a = box.low.array() - 0.5;
  const Eigen::Vector2d c = box.high.array() + 0.5;
  const Eigen::Vector2d b(c.x(), a.y());
  const Eigen::Vector2d d(a.x(), c.y());
  const std::array<Eigen::Vector2d, 4> corners{a, b, c, d};
  for (std::size_t i = 0; i < 4; ++i)
    canvas.drawLine(corners[i], corners[(i + 1) % 4], 1, colours::faint);
}

/** @brief Draws a scale bar of a round length below the left corner of a map. */
void
drawScaleBar(const Panel& map, const Box& box, Canvas& canvas)
{
  const double pixels_a_metre = box.size().x() / map.view().size().x();
  const double length =
      roundStep(std::min(160.0, 0.4 * box.size().x()) / pixels_a_metre);
  const double y = box.high.y() + bar_height / 2;
  const Eigen::Vector2d start(box.low.x(), y);
  const Eigen::Vector2d end = start + Eigen::Vector2d(length * pixels_a_metre, 0);
  canvas.setClip({{0, 0}, {widest, 1e9}});
  canvas.fillBox({{start.x(), y - 1.5}, {end.x(), y + 1.5}}, colours::ink);
  for (const auto& p : {start, end})
    canvas.fillBox({{p.x() - 0.75, y - 5}, {p.x() + 0.75, y + 5}}, colours::ink);
  canvas.addText(textAt(lengthText(length), end.x() + 8, y, 13));
}

/** @brief Draws numbers along one axis of a chart, with grid lines. */
void
drawTicks(const Panel& chart, const Box& box, int axis, Canvas& canvas)
{
  const Box view = chart.view();
  const double range = view.size()[axis];
  const double pixels = box.size()[axis];
  const double step = roundStep(range * (axis == 0 ? 90 : 45) / pixels);
  const int digits = digitsOf(step);
  canvas.setClip(box);
  for (double k = std::ceil(view.low[axis] / step - 1e-9);
       k * step <= view.high[axis] + 1e-9 * step; ++k) {
    const double share = (k * step - view.low[axis]) / range;
    Box line = box;
    line.low[axis] = axis == 0 ? box.low.x() + share * pixels - 0.5
                               : box.high.y() - share * pixels - 0.5;
    line.high[axis] = line.low[axis] + 1;
    canvas.fillBox(line, lightened(colours::faint, 0.5));
    Text number =
        textAt(fixedText(k * step, digits), line.low.x() + 0.5, box.high.y() + 12, 13);
    number.anchor = Anchor::Middle;
    if (axis == 1) {
      number.x = box.low.x() - 6;
      number.y = line.low.y() + 0.5;
      number.anchor = Anchor::Right;
    }
    canvas.addText(number);
  }
}

void
drawAxes(const Panel& chart, const Box& box, Canvas& canvas)
{
  drawTicks(chart, box, 0, canvas);
  drawTicks(chart, box, 1, canvas);
  Text words = textAt(chart.xAxis(), box.high.x(), box.high.y() + 32, 13);
  words.anchor = Anchor::Right;
  canvas.addText(words);
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
  const std::size_t n = panels.size();
  if (n == 0)
    return;
  std::size_t best_columns = n;
  double best_height = 0;
  for (std::size_t columns = n; columns >= 1; --columns) {
    const std::size_t rows = (n + columns - 1) / columns;
    const std::vector<Panel> row(panels.begin(),
                                 panels.begin() + static_cast<std::ptrdiff_t>(columns));
    const double height = heightOfMaps(row, tallest_of_all / static_cast<double>(rows));
    // More rows are used only if maps become much larger, as adjacent panels compare
    // better.
    const double worth = n % columns == 0 ? 1.5 : 2;
    if (height > worth * best_height) {
      best_height = height;
      best_columns = columns;
    }
  }
  for (std::size_t first = 0; first < n; first += best_columns)
    addRow({panels.begin() + static_cast<std::ptrdiff_t>(first),
            panels.begin() +
                static_cast<std::ptrdiff_t>(std::min(n, first + best_columns))});
}

void
Picture::addLegend(const std::string& meaning, Colour colour)
{
  legend_.push_back({meaning, colour});
}

double
Picture::heightOfMaps(const std::vector<Panel>& panels, double most)
{
  double aspects = 0;
  double room = inside - gap * static_cast<double>(panels.size() - 1);
  for (const auto& panel : panels) {
    if (panel.isChart())
      room -= chart_width;
    else
      aspects += aspectOf(panel);
  }
  return aspects > 0 ? std::min({most, tallest, std::max(room, 100.0) / aspects}) : 0;
}

double
Picture::place(Row& row, double top) const
{
  const auto rows_of_maps = std::count_if(rows_.begin(), rows_.end(), hasMap);
  const double most =
      tallest_of_all / static_cast<double>(std::max<std::ptrdiff_t>(1, rows_of_maps));
  const double height = heightOfMaps(row.panels, most);
  double charts = 0;
  double room = inside - gap * static_cast<double>(row.panels.size() - 1);
  for (const auto& panel : row.panels) {
    charts += panel.isChart() ? 1 : 0;
    room -= panel.isChart() ? 0 : aspectOf(panel) * height;
  }
  double left = margin;
  double bottom = top;
  for (const auto& panel : row.panels) {
    const double across = panel.isChart() ? room / charts : aspectOf(panel) * height;
    Box box{{left, top + panel_title_height}, {left + across, 0}};
    box.low.x() += panel.isChart() ? axis_width : 0;
    box.high.y() =
        box.low.y() + (panel.isChart() ? std::max(chart_height, height) : height);
    bottom =
        std::max(bottom, box.high.y() + (panel.isChart() ? axis_height : bar_height));
    row.boxes.push_back(box);
    left += across + gap;
  }
  return bottom + 6;
}

double
Picture::drawLegend(Canvas& canvas, double top, double width) const
{
  double x = margin;
  double y = top + line_height / 2;
  canvas.setClip({{0, 0}, {widest, 1e9}});
  for (const auto& meaning : legend_) {
    Text text = textAt(meaning.text, 0, 0, 14);
    const double across = 22 + widthOf(text) + 24;
    if (x > margin && x + across > width - margin) {
      x = margin;
      y += line_height;
    }
    canvas.fillBox({{x, y - 7}, {x + 14, y + 7}}, meaning.colour);
    text.x = x + 22;
    text.y = y;
    canvas.addText(text);
    x += across;
  }
  if (!legend_.empty())
    y += line_height;
  for (const auto& note : notes_) {
    addFitted(textAt(note, margin, y, 14), width - 2 * margin, canvas);
    y += line_height;
  }
  return y - line_height / 2;
}

Image
Picture::draw() const
{
  Text title = textAt(title_, margin, title_height / 2 + 2, 19);
  title.is_bold = true;
  double width = std::max(narrowest, widthOf(title) + 2 * margin);
  double bottom = title_height;
  std::vector<Row> rows;
  for (const auto& panels : rows_) {
    rows.push_back({panels, {}});
    bottom = place(rows.back(), bottom);
    width = std::max(width, rows.back().boxes.back().high.x() + margin);
  }
  for (const auto& note : notes_)
    width = std::max(width, widthOf(textAt(note, 0, 0, 14)) + 2 * margin);
  width = std::min(widest, std::ceil(width));
  Canvas measure(static_cast<int>(width), 1);
  const double height = drawLegend(measure, bottom, width) + margin / 2;

  Canvas canvas(static_cast<int>(width), static_cast<int>(std::ceil(height)));
  addFitted(title, width - 2 * margin, canvas);
  for (const auto& row : rows)
    for (std::size_t i = 0; i < row.panels.size(); ++i) {
      const Panel& panel = row.panels[i];
      const Box& box = row.boxes[i];
      addFitted(textAt(panel.title, box.low.x() - (panel.isChart() ? axis_width : 0),
                       box.low.y() - panel_title_height / 2, 15),
                box.size().x() + (panel.isChart() ? axis_width : 0) + gap - 6, canvas);
      if (panel.isChart())
        drawAxes(panel, box, canvas);
      panel.draw(canvas, box);
      drawFrame(box, canvas);
      if (!panel.isChart())
        drawScaleBar(panel, box, canvas);
    }
  drawLegend(canvas, bottom, width);
  return canvas.image();
}

} // namespace pcl::sedr::tools
