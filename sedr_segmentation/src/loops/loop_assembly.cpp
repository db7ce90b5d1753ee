// SPDX-License-Identifier: BSD-3-Clause
#include "loop_assembly.h"

#include "loop_curve.h"
#include "loop_proposals.h"

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

/** @brief Returns whether an element goes backwards along its run, or much farther than
 * its samples. */
bool
isWrong(const LoopContour& contour,
        const Run& run,
        const PlanElement& e,
        double spacing)
{
  const std::size_t n = contour.samples.size();
  const double length = static_cast<double>(run.length) * spacing;
  if (e.isArc()) {
    constexpr double spare = 0.4; // metres
    return e.length() > 1.5 * length + spare;
  }
  const LoopSample& middle = contour.samples[(run.first + run.length / 2) % n];
  const Eigen::Vector2d tangent(-middle.normal.y(), middle.normal.x());
  const Eigen::Vector2d way = contour.samples[(run.first + run.length - 1) % n].place -
                              contour.samples[run.first].place + 1e-3 * tangent;
  constexpr double spare = 1.5; // metres
  return (run.end - run.start).dot(way) < 0 ||
         (run.end - run.start).norm() > 2 * length + spare;
}

/** @brief A straight part of an element. */
struct Edge {
  Eigen::Vector2d a;
  Eigen::Vector2d b;
  std::size_t element;
};

std::vector<Edge>
edgesOf(const PlanLoop& loop)
{
  constexpr double chord = 0.1; // metres, of an arc
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < loop.elements.size(); ++i) {
    const PlanElement& e = loop.elements[i];
    const std::size_t parts =
        e.isArc()
            ? std::max<std::size_t>(4, static_cast<std::size_t>(e.length() / chord))
            : 1;
    Eigen::Vector2d from = e.start;
    for (std::size_t k = 1; k <= parts; ++k) {
      const Eigen::Vector2d to = k == parts
                                     ? e.end
                                     : e.pointAt(e.length() * static_cast<double>(k) /
                                                 static_cast<double>(parts));
      edges.push_back({from, to, i});
      from = to;
    }
  }
  return edges;
}

/** @brief Finds the first place where two elements of a loop cross that are not
 * neighbours there.
 * @return the elements, in order; equal if there is none */
std::pair<std::size_t, std::size_t>
crossingOf(const PlanLoop& loop, Eigen::Vector2d& place)
{
  const std::vector<Edge> edges = edgesOf(loop);
  const auto cross = [](const Eigen::Vector2d& u, const Eigen::Vector2d& v) {
    return u.x() * v.y() - u.y() * v.x();
  };
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t j = i + 2; j < edges.size(); ++j) {
      const Edge& e = edges[i];
      const Edge& f = edges[j];
      if (e.element == f.element || (i == 0 && j + 1 == edges.size()))
        continue;
      if (std::max(e.a.x(), e.b.x()) < std::min(f.a.x(), f.b.x()) ||
          std::max(f.a.x(), f.b.x()) < std::min(e.a.x(), e.b.x()) ||
          std::max(e.a.y(), e.b.y()) < std::min(f.a.y(), f.b.y()) ||
          std::max(f.a.y(), f.b.y()) < std::min(e.a.y(), e.b.y()))
        continue;
      const double turn = cross(e.b - e.a, f.b - f.a);
      if (cross(e.b - e.a, f.a - e.a) * cross(e.b - e.a, f.b - e.a) > 0 ||
          cross(f.b - f.a, e.a - f.a) * cross(f.b - f.a, e.b - f.a) > 0)
        continue;
      place = turn == 0 ? f.a : e.a + cross(f.a - e.a, f.b - f.a) / turn * (e.b - e.a);
      Eigen::Vector2d exact;
      constexpr double near = 0.05; // metres: chords are this near to their arcs
      if (meet(carrierOf(loop.elements[e.element]), carrierOf(loop.elements[f.element]),
               place, exact) &&
          (exact - place).norm() < near)
        place = exact;
      return {e.element, f.element};
    }
  return {0, 0};
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
assembleLoop(LoopSolver& solver, std::size_t c)
{
  constexpr int max_tries = 4;
  constexpr double same_place = 1e-4; // metres
  const LoopContour& contour = solver.contour(c);
  const std::size_t n = contour.samples.size();
  if (n == 0 || solver.labels(c).size() != n)
    return {};
  const double spacing =
      (contour.samples[1 % n].place - contour.samples[0].place).norm();
  const double length = spacing * static_cast<double>(n);
  for (int attempt = 0; attempt < max_tries; ++attempt) {
    const std::vector<Run> runs = runsOf(solver, c);
    if (runs.size() == 1) {
      const PlanCurve& curve = solver.candidate(solver.labels(c).front()).curve();
      const bool is_around =
          curve.isCircle() && std::abs(2 * M_PI * curve.radius - length) < length / 2;
      return is_around ? circleLoop(contour, curve) : PlanLoop();
    }
    PlanLoop loop;
    std::vector<std::size_t> run_of; // of each element
    std::vector<std::uint8_t> is_bad(runs.size(), 0);
    for (std::size_t r = 0; r < runs.size(); ++r) {
      const PlanElement e =
          elementOf(contour, runs[r], solver.candidate(runs[r].label));
      is_bad[r] = isWrong(contour, runs[r], e, spacing);
      if (e.isArc() || (e.end - e.start).norm() > same_place) {
        loop.elements.push_back(e);
        run_of.push_back(r);
      }
      const Run& next = runs[(r + 1) % runs.size()];
      if ((next.start - runs[r].end).norm() > 1e-9) {
        PlanElement piece;
        piece.start = runs[r].end;
        piece.end = next.start;
        loop.elements.push_back(piece);
        run_of.push_back(r);
      }
    }
    // Elements that were too short leave gaps: their neighbours meet there.
    for (std::size_t i = 0; i < loop.elements.size(); ++i)
      loop.elements[(i + 1) % loop.elements.size()].start = loop.elements[i].end;
    if (attempt + 1 == max_tries || std::count(is_bad.begin(), is_bad.end(), 1) == 0) {
      loop = withoutCrossings(std::move(loop));
      const bool is_right_way = (loop.area() > 0) != contour.is_hole;
      const bool has_area = std::abs(loop.area()) > spacing * spacing;
      return loop.elements.size() > 1 && is_right_way && has_area ? loop : PlanLoop();
    }
    std::vector<std::pair<std::size_t, std::size_t>> places;
    for (std::size_t r = 0; r < runs.size(); ++r)
      for (std::size_t k = 0; is_bad[r] && k < runs[r].length; ++k)
        places.push_back({(runs[r].first + k) % n, runs[r].label});
    solver.block(c, places);
  }
  return {};
}

} // namespace pcl::sedr
