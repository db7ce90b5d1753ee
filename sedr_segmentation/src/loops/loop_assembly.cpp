// SPDX-License-Identifier: BSD-3-Clause
#include "loop_assembly.h"

#include "../curves/contour.h"
#include "../curves/fitted_curve.h"
#include "loop_proposals.h"
#include "sedr_filters/src/base/exactness.h"
#include "sedr_filters/src/plan/plan_segment.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

namespace {

/** @brief A run of samples with one label, and where its curve begins and ends. */
struct Run {
  std::size_t label = 0;
  std::size_t first = 0;
  std::size_t length = 0;
  Eigen::Vector2d start = Eigen::Vector2d::Zero();
  Eigen::Vector2d end = Eigen::Vector2d::Zero();
};

std::vector<Run>
runsOf(const LoopSolver& solver, std::size_t c)
{
  const LoopContour& contour = solver.contour(c);
  const std::size_t n = contour.samples.size();
  std::vector<Run> runs;
  for (const auto& [first, length] : labelRuns(solver.labels(c)))
    runs.push_back({solver.labels(c)[first], first, length});
  for (std::size_t r = 0; r < runs.size(); ++r) {
    Run& run = runs[r];
    Run& next = runs[(r + 1) % runs.size()];
    const Eigen::Vector2d near = (contour.samples[(next.first + n - 1) % n].place +
                                  contour.samples[next.first].place) /
                                 2;
    const LoopJoint joint =
        solver.joint(solver.candidate(run.label), solver.candidate(next.label), near);
    const bool is_piece = joint.kind == LoopJoint::Kind::Piece;
    run.end =
        is_piece ? solver.candidate(run.label).curve().project(near) : joint.place;
    next.start =
        is_piece ? solver.candidate(next.label).curve().project(near) : joint.place;
  }
  return runs;
}

/** @brief Returns whether a circle is followed counter-clockwise along a run. */
bool
isCounterClockwise(const LoopContour& contour, const Run& run, const PlanCurve& circle)
{
  const std::size_t n = contour.samples.size();
  double turn = 0;
  for (std::size_t k = 0; k + 1 < run.length; ++k) {
    const Eigen::Vector2d a = contour.samples[(run.first + k) % n].place - circle.point;
    const Eigen::Vector2d b =
        contour.samples[(run.first + k + 1) % n].place - circle.point;
    turn += a.x() * b.y() - a.y() * b.x();
  }
  if (run.length < 2) { // by the normal: the room is on the left
    const LoopSample& sample = contour.samples[run.first];
    return sample.normal.dot(sample.place - circle.point) > 0;
  }
  return turn > 0;
}

PlanElement
elementOf(const LoopContour& contour, const Run& run, const LoopCandidate& candidate)
{
  PlanElement e;
  e.start = run.start;
  e.end = run.end;
  const std::size_t n = contour.samples.size();
  for (std::size_t k = 0; k < run.length; ++k)
    e.inliers += contour.samples[(run.first + k) % n].points;
  if (candidate.curve().isCircle()) {
    e.centre = candidate.curve().point;
    e.radius = candidate.curve().radius;
    e.counter_clockwise = isCounterClockwise(contour, run, candidate.curve());
  }
  return e;
}

/** @brief Finds the first place where two elements of a loop cross that are not
 * neighbours there.
 * @return the elements, in order; equal if there is none */
std::pair<std::size_t, std::size_t>
crossingOf(const PlanLoop& loop, Eigen::Vector2d& place)
{
  constexpr double step = 0.1; // metres, along arcs
  std::vector<Eigen::Vector2d> corners;
  std::vector<std::size_t> element; // of the edge from each corner on
  for (std::size_t i = 0; i < loop.elements.size(); ++i) {
    const PlanElement& e = loop.elements[i];
    const auto parts = static_cast<std::size_t>(e.isArc() ? 4 + e.length() / step : 1);
    for (std::size_t k = 0; k < parts; ++k) {
      corners.push_back(
          e.pointAt(e.length() * static_cast<double>(k) / static_cast<double>(parts)));
      element.push_back(i);
    }
  }
  const auto [i, j] = crossingEdges(corners);
  if (i == j)
    return {0, 0};
  place = corners[j];
  meet(lineThrough(corners[i], corners[i + 1]),
       lineThrough(corners[j], corners[(j + 1) % corners.size()]), place, place);
  return {element[i], element[j]};
}

/** @brief Cuts a loop where it crosses itself and keeps the larger part, until it does
 * not cross itself. */
PlanLoop
withoutCrossings(PlanLoop loop)
{
  for (Eigen::Vector2d place; !loop.elements.empty();) {
    const auto [i, j] = crossingOf(loop, place);
    if (i == j)
      break;
    PlanLoop inner; // from the crossing on element i to that on element j
    PlanLoop outer;
    for (std::size_t k = 0; k < loop.elements.size(); ++k) {
      PlanElement e = loop.elements[k];
      if (k <= i || k >= j) {
        PlanElement part = e;
        (k == i ? part.end : part.start) = k == i || k == j ? place : e.start;
        outer.elements.push_back(part);
      }
      if (k >= i && k <= j) {
        (k == i ? e.start : e.end) = k == i || k == j ? place : e.end;
        inner.elements.push_back(e);
      }
    }
    for (PlanLoop* part : {&inner, &outer})
      part->elements.erase(
          std::remove_if(part->elements.begin(), part->elements.end(),
                         [](const PlanElement& e) { return e.start == e.end; }),
          part->elements.end());
    if (inner.elements.empty() || outer.elements.empty())
      break; // elements that run along each other: nothing to cut
    loop = std::abs(inner.area()) > std::abs(outer.area()) ? inner : outer;
  }
  return loop;
}

/** @brief Returns a loop that is one circle. */
PlanLoop
circleLoop(const LoopContour& contour, const PlanCurve& circle)
{
  PlanElement e;
  e.start = e.end = circle.point + circle.radius * Eigen::Vector2d::UnitX();
  e.centre = circle.point;
  e.radius = circle.radius;
  e.counter_clockwise = !contour.is_hole;
  for (const LoopSample& sample : contour.samples)
    e.inliers += sample.points;
  PlanLoop loop;
  loop.elements.push_back(e);
  return loop;
}

} // namespace

PlanLoop
assembleLoop(const LoopSolver& solver, std::size_t c)
{
  const LoopContour& contour = solver.contour(c);
  const std::size_t n = contour.samples.size();
  if (n == 0 || solver.labels(c).size() != n)
    return {};
  const double spacing =
      (contour.samples[1 % n].place - contour.samples[0].place).norm();
  const std::vector<Run> runs = runsOf(solver, c);
  const auto longest =
      std::max_element(runs.begin(), runs.end(),
                       [](const Run& a, const Run& b) { return a.length < b.length; });
  const auto aloneOnLongest = [&] { // a circle all around
    const double length = spacing * static_cast<double>(n);
    const PlanCurve& curve = solver.candidate(longest->label).curve();
    const bool is_around =
        curve.isCircle() && std::abs(2 * M_PI * curve.radius - length) < length / 2;
    return is_around ? circleLoop(contour, curve) : PlanLoop();
  };
  if (runs.size() == 1)
    return aloneOnLongest();
  PlanLoop loop;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const PlanElement e = elementOf(contour, runs[r], solver.candidate(runs[r].label));
    if (e.isArc() || (e.end - e.start).norm() > same_line)
      loop.elements.push_back(e);
    const Run& next = runs[(r + 1) % runs.size()];
    if ((next.start - runs[r].end).norm() > same_place)
      loop.elements.push_back(segment(runs[r].end, next.start));
  }
  if (loop.elements.size() == 1)
    return aloneOnLongest();
  // Elements that were too short leave gaps: their neighbours meet there.
  for (std::size_t i = 0; i < loop.elements.size(); ++i)
    loop.elements[(i + 1) % loop.elements.size()].start = loop.elements[i].end;
  loop = withoutCrossings(std::move(loop));
  const bool is_right_way = (loop.area() > 0) != contour.is_hole;
  const bool has_area = std::abs(loop.area()) > spacing * spacing;
  return loop.elements.size() > 1 && is_right_way && has_area ? loop : PlanLoop();
}

} // namespace pcl::sedr
