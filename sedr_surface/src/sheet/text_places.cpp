// SPDX-License-Identifier: BSD-3-Clause
#include "text_places.h"

#include "letter_widths.h"

#include <algorithm>
#include <cmath>

namespace pcl {
namespace sedr {
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
  constexpr double reserve = 1.2; // DejaVu Sans is 15 % wider than Helvetica
  constexpr double line_height = 1.3;
  double width = 0;
  for (const std::string& line : lines)
    width = std::max(width, textWidth(line));
  return {reserve * width / 2, line_height * static_cast<double>(lines.size()) / 2};
}

double
readableAngle(const Eigen::Vector2d& way)
{
  double degrees = std::atan2(way.y(), way.x()) * 180 / M_PI;
  if (degrees > 91)
    degrees -= 180;
  if (degrees <= -89)
    degrees += 180;
  return degrees;
}

void
TextPlaces::keepOff(const PlanLoop& loop)
{
  constexpr double chord = 0.2;
  const std::vector<Eigen::Vector2d> corners = loop.polygon(chord);
  for (std::size_t i = 0; i < corners.size(); ++i)
    lines_.emplace_back(corners[i], corners[(i + 1) % corners.size()]);
}

bool
TextPlaces::take(const TextBox& box)
{
  if (std::any_of(taken_.begin(), taken_.end(),
                  [&](const TextBox& other) { return box.meets(other); }) ||
      std::any_of(lines_.begin(), lines_.end(),
                  [&](const auto& line) { return box.meets(line.first, line.second); }))
    return false;
  taken_.push_back(box);
  return true;
}

std::optional<TextBox>
TextPlaces::takeFirst(const std::vector<TextBox>& boxes)
{
  for (const TextBox& box : boxes)
    if (take(box))
      return box;
  return std::nullopt;
}

} // namespace sedr
} // namespace pcl
