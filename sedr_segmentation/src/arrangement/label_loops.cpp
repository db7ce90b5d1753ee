// SPDX-License-Identifier: BSD-3-Clause
#include "label_loops.h"

#include "../curves/contour.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Numbers places; those within a micrometre are one. */
class PlaceNumbers {
public:
  std::size_t numberOf(const Eigen::Vector2d& p)
  {
    const auto x = static_cast<std::int64_t>(std::floor(p.x() / size));
    const auto y = static_cast<std::int64_t>(std::floor(p.y() / size));
    for (std::int64_t dy = -1; dy <= 1; ++dy)
      for (std::int64_t dx = -1; dx <= 1; ++dx)
        if (const auto found = numbers_.find({x + dx, y + dy}); found != numbers_.end())
          if ((places_[found->second] - p).norm() < size)
            return found->second;
    numbers_[{x, y}] = places_.size();
    places_.push_back(p);
    return places_.size() - 1;
  }

  const Eigen::Vector2d& at(std::size_t number) const { return places_[number]; }

private:
  static constexpr double size = 1e-5; // metres
  std::map<std::pair<std::int64_t, std::int64_t>, std::size_t> numbers_;
  std::vector<Eigen::Vector2d> places_;
};

struct Piece {
  std::size_t from;
  std::size_t to;
  std::uint32_t line;
};

double
areaOf(const std::vector<Piece>& loop, const PlaceNumbers& places)
{
  std::vector<Eigen::Vector2d> corners;
  for (const Piece& piece : loop)
    corners.push_back(places.at(piece.from));
  return signedArea(corners);
}

/** @brief Follows pieces to closed loops; where several go on, the first to the left,
 * so that a loop touches itself at no corner from inside. */
std::vector<std::vector<Piece>>
loopsOf(const std::vector<Piece>& pieces, const PlaceNumbers& places)
{
  std::multimap<std::size_t, std::size_t> from;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    from.emplace(pieces[i].from, i);
  std::vector<std::uint8_t> is_taken(pieces.size(), 0);
  std::vector<std::vector<Piece>> loops;
  for (std::size_t first = 0; first < pieces.size(); ++first) {
    if (is_taken[first])
      continue;
    std::vector<Piece> loop;
    std::size_t i = first;
    while (!is_taken[i]) {
      is_taken[i] = 1;
      loop.push_back(pieces[i]);
      const Eigen::Vector2d way = places.at(pieces[i].to) - places.at(pieces[i].from);
      double best = -10;
      std::size_t next = i;
      const auto [begin, end] = from.equal_range(pieces[i].to);
      for (auto k = begin; k != end; ++k) {
        if (is_taken[k->second] && k->second != first)
          continue;
        const Piece& piece = pieces[k->second];
        const Eigen::Vector2d on = places.at(piece.to) - places.at(piece.from);
        const double turn =
            std::atan2(way.x() * on.y() - way.y() * on.x(), way.dot(on));
        if (turn > best) {
          best = turn;
          next = k->second;
        }
      }
      if (next == i)
        break;
      i = next;
    }
    if (loop.size() > 2 && loop.back().to == loop.front().from)
      loops.push_back(std::move(loop));
  }
  return loops;
}

} // namespace

PlanLoop
outerLoop(const std::vector<CellBorder>& borders,
          const std::vector<int>& labels,
          int label,
          const std::vector<PlanCurve>& curves)
{
  PlaceNumbers places;
  std::vector<Piece> pieces;
  for (const CellBorder& border : borders) {
    const bool is_left = labels[border.left] == label;
    if (is_left == (labels[border.right] == label))
      continue;
    const std::size_t a = places.numberOf(border.start);
    const std::size_t b = places.numberOf(border.end);
    if (a != b)
      pieces.push_back({is_left ? a : b, is_left ? b : a, border.line});
  }
  std::vector<Piece> outer;
  double largest = 0;
  for (auto& loop : loopsOf(pieces, places))
    if (const double area = areaOf(loop, places); area > largest) {
      largest = area;
      outer = std::move(loop);
    }
  PlanLoop result;
  if (outer.empty())
    return result;
  const auto isSame = [&](const Piece& a, const Piece& b) { return a.line == b.line; };
  std::size_t first = 0; // where a curve begins
  while (first < outer.size() &&
         isSame(outer[first], outer[(first + outer.size() - 1) % outer.size()]))
    ++first;
  if (first == outer.size())
    return result;
  std::rotate(outer.begin(), outer.begin() + static_cast<std::ptrdiff_t>(first),
              outer.end());
  for (std::size_t i = 0; i < outer.size();) {
    std::size_t j = i + 1;
    while (j < outer.size() && isSame(outer[i], outer[j]))
      ++j;
    PlanElement e;
    e.start = places.at(outer[i].from);
    e.end = places.at(outer[j - 1].to);
    if (const PlanCurve& curve = curves[outer[i].line]; curve.isCircle()) {
      e.centre = curve.point;
      e.radius = curve.radius;
      const Eigen::Vector2d a = places.at(outer[i].from) - curve.point;
      const Eigen::Vector2d b = places.at(outer[i].to) - curve.point;
      e.counter_clockwise = a.x() * b.y() - a.y() * b.x() > 0;
    }
    e.inliers = 1;
    result.elements.push_back(e);
    i = j;
  }
  // Corners of arcs lie on their chords: their circles and the lines beside them meet.
  const std::size_t n = result.elements.size();
  for (std::size_t i = 0; i < n; ++i) {
    PlanElement& a = result.elements[i];
    PlanElement& b = result.elements[(i + 1) % n];
    if (!a.isArc() && !b.isArc())
      continue;
    Eigen::Vector2d corner = a.end;
    double nearest = 0.1;
    for (const Eigen::Vector2d& p : intersections(carrierOf(a), carrierOf(b)))
      if (const double d = (p - a.end).norm(); d < nearest) {
        nearest = d;
        corner = p;
      }
    if (corner == a.end) {
      const PlanCurve circle = carrierOf(a.isArc() ? a : b);
      corner = circle.project(corner);
    }
    a.end = b.start = corner;
  }
  return result;
}

} // namespace pcl::sedr
