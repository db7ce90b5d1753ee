// SPDX-License-Identifier: BSD-3-Clause
#include "panel.h"

#include "sedr_surface/src/sheet/text_places.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr::tools {

void
Panel::addBoxes(std::vector<Box> boxes, Colour colour)
{
  for (const Box& box : boxes)
    bounds_.extend(box);
  layers_.emplace_back([boxes = std::move(boxes), colour](Sheet& sheet,
                                                          const Frame& frame) {
    constexpr double thinnest = 1; // pixels
    SheetBoxes drawn{colour.number(), {}};
    for (const Box& box : boxes) {
      if (!frame.view.intersects(box))
        continue;
      const Eigen::Vector2d low = frame(box.min());
      drawn.boxes.emplace_back(low, low + (frame(box.max()) - low).cwiseMax(thinnest));
    }
    sheet.add(std::move(drawn));
  });
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
Panel::addPoints(Places points, Colour colour, double pixels)
{
  for (const Eigen::Vector2d& p : points)
    bounds_.extend(p);
  layers_.emplace_back(
      [points = std::move(points), colour, pixels](Sheet& sheet, const Frame& frame) {
        const Eigen::Vector2d half = Eigen::Vector2d::Constant(pixels / 2);
        SheetBoxes drawn{colour.number(), {}};
        for (const Eigen::Vector2d& p : points)
          if (frame.view.contains(p))
            drawn.boxes.emplace_back(frame(p) - half, frame(p) + half);
        sheet.add(std::move(drawn));
      });
}

void
Panel::addPath(const Places& points, Colour colour, double pixels)
{
  PlanLoop chain;
  for (std::size_t k = 1; k < points.size(); ++k) {
    chain.elements.emplace_back();
    chain.elements.back().start = points[k - 1];
    chain.elements.back().end = points[k];
  }
  for (const Eigen::Vector2d& p : points)
    bounds_.extend(p);
  addLoop(chain, colour, colour, pixels);
}

void
Panel::addLoop(const PlanLoop& loop, Colour segments, Colour arcs, double pixels)
{
  for (const Eigen::Vector2d& p : loop.polygon(0.01))
    bounds_.extend(p);
  layers_.emplace_back([=](Sheet& sheet, const Frame& frame) {
    for (const bool is_arc : {false, true}) {
      const Colour colour = is_arc ? arcs : segments;
      SheetPath path{{no_colour, colour.number(), pixels}, {}};
      for (PlanElement e : loop.elements) {
        if (e.isArc() != is_arc)
          continue;
        e.radius *= frame.scale().x();
        for (Eigen::Vector2d* p : {&e.start, &e.end, &e.centre})
          *p = frame(*p);
        path.chains.push_back({{e}});
      }
      sheet.add(std::move(path));
    }
  });
}

void
Panel::addTriangles(std::vector<SheetTriangle> triangles)
{
  for (const SheetTriangle& triangle : triangles)
    for (const Eigen::Vector2d& corner : triangle.corners)
      bounds_.extend(corner);
  layers_.emplace_back(
      [triangles = std::move(triangles)](Sheet& sheet, const Frame& frame) {
        for (SheetTriangle triangle : triangles) {
          for (Eigen::Vector2d& corner : triangle.corners)
            corner = frame(corner);
          sheet.add(triangle);
        }
      });
}

void
Panel::addLabel(const Eigen::Vector2d& place,
                const std::string& text,
                Colour colour,
                TextAnchor anchor)
{
  constexpr double font = 14;
  SheetText label{colour.number(), place, font, text};
  label.anchor = anchor;
  label.ground = paper_colour;
  label.is_bold = true;
  labels_.push_back({place, label});
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
Panel::drawLabels(Sheet& sheet, const Frame& frame) const
{
  constexpr double edge = 3; // pixels to the frame
  TextPlaces places;
  for (const Label& label : labels_) {
    if (!frame.view.contains(label.place))
      continue;
    SheetText text = label.text;
    const Eigen::Vector2d half =
        text.font * Eigen::Vector2d(textWidth(text.text, true) / 2 + 0.15, 0.6);
    const Eigen::Vector2d at = frame(label.place);
    const double shift = text.anchor == TextAnchor::Start    ? half.x()
                         : text.anchor == TextAnchor::Middle ? 0
                                                             : -half.x();
    // Labels near the edge are moved inside.
    text.place = {
        std::max(frame.box.min().x() + half.x() + edge,
                 std::min(at.x() + shift, frame.box.max().x() - half.x() - edge)),
        at.y()};
    text.anchor = TextAnchor::Middle;
    if (places.takeFirst({{text.place, half, 0}}))
      sheet.add(text);
  }
}

void
Panel::draw(Sheet& sheet, const Box& box) const
{
  const Frame frame{box, view()};
  sheet.add(SheetClip{box});
  for (const Layer& layer : layers_)
    layer(sheet, frame);
  drawLabels(sheet, frame);
  sheet.add(SheetClip{});
}

Box
grown(const Box& box, double margin)
{
  if (box.isEmpty())
    return box;
  const Eigen::Vector2d around = Eigen::Vector2d::Constant(margin);
  return {box.min() - around, box.max() + around};
}

Box
viewOf(const CellSet& cells, double cell_size, std::size_t min_piece)
{
  if (cells.empty())
    return {};
  const CellRegions regions = labelRegions(cells);
  const auto isLarge = [&](std::size_t i) {
    return regions.sizes[regions.label[i]] >= min_piece;
  };
  Box view;
  for (const int axis : {0, 1}) {
    std::vector<double> places;
    std::vector<double> large;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const double place = cell_size * (axis == 0 ? cells[i].x : cells[i].y);
      places.push_back(place);
      if (isLarge(i))
        large.push_back(place);
    }
    if (!large.empty())
      places = large;
    std::sort(places.begin(), places.end());
    const std::size_t off = places.size() / 1000;
    double low = places[off];
    double high = places[places.size() - 1 - off];
    if (2 * (high - low) >= places.back() - places.front()) {
      low = places.front();
      high = places.back();
    }
    view.min()[axis] = low;
    view.max()[axis] = high + cell_size;
  }
  return grown(view, std::max(0.02 * view.sizes().maxCoeff(), 2 * cell_size));
}

} // namespace pcl::sedr::tools
