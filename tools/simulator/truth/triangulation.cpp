// SPDX-License-Identifier: BSD-3-Clause
#include "triangulation.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace pcl::sedr::sim {

namespace {

using Points = std::vector<Vec2>;

constexpr double kFlat = 1e-10; ///< twice the area below which a triangle is degenerate
constexpr double kNoEar = -1.0;

double
turn(Vec2 a, Vec2 b, Vec2 c)
{
  return cross(b - a, c - a);
}

bool
ringContains(const Points& points, const Ring& ring, Vec2 p)
{
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = points[ring[i]];
    const Vec2 b = points[ring[(i + 1) % ring.size()]];
    if ((a.y > p.y) != (b.y > p.y) &&
        p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x))
      inside = !inside;
  }
  return inside;
}

/** @brief Returns true if two segments have a point in common. */
bool
segmentsTouch(Vec2 a, Vec2 b, Vec2 c, Vec2 d)
{
  const auto side = [](double t) { return t > kFlat ? 1 : (t < -kFlat ? -1 : 0); };
  const int c_side = side(turn(a, b, c));
  const int d_side = side(turn(a, b, d));
  const int a_side = side(turn(c, d, a));
  const int b_side = side(turn(c, d, b));
  if (c_side == 0 && d_side == 0) {
    const Vec2 along = b - a;
    const double from = std::min(dot(c - a, along), dot(d - a, along));
    const double to = std::max(dot(c - a, along), dot(d - a, along));
    return from <= dot(along, along) && to >= 0.0;
  }
  return c_side * d_side <= 0 && a_side * b_side <= 0;
}

/** @brief Joins the holes to the outer ring, each by one bridge. */
class HoleBridger {
public:
  HoleBridger(const Points& points, const Polygon& polygon)
      : points_(points)
      , ring_(polygon.outer)
      , holes_(polygon.holes)
  {}

  Ring run()
  {
    std::sort(holes_.begin(), holes_.end(), [this](const Ring& a, const Ring& b) {
      return points_[a[rightmost(a)]].x > points_[b[rightmost(b)]].x;
    });
    while (!holes_.empty()) {
      insert(holes_.front());
      holes_.erase(holes_.begin());
    }
    return ring_;
  }

private:
  std::size_t rightmost(const Ring& ring) const
  {
    const auto less = [this](std::size_t a, std::size_t b) {
      return points_[a].x < points_[b].x;
    };
    return std::max_element(ring.begin(), ring.end(), less) - ring.begin();
  }

  /** @brief Connects @p hole to the ring at its nearest visible corner. */
  void insert(const Ring& hole)
  {
    const std::size_t first = rightmost(hole);
    const std::size_t corner = nearestVisible(hole[first]);
    Ring bridge;
    for (std::size_t i = 0; i <= hole.size(); ++i)
      bridge.push_back(hole[(first + i) % hole.size()]);
    bridge.push_back(ring_[corner]);
    ring_.insert(ring_.begin() + corner + 1, bridge.begin(), bridge.end());
  }

  /** @brief Returns the ring position of the corner for a bridge from point @p from. */
  std::size_t nearestVisible(std::size_t from) const
  {
    std::vector<std::pair<double, std::size_t>> candidates;
    for (std::size_t i = 0; i < ring_.size(); ++i)
      candidates.emplace_back(length(points_[ring_[i]] - points_[from]), i);
    std::sort(candidates.begin(), candidates.end());
    for (const auto& [distance, i] : candidates)
      if (opensTowards(i, points_[from]) && isFree(ring_[i], from))
        return i;
    throw std::invalid_argument("A hole cannot be joined to its polygon");
  }

  /** @brief Returns true if @p target is within the inner angle at corner @p i. */
  bool opensTowards(std::size_t i, Vec2 target) const
  {
    const Vec2 a = points_[ring_[(i + ring_.size() - 1) % ring_.size()]];
    const Vec2 b = points_[ring_[i]];
    const Vec2 c = points_[ring_[(i + 1) % ring_.size()]];
    const bool left_in = turn(a, b, target) > 0.0;
    const bool left_out = turn(b, c, target) > 0.0;
    return turn(a, b, c) >= 0.0 ? left_in && left_out : left_in || left_out;
  }

  /** @brief Returns true if the bridge between two points touches no other edge. */
  bool isFree(std::size_t a, std::size_t b) const
  {
    return isFreeOf(ring_, a, b) &&
           std::all_of(holes_.begin(), holes_.end(),
                       [&](const Ring& hole) { return isFreeOf(hole, a, b); });
  }

  bool isFreeOf(const Ring& ring, std::size_t a, std::size_t b) const
  {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::size_t c = ring[i];
      const std::size_t d = ring[(i + 1) % ring.size()];
      if (c == a || d == a || c == b || d == b)
        continue;
      if (segmentsTouch(points_[a], points_[b], points_[c], points_[d]))
        return false;
    }
    return true;
  }

  const Points& points_;
  Ring ring_;
  std::vector<Ring> holes_;
};

/** @brief Cuts triangles off a simple ring, which may touch itself along bridges. */
class EarClipper {
public:
  EarClipper(const Points& points, Ring ring)
      : points_(points)
      , ring_(std::move(ring))
  {}

  std::vector<Triangle> run()
  {
    std::vector<Triangle> triangles;
    for (std::size_t i = 0; i < ring_.size(); ++i)
      quality_.push_back(earQuality(i));
    while (ring_.size() >= 3) {
      const auto best = std::max_element(quality_.begin(), quality_.end());
      if (*best <= 0.0)
        throw std::invalid_argument(
            "The outline of a polygon crosses or touches itself");
      const std::size_t ear = best - quality_.begin();
      triangles.push_back(cornerAt(ear));
      clip(ear);
    }
    return triangles;
  }

private:
  Triangle cornerAt(std::size_t i) const
  {
    const std::size_t n = ring_.size();
    return {ring_[(i + n - 1) % n], ring_[i], ring_[(i + 1) % n]};
  }

  /** @brief Removes a corner and updates its two neighbours, the only ones affected. */
  void clip(std::size_t ear)
  {
    ring_.erase(ring_.begin() + ear);
    quality_.erase(quality_.begin() + ear);
    const std::size_t n = ring_.size();
    if (n < 3)
      return;
    quality_[(ear + n - 1) % n] = earQuality((ear + n - 1) % n);
    quality_[ear % n] = earQuality(ear % n);
  }

  /** @brief Returns area over squared longest side, or kNoEar. */
  double earQuality(std::size_t i) const
  {
    const Triangle corner = cornerAt(i);
    const Vec2 a = points_[corner[0]];
    const Vec2 b = points_[corner[1]];
    const Vec2 c = points_[corner[2]];
    const double area = turn(a, b, c);
    if (area <= kFlat || holdsPoint(corner))
      return kNoEar;
    const double longest =
        std::max({dot(b - a, b - a), dot(c - b, c - b), dot(a - c, a - c)});
    return area / longest;
  }

  /** @brief Returns true if another point of the ring lies in or on the triangle. */
  bool holdsPoint(const Triangle& t) const
  {
    const Vec2 a = points_[t[0]];
    const Vec2 b = points_[t[1]];
    const Vec2 c = points_[t[2]];
    return std::any_of(ring_.begin(), ring_.end(), [&](std::size_t i) {
      if (i == t[0] || i == t[1] || i == t[2])
        return false;
      const Vec2 p = points_[i];
      return turn(a, b, p) >= -kFlat && turn(b, c, p) >= -kFlat &&
             turn(c, a, p) >= -kFlat;
    });
  }

  const Points& points_;
  Ring ring_;
  std::vector<double> quality_;
};

} // namespace

double
areaOf(const std::vector<Vec2>& points, const Ring& ring)
{
  double area = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i)
    area += 0.5 * cross(points[ring[i]], points[ring[(i + 1) % ring.size()]]);
  return area;
}

std::vector<Polygon>
polygonsOf(const std::vector<Vec2>& points, const std::vector<Ring>& rings)
{
  std::vector<Polygon> polygons;
  for (const Ring& ring : rings)
    if (areaOf(points, ring) > 0.0)
      polygons.push_back({ring, {}});
  for (const Ring& ring : rings) {
    if (areaOf(points, ring) > 0.0)
      continue;
    Polygon* home = nullptr;
    for (Polygon& polygon : polygons)
      if (ringContains(points, polygon.outer, points[ring.front()]) &&
          (home == nullptr ||
           areaOf(points, polygon.outer) < areaOf(points, home->outer)))
        home = &polygon;
    if (home == nullptr)
      throw std::invalid_argument("A hole lies outside of every polygon");
    home->holes.push_back(ring);
  }
  return polygons;
}

std::vector<Triangle>
triangulate(const std::vector<Vec2>& points, const Polygon& polygon)
{
  return EarClipper(points, HoleBridger(points, polygon).run()).run();
}

} // namespace pcl::sedr::sim
