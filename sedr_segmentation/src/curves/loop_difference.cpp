// SPDX-License-Identifier: BSD-3-Clause
#include "loop_difference.h"

#include "sedr_filters/src/base/exactness.h"

#include "sedr_filters/src/plan/plan_geometry.h"

#include "plan_curve.h"

#include <algorithm>
#include <cstddef>

namespace pcl::sedr {

namespace {

/** @brief Cut positions of every element of a loop, as distances along it. */
using Cuts = std::vector<std::vector<double>>;

void
findCuts(const PlanLoop& a, const PlanLoop& b, Cuts& cuts_a, Cuts& cuts_b)
{
  cuts_a.resize(a.elements.size());
  cuts_b.resize(b.elements.size());
  for (std::size_t i = 0; i < a.elements.size(); ++i)
    for (std::size_t j = 0; j < b.elements.size(); ++j) {
      const PlanElement& e = a.elements[i];
      const PlanElement& f = b.elements[j];
      for (const auto& p : intersections(carrierOf(e), carrierOf(f)))
        if (e.distance(p) < same_point && f.distance(p) < same_point) {
          cuts_a[i].push_back(e.project(p));
          cuts_b[j].push_back(f.project(p));
        }
    }
}

/** @brief Returns the elements of a loop, divided at the cuts. */
std::vector<PlanElement>
partsOf(const PlanLoop& loop, const Cuts& cuts)
{
  std::vector<PlanElement> parts;
  for (std::size_t i = 0; i < loop.elements.size(); ++i) {
    const PlanElement& e = loop.elements[i];
    std::vector<double> at = cuts[i];
    at.push_back(0);
    at.push_back(e.length());
    std::sort(at.begin(), at.end());
    for (std::size_t k = 0; k + 1 < at.size(); ++k)
      if (at[k + 1] - at[k] > same_point)
        parts.push_back(at.size() == 2 ? e : e.part(at[k], at[k + 1]));
  }
  return parts;
}

/** @brief Returns the parts whose midpoint lies inside a loop. */
std::vector<PlanElement>
within(const std::vector<PlanElement>& parts, const PlanLoop& loop)
{
  std::vector<PlanElement> kept;
  for (const auto& e : parts) {
    const Eigen::Vector2d middle = e.pointAt(e.length() / 2);
    if (loop.distance(middle) >= same_point && loop.contains(middle))
      kept.push_back(e);
  }
  return kept;
}

/** @brief Returns the parts of a counter-clockwise loop whose inner side lies inside
 * (or outside) another loop. This also decides parts that coincide. */
std::vector<PlanElement>
onSide(const std::vector<PlanElement>& parts, const PlanLoop& other, bool is_inside)
{
  std::vector<PlanElement> kept;
  for (const auto& e : parts) {
    const double middle = e.length() / 2;
    if (other.contains(e.pointAt(middle) + 2 * same_point * e.normalAt(middle)) ==
        is_inside)
      kept.push_back(e);
  }
  return kept;
}

/** @brief Joins parts end to start into closed loops, largest first. */
std::vector<PlanLoop>
largestFirst(std::vector<PlanElement> parts)
{
  constexpr double slack = 100 * same_point;
  std::vector<PlanLoop> loops;
  while (!parts.empty()) {
    PlanLoop loop;
    loop.elements.push_back(parts.back());
    parts.pop_back();
    while ((loop.elements.back().end - loop.elements.front().start).norm() > slack) {
      const Eigen::Vector2d end = loop.elements.back().end;
      const auto next =
          std::find_if(parts.begin(), parts.end(), [&](const PlanElement& e) {
            return (e.start - end).norm() <= slack;
          });
      if (next == parts.end())
        break;
      loop.elements.push_back(*next);
      loop.elements.back().start = end;
      parts.erase(next);
    }
    if ((loop.elements.back().end - loop.elements.front().start).norm() > slack)
      continue; // an open end
    loop.elements.back().end = loop.elements.front().start;
    loops.push_back(std::move(loop));
  }
  std::stable_sort(
      loops.begin(), loops.end(),
      [](const PlanLoop& a, const PlanLoop& b) { return a.area() > b.area(); });
  return loops;
}

/** @brief Removes the inliers and evidence of elements. */
std::vector<PlanElement>
withoutInliers(std::vector<PlanElement> elements)
{
  for (PlanElement& e : elements) {
    e.inliers = 0;
    e.residual = 0;
    e.evidence = {};
    e.accuracy = {};
  }
  return elements;
}

/** @brief Returns an element shifted by `by` metres to the right. */
PlanElement
shifted(const PlanElement& e, double by)
{
  PlanElement moved = e;
  moved.start -= by * e.normalAt(0);
  moved.end -= by * e.normalAt(e.length());
  if (e.isArc())
    moved.radius += e.counter_clockwise ? by : -by;
  return moved;
}

/** @brief Returns the loops of what a loop has inside, or outside, of another one. */
std::vector<PlanLoop>
clipped(const PlanLoop& loop, const PlanLoop& other, bool is_inside)
{
  Cuts cuts_loop;
  Cuts cuts_other;
  findCuts(loop, other, cuts_loop, cuts_other);
  std::vector<PlanElement> parts = onSide(partsOf(loop, cuts_loop), other, is_inside);
  PlanLoop sides{withoutInliers(within(partsOf(other, cuts_other), loop))};
  if (!is_inside)
    sides = reversed(sides);
  parts.insert(parts.end(), sides.elements.begin(), sides.elements.end());
  return largestFirst(std::move(parts));
}

} // namespace

std::pair<std::vector<PlanElement>, std::vector<PlanElement>>
partsInside(const PlanLoop& first, const PlanLoop& second)
{
  Cuts cuts_first;
  Cuts cuts_second;
  findCuts(first, second, cuts_first, cuts_second);
  return {within(partsOf(first, cuts_first), second),
          within(partsOf(second, cuts_second), first)};
}

PlanLoop
widened(const PlanLoop& loop, double by)
{
  std::vector<PlanElement> moved;
  for (const auto& e : loop.elements)
    if (!e.isArc() || e.radius > (e.counter_clockwise ? -by : by))
      moved.push_back(shifted(e, by));
  const double reach = 4 * std::abs(by);
  PlanLoop wide;
  for (std::size_t i = 0; i < moved.size(); ++i) {
    PlanElement& next = moved[(i + 1) % moved.size()];
    wide.elements.push_back(moved[i]);
    PlanElement& e = wide.elements.back();
    if (moved.size() == 1)
      break;
    const Eigen::Vector2d end = e.end;
    const Eigen::Vector2d start = next.start;
    if ((end - start).norm() < same_point) {
      e.end = start;
      continue;
    }
    double nearest = reach;
    for (const auto& p : intersections(carrierOf(e), carrierOf(next)))
      if (const double away = std::max((p - end).norm(), (p - start).norm());
          away < nearest) {
        nearest = away;
        e.end = p;
      }
    if (nearest == reach)
      wide.elements.push_back(segment(end, start));
    else if (i + 1 < moved.size())
      next.start = e.end;
    else
      wide.elements.front().start = e.end;
  }
  return wide;
}

std::vector<PlanLoop>
difference(const PlanLoop& loop, const PlanLoop& cutter)
{
  return clipped(loop, cutter, false);
}

std::vector<PlanLoop>
intersection(const PlanLoop& loop, const PlanLoop& other)
{
  return clipped(loop, other, true);
}

} // namespace pcl::sedr
