// SPDX-License-Identifier: BSD-3-Clause
#include "outline_edits.h"

#include "../base/number_text.h"

#include <pcl/sedr_filters/plan_editor.h>

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

std::optional<Eigen::Vector2d>
crossing(const PlanElement& a, const PlanElement& b)
{
  const Eigen::Vector2d u = a.end - a.start;
  const Eigen::Vector2d v = b.end - b.start;
  const double area = cross(u, v);
  const Eigen::Vector2d off = b.start - a.start;
  if (std::abs(area) <= 1e-12)
    return std::nullopt;
  const double s = cross(off, v) / area;
  const double t = cross(off, u) / area;
  if (s < 0 || s > 1 || t < 0 || t > 1)
    return std::nullopt;
  return a.start + s * u;
}

void
simplify(PlanLoop& loop)
{
  auto& e = loop.elements;
  e.erase(
      std::remove_if(e.begin(), e.end(),
                     [](const PlanElement& part) { return part.length() < touching; }),
      e.end());
  for (std::size_t k = 0; e.size() > 3 && k < e.size();) {
    PlanElement& next = e[(k + 1) % e.size()];
    const Eigen::Vector2d way = (e[k].end - e[k].start).normalized();
    if (e[k].isArc() || next.isArc() ||
        std::abs(cross(way, next.end - e[k].start)) > touching ||
        way.dot(next.end - next.start) < 0) {
      ++k;
      continue;
    }
    // The evidence of both, weighted by their lengths.
    const double share = e[k].length() / (e[k].length() + next.length());
    const auto mean = [&](double ElementEvidence::*part) {
      next.evidence.*part =
          share * (e[k].evidence.*part) + (1 - share) * (next.evidence.*part);
    };
    mean(&ElementEvidence::seen);
    mean(&ElementEvidence::hidden);
    mean(&ElementEvidence::opening);
    next.inliers += e[k].inliers;
    next.residual = std::max(next.residual, e[k].residual);
    next.start = e[k].start;
    e.erase(e.begin() + static_cast<std::ptrdiff_t>(k));
  }
}

SharedWall
longestWall(const PlanRoom& room, const PlanRoom& other)
{
  constexpr double thickest = 0.6;
  constexpr double parallel = 0.0872; // sine of 5 degrees
  SharedWall best;
  for (std::size_t a = 0; a < room.boundary.elements.size(); ++a)
    for (std::size_t b = 0; b < other.boundary.elements.size(); ++b) {
      const PlanElement& near = room.boundary.elements[a];
      const PlanElement& far = other.boundary.elements[b];
      if (near.isArc() || far.isArc())
        continue;
      const Eigen::Vector2d way = (near.end - near.start).normalized();
      const Eigen::Vector2d back = (far.end - far.start).normalized();
      const double off = cross(far.pointAt(far.length() / 2) - near.start, way);
      if (way.dot(back) > 0 || std::abs(cross(way, back)) > parallel ||
          off < -touching || off > thickest)
        continue;
      const double from = std::max(0.0, (far.end - near.start).dot(way));
      const double to = std::min(near.length(), (far.start - near.start).dot(way));
      if (to - from > best.to - best.from)
        best = {a, b, from, to};
    }
  return best;
}

void
appendAround(const PlanLoop& loop,
             std::size_t k,
             double s,
             double t,
             std::vector<PlanElement>& elements)
{
  const std::vector<PlanElement>& all = loop.elements;
  elements.push_back(all[k].part(s, all[k].length()));
  for (std::size_t i = 1; i < all.size(); ++i)
    elements.push_back(all[(k + i) % all.size()]);
  elements.push_back(all[k].part(0, t));
}

std::string
meetAgain(const std::vector<PlanElement>& lines, PlanLoop& loop)
{
  const std::size_t n = lines.size();
  std::vector<Eigen::Vector2d> corners(n); // at the start of each
  for (std::size_t k = 0; k < n; ++k) {
    const PlanElement& before = lines[(k + n - 1) % n];
    const PlanElement& after = lines[k];
    corners[k] = loop.elements[k].start;
    if (before.isArc() || after.isArc()) {
      if (before.distance(corners[k]) > touching ||
          after.distance(corners[k]) > touching)
        return "a wall beside an arc cannot be moved";
      continue;
    }
    const Eigen::Vector2d u = after.end - after.start;
    const Eigen::Vector2d v = before.end - before.start;
    const double area = cross(u, v);
    if (std::abs(area) > 1e-3 * u.norm() * v.norm())
      corners[k] = after.start + cross(before.start - after.start, v) / area * u;
    else if (std::abs(cross(u.normalized(), before.end - after.start)) > touching)
      return "it would no longer meet the wall beside it, which is parallel";
  }
  for (std::size_t k = 0; k < n; ++k) {
    PlanElement& element = loop.elements[k];
    const Eigen::Vector2d end = corners[(k + 1) % n];
    if (!element.isArc() && (end - corners[k]).dot(lines[k].end - lines[k].start) <= 0)
      return "wall " + std::to_string(k + 1) + " would vanish";
    element.start = corners[k];
    element.end = end;
  }
  return {};
}

std::string
outlineProblem(const PlanLoop& loop)
{
  constexpr double chord = 0.005;
  if (loop.elements.empty())
    return "is empty";
  if (loop.area() <= 0)
    return "is clockwise";
  const std::vector<Eigen::Vector2d> corners = loop.polygon(chord);
  const std::size_t n = corners.size();
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = a + 2; b < n; ++b) {
      if (a == 0 && b + 1 == n)
        continue;
      if (const auto at = crossing(segment(corners[a], corners[a + 1]),
                                   segment(corners[b], corners[(b + 1) % n])))
        return "crosses itself near (" + numberText(at->x()) + ", " +
               numberText(at->y()) + ")";
    }
  return {};
}

} // namespace pcl::sedr
