// SPDX-License-Identifier: BSD-3-Clause
#include "panel.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr::tools {

namespace {

/** @brief Returns points along an element; chords of an arc within 0.5 mm. */
std::vector<Eigen::Vector2d>
pointsAlong(const PlanElement& element)
{
  if (!element.isArc())
    return {element.start, element.end};
  constexpr double tolerance = 0.0005;
  const double step =
      2 * std::acos(std::max(0.0, 1 - tolerance / std::max(element.radius, tolerance)));
  const auto chords = static_cast<int>(
      std::clamp(std::ceil(std::abs(element.sweep()) / step), 2.0, 1000.0));
  std::vector<Eigen::Vector2d> points;
  for (int k = 0; k <= chords; ++k)
    points.push_back(element.pointAt(element.length() * k / chords));
  return points;
}

/** @brief Computes the range of values without one in a thousand at each end if that
 * halves it, else the whole range. */
void
trim(std::vector<double>& values, double& low, double& high)
{
  std::sort(values.begin(), values.end());
  const std::size_t off = values.size() / 1000;
  low = values[off];
  high = values[values.size() - 1 - off];
  if (2 * (high - low) >= values.back() - values.front()) {
    low = values.front();
    high = values.back();
  }
}

} // namespace

struct Panel::Frame {
  Box pixels;
  Box view;

  Eigen::Vector2d scale() const { return pixels.size().cwiseQuotient(view.size()); }

  Eigen::Vector2d at(const Eigen::Vector2d& place) const
  {
    const Eigen::Vector2d d = (place - view.low).cwiseProduct(scale());
    return {pixels.low.x() + d.x(), pixels.high.y() - d.y()};
  }
};

void
Panel::setAxis(const std::string& along_x)
{
  is_chart_ = true;
  x_axis_ = along_x;
}

void
Panel::addBoxes(std::vector<Box> boxes, Colour colour)
{
  for (const auto& box : boxes)
    bounds_.extend(box);
  layers_.push_back(Boxes{std::move(boxes), colour});
}

void
Panel::addCells(const CellSet& cells, double cell_size, Colour colour)
{
  // Keys run row by row, so that neighbours in a row become one box.
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Cell cell = cells[i];
    const Eigen::Vector2d low(cell.x, cell.y);
    const bool goes_on = i > 0 && cells.keys()[i] == cells.keys()[i - 1] + 1;
    if (!goes_on)
      boxes.push_back({cell_size * low, cell_size * low});
    boxes.back().high = cell_size * (low + Eigen::Vector2d::Ones());
  }
  addBoxes(std::move(boxes), colour);
}

void
Panel::addPoints(std::vector<Eigen::Vector2d> points, Colour colour, double pixels)
{
  for (const auto& p : points)
    bounds_.extend(p);
  layers_.push_back(Points{std::move(points), colour, pixels});
}

void
Panel::addPath(std::vector<Eigen::Vector2d> points, Colour colour, double pixels)
{
  for (const auto& p : points)
    bounds_.extend(p);
  layers_.push_back(Path{std::move(points), colour, pixels});
}

void
Panel::addLoop(const PlanLoop& loop, Colour segments, Colour arcs, double pixels)
{
  for (const auto& element : loop.elements)
    addPath(pointsAlong(element), element.isArc() ? arcs : segments, pixels);
}

void
Panel::addTriangles(std::vector<ViewedTriangle> triangles)
{
  for (const auto& triangle : triangles)
    for (const auto& corner : triangle.corners)
      bounds_.extend(Eigen::Vector2d(corner.head<2>()));
  layers_.push_back(std::move(triangles));
}

void
Panel::addLabel(const Eigen::Vector2d& place,
                const std::string& text,
                Colour colour,
                Anchor anchor)
{
  labels_.push_back({place, text, colour, anchor});
}

Box
Panel::view() const
{
  if (!view_.isEmpty() && (view_.size().array() > 0).all())
    return view_;
  Box box = bounds_;
  if (box.isEmpty())
    box.extend(Eigen::Vector2d(0, 0));
  return box.grown(std::max(0.02 * box.size().maxCoeff(), 0.05));
}

void
Panel::draw(const Boxes& layer, const Frame& frame, Canvas& canvas)
{
  for (const auto& box : layer.boxes) {
    const Eigen::Vector2d a = frame.at(box.low);
    const Eigen::Vector2d b = frame.at(box.high);
    canvas.fillBox({{a.x(), b.y()}, {b.x(), a.y()}}, layer.colour);
  }
}

void
Panel::draw(const Points& layer, const Frame& frame, Canvas& canvas)
{
  for (const auto& p : layer.points)
    if (frame.view.contains(p))
      canvas.drawDisc(frame.at(p), layer.pixels / 2, layer.colour);
}

void
Panel::draw(const Path& layer, const Frame& frame, Canvas& canvas)
{
  for (std::size_t i = 1; i < layer.points.size(); ++i)
    canvas.drawLine(frame.at(layer.points[i - 1]), frame.at(layer.points[i]),
                    layer.pixels, layer.colour);
}

void
Panel::draw(const Triangles& layer, const Frame& frame, Canvas& canvas)
{
  for (const auto& triangle : layer) {
    std::array<Eigen::Vector3d, 3> corners = triangle.corners;
    for (auto& corner : corners)
      corner.head<2>() = frame.at(corner.head<2>());
    canvas.fillTriangle(corners, triangle.colour);
  }
}

void
Panel::drawLabels(const Frame& frame, Canvas& canvas) const
{
  std::vector<Box> taken;
  for (const auto& label : labels_) {
    if (!frame.view.contains(label.place))
      continue;
    const Eigen::Vector2d p = frame.at(label.place);
    Text text{label.text, p.x(), p.y(), 14, label.colour, label.anchor, true, true};
    const double width = widthOf(text);
    const double left = label.anchor == Anchor::Left     ? p.x()
                        : label.anchor == Anchor::Middle ? p.x() - width / 2
                                                         : p.x() - width;
    // Labels near the edge are moved inside.
    const double moved = std::max(frame.pixels.low.x() + 3,
                                  std::min(left, frame.pixels.high.x() - 3 - width));
    text.x += moved - left;
    const Box box{{moved - 2, p.y() - 9}, {moved + width + 2, p.y() + 9}};
    const bool is_taken = std::any_of(taken.begin(), taken.end(), [&](const Box& t) {
      return (box.low.array() < t.high.array()).all() &&
             (t.low.array() < box.high.array()).all();
    });
    if (is_taken)
      continue;
    taken.push_back(box);
    canvas.addText(text);
  }
}

void
Panel::draw(Canvas& canvas, const Box& pixels) const
{
  const Frame frame{pixels, view()};
  canvas.setClip(pixels);
  for (const auto& layer : layers_)
    std::visit([&](const auto& shapes) { draw(shapes, frame, canvas); }, layer);
  drawLabels(frame, canvas);
}

Box
viewOf(const CellSet& cells, double cell_size)
{
  Box view;
  if (cells.empty())
    return view;
  std::array<std::vector<double>, 2> places;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    places[0].push_back(cells[i].x);
    places[1].push_back(cells[i].y);
  }
  for (std::size_t axis = 0; axis < 2; ++axis) {
    double low = 0;
    double high = 0;
    trim(places[axis], low, high);
    view.low[static_cast<Eigen::Index>(axis)] = cell_size * low;
    view.high[static_cast<Eigen::Index>(axis)] = cell_size * (high + 1);
  }
  return view.grown(std::max(0.02 * view.size().maxCoeff(), 2 * cell_size));
}

Box
viewOfPieces(const CellSet& cells, double cell_size, std::size_t least)
{
  const CellRegions regions = labelRegions(cells);
  std::vector<CellKey> large;
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (regions.sizes[regions.label[i]] >= least)
      large.push_back(cells.keys()[i]);
  return viewOf(large.empty() ? cells : CellSet::fromSorted(std::move(large)),
                cell_size);
}

} // namespace pcl::sedr::tools
