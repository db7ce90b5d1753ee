// SPDX-License-Identifier: BSD-3-Clause
#include "picture.h"
#include "colour.h"
#include "sedr_filters/src/base/number_text.h"
#include "sedr_filters/src/plan/plan_geometry.h"
#include "sedr_surface/src/sheet/text_places.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl::sedr::tools {
namespace {

// Pixels.
constexpr double margin = 16;
constexpr double gap = 24;
constexpr double inside = 1200 - 2 * margin;
constexpr double title_height = 40;
constexpr double panel_title_height = 28;
constexpr double line_height = 24;
constexpr double font = 14;

/** @brief Places boxes from left to right and, where the sheet ends, in a new line. */
struct Flow {
  double right = margin + inside;
  Eigen::Vector2d next{margin, -title_height}; ///< upper left corner
  double line = 0;                             ///< height of the line
  double end = 0;                              ///< of the widest line

  Eigen::Vector2d place(const Eigen::Vector2d& size)
  {
    if (next.x() > margin && next.x() + size.x() > right + 0.5)
      endLine();
    const Eigen::Vector2d at = next;
    next.x() += size.x() + gap;
    line = std::max(line, size.y());
    end = std::max(end, at.x() + size.x());
    return at;
  }
  void endLine()
  {
    next = {margin, next.y() - line};
    line = 0;
  }
};

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

/** @brief Adds an entry of the legend: a box of a colour, and what it means. */
void
addEntry(Sheet& sheet,
         Flow& flow,
         const Eigen::Vector2d& size,
         Colour colour,
         const std::string& text)
{
  const Eigen::Vector2d text_start(size.x() + 8, 0);
  const Eigen::Vector2d at =
      flow.place({text_start.x() + font * textWidth(text), line_height}) -
      Eigen::Vector2d(0, line_height / 2);
  const Eigen::Vector2d low = at - Eigen::Vector2d(0, size.y() / 2);
  sheet.addBox({colour}, {low, low + size});
  addText(sheet, text, at + text_start);
}

/** @brief Adds a scale bar of 1, 2 or 5 times a power of ten. */
void
addScaleBar(Sheet& sheet, Flow& flow, double scale)
{
  const double most = 160 / scale;
  double length = std::pow(10, std::floor(std::log10(most)));
  length *= 5 * length <= most ? 5 : 2 * length <= most ? 2 : 1;
  addEntry(sheet, flow, {length * scale, 4}, colours::ink,
           length < 0.999 ? shortDecimalText(100 * length, 3) + " cm"
                          : shortDecimalText(length, 0) + " m");
}

/** @brief Returns the largest scale at which all maps fit, pixels per metre. */
double
scaleFor(const std::vector<Panel>& maps)
{
  const auto count = static_cast<double>(maps.size());
  const double tallest = std::max(800.0, 150 * count); // of all maps
  Eigen::Vector2d largest(0, 0);
  for (const Panel& map : maps)
    largest = largest.cwiseMax(map.view.sizes());
  double best = 0;
  for (double columns = count; columns >= 1; --columns) {
    const double scale = std::min(((inside + gap) / columns - gap) / largest.x(),
                                  tallest / std::ceil(count / columns) / largest.y());
    // Adjacent maps compare better: more lines only if maps become much larger.
    if (scale > 1.5 * best)
      best = scale;
  }
  return best;
}

/** @brief Returns a box grown by a share of its size, and `least` metres at least. */
Box
grown(const Box& box, double least)
{
  if (box.isEmpty())
    return box;
  const Eigen::Vector2d around =
      Eigen::Vector2d::Constant(std::max(0.02 * box.sizes().maxCoeff(), least));
  return {box.min() - around, box.max() + around};
}

} // namespace

Panel::Panel(std::string title, const Box& view)
    : title(std::move(title))
    , view(view.isEmpty() || (view.sizes().array() <= 0).any()
               ? Box(Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 1))
               : view)
{}

void
Panel::addCells(const ColouredCells& cells, double cell_size)
{
  for (const auto& [colour, keys] : cells) {
    // Keys run row by row, so that neighbours in a row become one box.
    const CellSet set(keys);
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < set.size(); ++i) {
      const Eigen::Vector2d low(set[i].x, set[i].y);
      if (i == 0 || set.keys()[i] != set.keys()[i - 1] + 1)
        boxes.emplace_back(Eigen::Vector2d(cell_size * low));
      boxes.back().extend(Eigen::Vector2d(cell_size * (low + Eigen::Vector2d::Ones())));
    }
    shapes.emplace_back(SheetBoxes{colour, std::move(boxes)});
  }
}

void
Panel::addPoints(const Places& points, Colour colour, double size)
{
  const Eigen::Vector2d half = Eigen::Vector2d::Constant(size / 2);
  std::vector<Box> boxes;
  for (const Eigen::Vector2d& p : points)
    boxes.emplace_back(p - half, p + half);
  shapes.emplace_back(SheetBoxes{colour, std::move(boxes)});
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
  const Box box(corner, corner + scale * view.sizes());
  sheet.add(SheetView{box, view});
  sheet.items.insert(sheet.items.end(), shapes.begin(), shapes.end());
  sheet.add(SheetView{});
  sheet.addBox({no_colour, colours::faint, 1}, box);
  TextPlaces places;
  for (const auto& [place, text] : labels) {
    constexpr double edge = 3; // pixels to the frame
    SheetText label{colours::ink, corner + scale * (place - view.min()), font, text};
    label.ground = paper_colour;
    label.is_bold = true;
    const Eigen::Vector2d half = font * halfSizeOf({text});
    const Eigen::Vector2d in = half + Eigen::Vector2d::Constant(edge);
    label.place = label.place.cwiseMin(box.max() - in).cwiseMax(box.min() + in);
    if (view.contains(place) && places.takeFirst({{label.place, half, 0}}))
      sheet.add(label);
  }
}

std::string
Picture::png() const
{
  // Drawn downwards from the top at y = 0; the height is known then.
  constexpr double title_font = 19;
  constexpr double narrowest = 528;
  Sheet sheet;
  sheet.title = title;
  addText(sheet, title, {margin, -title_height / 2 - 2}, title_font);
  Flow flow;
  const double scale = scaleFor(maps);
  for (const Panel& map : maps) {
    const Eigen::Vector2d size = scale * map.view.sizes();
    const Eigen::Vector2d at =
        flow.place(size + Eigen::Vector2d(0, panel_title_height + 8));
    addText(sheet, map.title, at - Eigen::Vector2d(0, panel_title_height / 2), 15,
            size.x() + gap - 6);
    map.draw(at - Eigen::Vector2d(0, panel_title_height + size.y()), scale, sheet);
  }
  flow.endLine();
  flow.right = std::ceil(std::min(
      flow.right, std::max({flow.end, margin + title_font * textWidth(title, true),
                            margin + narrowest})));
  flow.next.y() -= line_height / 2;
  if (!maps.empty())
    addScaleBar(sheet, flow, scale);
  for (const auto& [meaning, colour] : legend)
    addEntry(sheet, flow, {14, 14}, colour, meaning);
  flow.endLine();
  sheet.size = {flow.right + margin, std::ceil(line_height / 2 - flow.next.y())};
  sheet.bottom = -sheet.size.y();
  return sheetPng(sheet);
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
    const double all = places.back() - places.front();
    std::size_t off = places.size() / 100;
    if (2 * (places[places.size() - 1 - off] - places[off]) >= all)
      off = 0;
    view.min()[axis] = places[off];
    view.max()[axis] = places[places.size() - 1 - off] + cell_size;
  }
  return grown(view, 2 * cell_size);
}

Box
viewOf(const std::vector<const Floorplan*>& plans)
{
  Box view;
  for (const Floorplan* plan : plans)
    for (const PlanRoom& room : plan->rooms)
      view.extend(boundsOf(room.boundary));
  return grown(view, 0.4);
}

Colour
distanceColour(double distance, double range)
{
  static constexpr std::array<Colour, 5> stops{
      {0x2c5ac8, 0x28aa5a, 0xf0d632, 0xf08c1e, 0xc81e1e}};
  if (std::isnan(distance))
    return colours::other;
  const double place =
      std::clamp(distance / range, 0.0, 1.0) * static_cast<double>(stops.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(place), stops.size() - 2);
  return mixed(stops[i], stops[i + 1], place - static_cast<double>(i));
}

std::string
distanceText(double metres)
{
  const double centimetres = 100 * metres;
  const bool is_whole = std::abs(centimetres - std::round(centimetres)) < 1e-9;
  const int digits = metres >= 1 ? 1 : is_whole ? 0 : centimetres < 0.1 ? 2 : 1;
  return formatText(metres >= 1 ? "%.*f m" : "%.*f cm", digits,
                    metres >= 1 ? metres : centimetres);
}

std::string
hexCode(Colour colour)
{
  return formatText("#%06x", colour);
}

} // namespace pcl::sedr::tools
