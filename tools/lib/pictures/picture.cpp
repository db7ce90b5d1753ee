// SPDX-License-Identifier: BSD-3-Clause
#include "picture.h"

#include "sedr_filters/src/base/number_text.h"
#include "sedr_filters/src/plan/plan_segment.h"
#include "sedr_surface/src/sheet/text_places.h"

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
constexpr double bar_height = 26; ///< below a map, for its scale bar
constexpr double tallest = 620;   ///< of a row of maps
constexpr double tallest_of_all = 800;
constexpr double line_height = 24;
constexpr double inside = width - 2 * margin;
constexpr double font = 14;

/** @brief Maps metres to the sheet, in place. */
struct Frame {
  Box box;
  Box view;

  Eigen::Vector2d scale() const { return box.sizes().cwiseQuotient(view.sizes()); }
  Eigen::Vector2d operator()(const Eigen::Vector2d& place) const
  {
    return box.min() + (place - view.min()).cwiseProduct(scale());
  }

  void place(SheetPath& path) const
  {
    for (PlanLoop& chain : path.chains)
      for (PlanElement& e : chain.elements) {
        e.radius *= scale().x();
        for (Eigen::Vector2d* p : {&e.start, &e.end, &e.centre})
          *p = (*this)(*p);
      }
  }

  void place(SheetBoxes& boxes) const
  {
    constexpr double thinnest = 1; // pixels
    std::vector<Box> drawn;
    for (const Box& one : boxes.boxes)
      if (view.intersects(one)) {
        const Eigen::Vector2d low = (*this)(one.min());
        drawn.emplace_back(low, low + ((*this)(one.max()) - low).cwiseMax(thinnest));
      }
    boxes.boxes = std::move(drawn);
  }

  /** @brief Moves texts near the edge inside. */
  void place(SheetText& text) const
  {
    constexpr double edge = 3; // pixels to the frame
    text.place = (*this)(text.place);
    const double half = text.font * textWidth(text.text, true) / 2 + edge;
    text.place.x() =
        std::max(box.min().x() + half, std::min(text.place.x(), box.max().x() - half));
  }

  template <typename OtherT>
  void place(OtherT&) const
  {}
};

double
aspectOf(const Panel& map)
{
  const Eigen::Vector2d size = map.view().sizes();
  return std::clamp(size.x() / size.y(), 0.05, 20.0);
}

/** @brief Returns the height of a row of maps. */
double
heightOf(const std::vector<Panel>& row, double most)
{
  double aspects = 0;
  for (const Panel& panel : row)
    aspects += aspectOf(panel);
  const double room = inside - gap * static_cast<double>(row.size() - 1);
  return std::min({most, tallest, std::max(room, 100.0) / aspects});
}

/** @brief Adds a text, made smaller to be at most `most` pixels wide. */
void
addText(Sheet& sheet,
        const std::string& text,
        const Eigen::Vector2d& at,
        double size = font,
        double most = inside)
{
  SheetText t{colours::ink.number(), at, size, text};
  t.anchor = TextAnchor::Start;
  t.is_bold = size > font;
  t.font = std::min(size, most / textWidth(text, t.is_bold));
  sheet.add(t);
}

/** @brief Draws a scale bar of 1, 2 or 5 times a power of ten below a map. */
void
drawScaleBar(Sheet& sheet, const Panel& map, const Box& box)
{
  constexpr double longest = 160;
  const double per_metre = box.sizes().x() / map.view().sizes().x();
  const double most = std::min(longest, 0.4 * box.sizes().x()) / per_metre;
  double length = std::pow(10, std::floor(std::log10(most)));
  length *= 5 * length <= most ? 5 : 2 * length <= most ? 2 : 1;
  const Eigen::Vector2d start(box.min().x(), box.min().y() - bar_height / 2);
  const Eigen::Vector2d end = start + Eigen::Vector2d(length * per_metre, 0);
  const Eigen::Vector2d up(0, 5);
  const SheetLook line{no_colour, colours::ink.number(), 2};
  sheet.addLine(line, {start, end});
  for (const Eigen::Vector2d& tip : {start, end})
    sheet.addLine(line, {tip - up, tip + up});
  addText(sheet,
          length < 0.999 ? shortDecimalText(100 * length, 3) + " cm"
                         : shortDecimalText(length, 0) + " m",
          {end.x() + 8, end.y()});
}

/** @brief Draws a row of maps below `top`; returns its bottom. */
double
drawRow(Sheet& sheet, const std::vector<Panel>& row, double top, double most)
{
  const double height = heightOf(row, most);
  double left = margin;
  const double high = top - panel_title_height;
  for (const Panel& panel : row) {
    const double across = aspectOf(panel) * height;
    const Box box(Eigen::Vector2d(left, high - height),
                  Eigen::Vector2d(left + across, high));
    addText(sheet, panel.title, {left, high + panel_title_height / 2}, 15,
            across + gap - 6);
    panel.draw(sheet, box);
    sheet.addBox({no_colour, colours::faint.number(), 1}, box);
    drawScaleBar(sheet, panel, box);
    left += across + gap;
  }
  sheet.size.x() =
      std::min(width, std::max(sheet.size.x(), std::ceil(left - gap + margin)));
  return high - height - bar_height - 6;
}

} // namespace

void
Panel::add(Sheet::Item item, const Places& extent)
{
  for (const Eigen::Vector2d& p : extent)
    bounds_.extend(p);
  items_.push_back(std::move(item));
}

void
Panel::addBoxes(std::vector<Box> boxes, Colour colour)
{
  for (const Box& box : boxes)
    bounds_.extend(box);
  add(SheetBoxes{colour.number(), std::move(boxes)}, {});
}

void
Panel::addCells(const CellSet& cells, double cell_size, Colour colour)
{
  // Keys run row by row, so that neighbours in a row become one box.
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Eigen::Vector2d low(cells[i].x, cells[i].y);
    if (i == 0 || cells.keys()[i] != cells.keys()[i - 1] + 1)
      boxes.emplace_back(Eigen::Vector2d(cell_size * low));
    boxes.back().extend(Eigen::Vector2d(cell_size * (low + Eigen::Vector2d::Ones())));
  }
  addBoxes(std::move(boxes), colour);
}

void
Panel::addPoints(const Places& points, Colour colour, double size)
{
  const Eigen::Vector2d half = Eigen::Vector2d::Constant(size / 2);
  std::vector<Box> boxes;
  for (const Eigen::Vector2d& p : points)
    boxes.emplace_back(p - half, p + half);
  addBoxes(std::move(boxes), colour);
}

void
Panel::addPath(const Places& points, Colour colour, double pixels)
{
  SheetPath path;
  path.look.stroke = colour.number();
  path.look.width = pixels;
  path.chains.emplace_back();
  for (std::size_t k = 1; k < points.size(); ++k)
    path.chains.back().elements.push_back(segment(points[k - 1], points[k]));
  add(std::move(path), points);
}

void
Panel::addLoop(const PlanLoop& loop, Colour segments, Colour arcs, double pixels)
{
  SheetPath straight{{no_colour, segments.number(), pixels}, {}};
  SheetPath bent{{no_colour, arcs.number(), pixels}, {}};
  for (const PlanElement& e : loop.elements)
    (e.isArc() ? bent : straight).chains.push_back({{e}});
  add(std::move(straight), loop.polygon(0.01));
  add(std::move(bent), {});
}

void
Panel::addLabel(const Eigen::Vector2d& place, const std::string& text)
{
  SheetText label{colours::ink.number(), place, font, text};
  label.ground = paper_colour;
  label.is_bold = true;
  items_.emplace_back(label);
}

Box
Panel::view() const
{
  if (!view_.isEmpty() && (view_.sizes().array() > 0).all())
    return view_;
  Box box = bounds_;
  if (box.isEmpty())
    box.extend(Eigen::Vector2d(0, 0));
  return grown(box, std::max(0.02 * box.sizes().maxCoeff(), 0.05));
}

void
Panel::draw(Sheet& sheet, const Box& box) const
{
  const Frame frame{box, view()};
  sheet.add(SheetClip{box});
  std::vector<SheetText> texts;
  for (Sheet::Item item : items_) {
    const auto* text = std::get_if<SheetText>(&item);
    const bool is_seen = !text || frame.view.contains(text->place);
    std::visit([&](auto& placed) { frame.place(placed); }, item);
    if (!text)
      sheet.add(std::move(item));
    else if (is_seen)
      texts.push_back(*text);
  }
  TextPlaces places;
  for (const SheetText& text : texts) { // on top of all
    const Eigen::Vector2d half(textWidth(text.text, true) / 2 + 0.15, 0.6);
    if (places.takeFirst({{text.place, text.font * half, 0}}))
      sheet.add(text);
  }
  sheet.add(SheetClip{});
}

void
Picture::addMaps(std::vector<Panel> panels, const Box& view)
{
  if (!view.isEmpty())
    for (Panel& panel : panels)
      panel.setView(view);
  const auto n = static_cast<std::ptrdiff_t>(panels.size());
  const auto begin = panels.begin();
  std::ptrdiff_t best_columns = n;
  double best_height = 0;
  for (std::ptrdiff_t columns = n; columns >= 1; --columns) {
    const std::ptrdiff_t rows = (n + columns - 1) / columns;
    const double height =
        heightOf({begin, begin + columns}, tallest_of_all / static_cast<double>(rows));
    // More rows only if maps become much larger, as adjacent maps compare better.
    if (height > (n % columns == 0 ? 1.5 : 2) * best_height) {
      best_height = height;
      best_columns = columns;
    }
  }
  for (std::ptrdiff_t first = 0; first < n; first += best_columns)
    rows_.emplace_back(begin + first, begin + std::min(n, first + best_columns));
}

Sheet
Picture::draw() const
{
  // Drawn downwards from the top at y = 0; its height is known then.
  Sheet sheet;
  sheet.title = title_;
  constexpr double title_font = 19;
  addText(sheet, title_, {margin, -title_height / 2 - 2}, title_font);
  const double widest = std::max(narrowest, title_font * textWidth(title_, true));
  sheet.size.x() = std::min(width, std::ceil(widest + 2 * margin));
  double y = -title_height;
  for (const std::vector<Panel>& row : rows_)
    y = drawRow(sheet, row, y, tallest_of_all / static_cast<double>(rows_.size()));
  double x = margin;
  y -= line_height / 2;
  for (const auto& [meaning, colour] : legend_) {
    const double across = 22 + font * textWidth(meaning) + 24;
    if (x > margin && x + across > sheet.size.x() - margin) {
      x = margin;
      y -= line_height;
    }
    sheet.addBox({colour.number()},
                 {Eigen::Vector2d(x, y - 7), Eigen::Vector2d(x + 14, y + 7)});
    addText(sheet, meaning, {x + 22, y});
    x += across;
  }
  y -= legend_.empty() ? 0 : line_height;
  sheet.size.y() = std::ceil(margin / 2 - y - line_height / 2);
  sheet.bottom = -sheet.size.y();
  return sheet;
}

Box
grown(const Box& box, double by)
{
  if (box.isEmpty())
    return box;
  const Eigen::Vector2d around = Eigen::Vector2d::Constant(by);
  return {box.min() - around, box.max() + around};
}

Box
viewOf(const CellSet& cells, double cell_size)
{
  Box view;
  for (int axis = 0; axis < 2 && !cells.empty(); ++axis) {
    std::vector<double> places;
    for (std::size_t i = 0; i < cells.size(); ++i)
      places.push_back(cell_size * (axis == 0 ? cells[i].x : cells[i].y));
    std::sort(places.begin(), places.end());
    const std::size_t off = places.size() / 100;
    double low = places[off];
    double high = places[places.size() - 1 - off];
    if (2 * (high - low) >= places.back() - places.front()) {
      low = places.front();
      high = places.back();
    }
    view.min()[axis] = low;
    view.max()[axis] = high + cell_size;
  }
  return view.isEmpty()
             ? view
             : grown(view, std::max(0.02 * view.sizes().maxCoeff(), 2 * cell_size));
}

} // namespace pcl::sedr::tools
