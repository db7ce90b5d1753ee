// SPDX-License-Identifier: BSD-3-Clause
#include "picture.h"

#include "sedr_filters/src/base/number_text.h"
#include "sedr_filters/src/plan/plan_bounds.h"
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
constexpr double tallest = 800;     ///< of all maps,
constexpr double tallest_row = 300; ///< or more for so many rows
constexpr double line_height = 24;
constexpr double inside = width - 2 * margin;
constexpr double font = 14;

/** @brief Adds a text, made smaller to be at most `most` pixels wide. */
void
addText(Sheet& sheet,
        const std::string& text,
        const Eigen::Vector2d& at,
        double size = font,
        double most = inside)
{
  SheetText t{colours::ink, at, size, text};
  t.anchor = TextAnchor::Start;
  t.is_bold = size > font;
  t.font = std::min(size, most / textWidth(text, t.is_bold));
  sheet.add(t);
}

/** @brief Draws a scale bar of 1, 2 or 5 times a power of ten; returns its right end.
 */
double
drawScaleBar(Sheet& sheet, double scale, const Eigen::Vector2d& start)
{
  constexpr double longest = 160;
  const double most = longest / scale;
  double length = std::pow(10, std::floor(std::log10(most)));
  length *= 5 * length <= most ? 5 : 2 * length <= most ? 2 : 1;
  const Eigen::Vector2d end = start + Eigen::Vector2d(length * scale, 0);
  const Eigen::Vector2d up(0, 5);
  const SheetLook line{no_colour, colours::ink, 2};
  for (const auto& [from, to] :
       {std::pair<Eigen::Vector2d, Eigen::Vector2d>(start, end),
        {start - up, start + up},
        {end - up, end + up}})
    sheet.addLine(line, {from, to});
  const std::string text = length < 0.999 ? shortDecimalText(100 * length, 3) + " cm"
                                          : shortDecimalText(length, 0) + " m";
  addText(sheet, text, {end.x() + 8, end.y()});
  return end.x() + 8 + font * textWidth(text);
}

/** @brief Returns a box grown by a share of its size, and `least` metres at least. */
Box
grown(const Box& box, double share, double least)
{
  if (box.isEmpty())
    return box;
  const Eigen::Vector2d around =
      Eigen::Vector2d::Constant(std::max(share * box.sizes().maxCoeff(), least));
  return {box.min() - around, box.max() + around};
}

} // namespace

Panel::Panel(std::string title, const Box& view)
    : title_(std::move(title))
    , view_(view.isEmpty() || (view.sizes().array() <= 0).any()
                ? Box(Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 1))
                : view)
{}

void
Panel::addBoxes(std::vector<Box> boxes, Colour colour)
{
  shapes_.emplace_back(SheetBoxes{colour, std::move(boxes)});
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
Panel::addLines(std::vector<PlanLoop> lines, Colour colour, double pixels)
{
  shapes_.emplace_back(SheetPath{{no_colour, colour, pixels}, std::move(lines)});
}

void
Panel::addPlan(const Floorplan& plan, double pixels, Colour all)
{
  const auto add = [&](std::vector<PlanLoop> loops, Colour meaning) {
    addLines(std::move(loops), all == no_colour ? meaning : all, pixels);
  };
  for (const PlanRoom& room : plan.rooms) {
    for (const auto& [details, colour] :
         {std::pair(&room.floor_details, colours::floor),
          std::pair(&room.details, colours::detail)})
      for (const PlanDetail& detail : *details) {
        add({detail.boundary}, colour);
        add(detail.holes, colour);
      }
    for (const PlanNiche& niche : room.niches)
      add({niche.boundary}, colours::wall);
    add(room.columns, colours::column);
    std::vector<PlanLoop> elements[2]; // segments and arcs
    for (const PlanElement& e : room.boundary.elements)
      elements[e.isArc() ? 1 : 0].push_back({{e}});
    add(elements[0], colours::ink);
    add(elements[1], colours::arc);
  }
}

void
Panel::draw(const Eigen::Vector2d& corner, double scale, Sheet& sheet) const
{
  const Box box(corner, corner + scale * view_.sizes());
  sheet.add(SheetView{box, view_});
  sheet.items.insert(sheet.items.end(), shapes_.begin(), shapes_.end());
  sheet.add(SheetView{});
  sheet.addBox({no_colour, colours::faint, 1}, box);
  TextPlaces places;
  for (const auto& [place, text] : labels_) {
    constexpr double edge = 3; // pixels to the frame
    SheetText label{colours::ink, corner + scale * (place - view_.min()), font, text};
    label.ground = paper_colour;
    label.is_bold = true;
    const Eigen::Vector2d half = font * halfSizeOf({text});
    const Eigen::Vector2d in = half + Eigen::Vector2d::Constant(edge);
    label.place = label.place.cwiseMin(box.max() - in).cwiseMax(box.min() + in);
    if (view_.contains(place) && places.takeFirst({{label.place, half, 0}}))
      sheet.add(label);
  }
}

double
Picture::scale() const
{
  Eigen::Vector2d largest(0, 0); // view of a map, metres
  std::size_t most = 1;          // maps in a row
  for (const std::vector<Panel>& row : rows_) {
    most = std::max(most, row.size());
    for (const Panel& map : row)
      largest = largest.cwiseMax(map.view().sizes());
  }
  const double all =
      std::max(tallest, tallest_row * static_cast<double>(rows_.size())); // pixels
  double best = 0;
  for (std::size_t columns = most; columns >= 1; --columns) {
    double lines = 0;
    for (const std::vector<Panel>& row : rows_)
      lines += static_cast<double>((row.size() + columns - 1) / columns);
    const double scale =
        std::min(((inside + gap) / static_cast<double>(columns) - gap) / largest.x(),
                 all / lines / largest.y());
    // Adjacent maps compare better: more lines only if maps become much larger.
    if (scale > 1.5 * best)
      best = scale;
  }
  return best;
}

Sheet
Picture::draw() const
{
  // Drawn downwards from the top at y = 0; its height is known then.
  Sheet sheet;
  sheet.title = title_;
  constexpr double title_font = 19;
  addText(sheet, title_, {margin, -title_height / 2 - 2}, title_font);
  sheet.size.x() = std::max(narrowest, title_font * textWidth(title_, true));
  double y = drawMaps(sheet) - line_height;
  sheet.size.x() = std::min(width, std::ceil(sheet.size.x() + 2 * margin));
  double x = rows_.empty() ? margin : drawScaleBar(sheet, scale(), {margin, y}) + gap;
  for (const auto& [meaning, colour] : legend_) {
    const double across = 22 + font * textWidth(meaning) + gap;
    if (x > margin && x + across > sheet.size.x() - margin) {
      x = margin;
      y -= line_height;
    }
    sheet.addBox({colour}, {Eigen::Vector2d(x, y - 7), Eigen::Vector2d(x + 14, y + 7)});
    addText(sheet, meaning, {x + 22, y});
    x += across;
  }
  sheet.size.y() = std::ceil(line_height - y);
  sheet.bottom = -sheet.size.y();
  return sheet;
}

double
Picture::drawMaps(Sheet& sheet) const
{
  const double scale = this->scale();
  double y = -title_height;
  for (const std::vector<Panel>& row : rows_) {
    double x = margin;
    double height = 0; // of a line of maps
    for (const Panel& map : row) {
      const Eigen::Vector2d size = scale * map.view().sizes();
      if (x > margin && x + size.x() > width - margin + 0.5) {
        y -= panel_title_height + height + 8;
        x = margin;
        height = 0;
      }
      addText(sheet, map.title(), {x, y - panel_title_height / 2}, 15,
              size.x() + gap - 6);
      map.draw({x, y - panel_title_height - size.y()}, scale, sheet);
      height = std::max(height, size.y());
      x += size.x() + gap;
      sheet.size.x() = std::max(sheet.size.x(), x - gap - margin);
    }
    y -= panel_title_height + height + 8;
  }
  return y;
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
  return grown(view, 0.02, 2 * cell_size);
}

Box
viewOf(const std::vector<const Floorplan*>& plans)
{
  Box view;
  for (const Floorplan* plan : plans)
    for (const PlanRoom& room : plan->rooms)
      view.extend(boundsOf(room.boundary));
  return grown(view, 0.02, 0.4);
}

} // namespace pcl::sedr::tools
