// SPDX-License-Identifier: BSD-3-Clause
#include "text_places.h"

#include "sedr_filters/src/plan/plan_geometry.h"
#include "sheet.h"

#include <boost/geometry.hpp>

#include <algorithm>
#include <limits>

namespace pcl::sedr {

namespace geometry = boost::geometry;
namespace index = geometry::index;

/** @brief Returns the corners, a hair inside: boxes that touch do not meet. */
TextBox::Outline
TextBox::outline() const
{
  constexpr double hair = 1e-9;
  const Eigen::Rotation2Dd turn(degrees * M_PI / 180);
  Outline outline;
  for (const auto& [x, y] : {std::pair(-1, -1), {-1, 1}, {1, 1}, {1, -1}, {-1, -1}}) {
    const Eigen::Vector2d half = half_size - Eigen::Vector2d::Constant(hair);
    const Eigen::Vector2d corner =
        middle + turn * half.cwiseProduct(Eigen::Vector2d(x, y));
    outline.emplace_back(corner.x(), corner.y());
  }
  return outline;
}

bool
TextBox::meets(const TextBox& other) const
{
  return geometry::intersects(outline(), other.outline());
}

bool
TextBox::meets(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const
{
  const geometry::model::segment<Corner> line({from.x(), from.y()}, {to.x(), to.y()});
  return geometry::intersects(line, outline());
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
  return geometry::return_envelope<Bounds>(box.outline());
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
  return geometry::covered_by(boundsOf(box), page_) &&
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

TextSpot
textSpotIn(const PlanLoop& loop, const std::vector<PlanLoop>& obstacles)
{
  // A lattice over the loop, then finer ones around the best place.
  constexpr int steps = 24;
  constexpr int rounds = 3;
  constexpr double pull = 0.05; // towards the middle, among equally good places
  Eigen::AlignedBox2d box = boundsOf(loop);
  const Eigen::Vector2d middle = box.center();
  TextSpot best{middle, 0};
  double best_score = -std::numeric_limits<double>::infinity();
  const auto isFree = [&](const Eigen::Vector2d& p) {
    return loop.contains(p) &&
           std::none_of(obstacles.begin(), obstacles.end(),
                        [&](const PlanLoop& obstacle) { return obstacle.contains(p); });
  };
  for (int round = 0; round < rounds && !box.isEmpty(); ++round) {
    const Eigen::Vector2d step = box.sizes() / steps;
    for (int k = 0; k < (steps + 1) * (steps + 1); ++k) {
      const Eigen::Vector2d p =
          box.min() +
          step.cwiseProduct(Eigen::Vector2d(k / (steps + 1), k % (steps + 1)));
      if (!isFree(p))
        continue;
      double clearance = loop.distance(p);
      for (const PlanLoop& obstacle : obstacles)
        clearance = std::min(clearance, obstacle.distance(p));
      const double score = clearance - pull * (p - middle).norm();
      if (score <= best_score)
        continue;
      best_score = score;
      best = {p, clearance};
    }
    box = Eigen::AlignedBox2d(best.place - step, best.place + step);
  }
  return best;
}

PlanLoop
circleAbout(const TextSpot& spot)
{
  PlanElement circle;
  circle.centre = spot.place;
  circle.radius = spot.radius;
  circle.start = circle.end = spot.place + Eigen::Vector2d(spot.radius, 0);
  return {{circle}};
}

} // namespace pcl::sedr
