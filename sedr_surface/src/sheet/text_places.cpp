// SPDX-License-Identifier: BSD-3-Clause
#include "text_places.h"

#include "sheet.h"

#include <boost/geometry/strategies/cartesian/box_in_box.hpp>

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

namespace index = boost::geometry::index;

namespace {

Eigen::Vector2d
left(const Eigen::Vector2d& way)
{
  return {-way.y(), way.x()};
}

/** @brief Returns whether a straight line separates two boxes. */
bool
isParted(const TextBox& a, const TextBox& b)
{
  const Eigen::Vector2d way = a.way();
  const Eigen::Vector2d other = b.way();
  const Eigen::Vector2d between = b.middle - a.middle;
  const auto reach = [&](const Eigen::Vector2d& axis) {
    return b.half_size.x() * std::abs(other.dot(axis)) +
           b.half_size.y() * std::abs(left(other).dot(axis));
  };
  return std::abs(between.dot(way)) >= a.half_size.x() + reach(way) ||
         std::abs(between.dot(left(way))) >= a.half_size.y() + reach(left(way));
}

} // namespace

Eigen::Vector2d
TextBox::way() const
{
  const double turn = degrees * M_PI / 180;
  return {std::cos(turn), std::sin(turn)};
}

bool
TextBox::meets(const TextBox& other) const
{
  return !isParted(*this, other) && !isParted(other, *this);
}

bool
TextBox::meets(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const
{
  // Clips the line to each pair of sides.
  double first = 0;
  double last = 1;
  for (int k = 0; k < 2; ++k) {
    const Eigen::Vector2d axis = k == 0 ? way() : left(way());
    const double start = (from - middle).dot(axis);
    const double step = (to - from).dot(axis);
    if (step == 0) {
      if (std::abs(start) >= half_size[k])
        return false;
      continue;
    }
    const double a = (-half_size[k] - start) / step;
    const double b = (half_size[k] - start) / step;
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  return first < last;
}

Eigen::Vector2d
halfSizeOf(const std::vector<std::string>& lines)
{
  constexpr double reserve = 1.1;
  constexpr double line_height = 1.3;
  double width = 0;
  for (const std::string& line : lines)
    width = std::max(width, textWidth(line));
  return {reserve * width / 2, line_height * static_cast<double>(lines.size()) / 2};
}

double
readableAngle(const Eigen::Vector2d& way)
{
  constexpr double past_vertical = 20; // walls that nearly run up the sheet are alike
  double degrees = std::atan2(way.y(), way.x()) * 180 / M_PI;
  if (degrees > 90 + past_vertical)
    degrees -= 180;
  if (degrees <= past_vertical - 90)
    degrees += 180;
  return degrees;
}

TextPlaces::Bounds
TextPlaces::boundsOf(const TextBox& box)
{
  const Eigen::Vector2d way = box.way().cwiseAbs();
  const Eigen::Vector2d reach(box.half_size.dot(way),
                              box.half_size.dot(Eigen::Vector2d(way.y(), way.x())));
  const Eigen::Vector2d low = box.middle - reach;
  const Eigen::Vector2d high = box.middle + reach;
  return {{low.x(), low.y()}, {high.x(), high.y()}};
}

void
TextPlaces::add(const Line& line, Tree<Line>& lines)
{
  const Eigen::Vector2d low = line.first.cwiseMin(line.second);
  const Eigen::Vector2d high = line.first.cwiseMax(line.second);
  lines.insert({{{low.x(), low.y()}, {high.x(), high.y()}}, line});
}

void
TextPlaces::addChords(const PlanElement& line, Tree<Line>& lines)
{
  constexpr double chord = 0.2; // millimetres between an arc and its chords
  std::vector<Eigen::Vector2d> corners = PlanLoop{{line}}.polygon(chord);
  corners.push_back(line.end);
  for (std::size_t k = 0; k + 1 < corners.size(); ++k)
    add({corners[k], corners[k + 1]}, lines);
}

bool
TextPlaces::meetsAny(const TextBox& box, const Tree<Line>& lines)
{
  return std::any_of(lines.qbegin(index::intersects(boundsOf(box))), lines.qend(),
                     [&](const auto& entry) {
                       return box.meets(entry.second.first, entry.second.second);
                     });
}

bool
TextPlaces::isFree(const TextBox& box) const
{
  return boost::geometry::covered_by(boundsOf(box), page_) &&
         std::none_of(taken_.qbegin(index::intersects(boundsOf(box))), taken_.qend(),
                      [&](const auto& other) { return box.meets(other.second); }) &&
         !meetsAny(box, lines_);
}

std::optional<TextBox>
TextPlaces::takeFirst(const std::vector<TextBox>& boxes)
{
  const TextBox* best = nullptr;
  for (const TextBox& box : boxes) {
    if (!isFree(box))
      continue;
    const bool is_clear = !meetsAny(box, avoided_);
    if (is_clear || !best)
      best = &box;
    if (is_clear)
      break;
  }
  if (!best)
    return std::nullopt;
  taken_.insert({boundsOf(*best), *best});
  return *best;
}

} // namespace pcl::sedr
