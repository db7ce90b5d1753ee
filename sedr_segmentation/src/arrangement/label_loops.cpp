// SPDX-License-Identifier: BSD-3-Clause
#include "label_loops.h"

#include "../curves/contour.h"
#include "../curves/fitted_curve.h"
#include "border_pieces.h"
#include "sedr_filters/src/base/exactness.h"
#include <pcl/sedr_filters/plan_editor.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief A stretch of a loop on one curve, of pieces. */
struct Run {
  PlanCurve curve;
  std::uint32_t line;
  std::vector<Eigen::Vector2d> places; ///< ends of its pieces
  Eigen::Vector2d end;                 ///< where the next one begins
  bool is_chord = false;               ///< in place of an arc of its curve

  bool isWithin(const PlanCurve& other, double distance) const
  {
    for (std::size_t k = 0; k + 1 < places.size(); ++k)
      for (const Eigen::Vector2d& p : {places[k], middleOf(k), places[k + 1]})
        if (other.distance(p) >= distance)
          return false;
    return true;
  }

  Eigen::Vector2d middleOf(std::size_t piece) const
  {
    return (places[piece] + places[piece + 1]) / 2;
  }

  /** @brief Returns the area between it and another curve, about. */
  double areaTo(const PlanCurve& other) const
  {
    double area = 0;
    for (std::size_t k = 0; k + 1 < places.size(); ++k)
      area += other.distance(middleOf(k)) * (places[k + 1] - places[k]).norm();
    return area;
  }

  /** @brief Returns the angle by which it turns about the centre of its circle. */
  double swept() const
  {
    double angle = 0;
    for (std::size_t k = 0; k + 1 < places.size(); ++k) {
      const Eigen::Vector2d a = places[k] - curve.point;
      const Eigen::Vector2d b = places[k + 1] - curve.point;
      angle += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
    }
    return angle;
  }
};

constexpr double apart = 0.03;     // metres, of curves that nearly touch
constexpr double near_joint = 0.1; // metres, about where curves meet
constexpr double min_area = 0.01;  // square metres: 10 cm by 10 cm

/** @brief Finds where two curves nearly touch, near a place.
 * @return whether they do */
bool
touch(const PlanCurve& a,
      const PlanCurve& b,
      const Eigen::Vector2d& near,
      Eigen::Vector2d& place)
{
  const PlanCurve& arc = a.isCircle() ? a : b;
  if (!arc.isCircle())
    return false;
  const Eigen::Vector2d foot = (a.isCircle() ? b : a).project(arc.point);
  place = arc.project(foot);
  return (place - foot).norm() < apart &&
         (place - near).norm() < 2 * std::sqrt(2 * apart * arc.radius);
}

/** @brief Returns where two runs meet near a place: where their curves meet or touch,
 * else the place on the arc, the same for those on the other side. */
Eigen::Vector2d
jointOf(const Run& before, const Run& after, const Eigen::Vector2d& near)
{
  const PlanCurve& a =
      std::min(before.line, after.line) == before.line ? before.curve : after.curve;
  const PlanCurve& b = &a == &before.curve ? after.curve : before.curve;
  if (!a.isCircle() && !b.isCircle())
    return near;
  Eigen::Vector2d joint;
  if (touch(a, b, near, joint) ||
      (meet(a, b, near, joint) && (joint - near).norm() < near_joint))
    return joint;
  return (a.isCircle() ? a : b).project(near);
}

/** @brief Joins the pieces of a loop that follow each other on one curve.
 * @param straight circles of which each piece stays a run of its own, a segment */
std::vector<Run>
runsOf(const std::vector<Piece>& pieces,
       const std::vector<PlanCurve>& curves,
       const PlaceNumbers& places,
       const std::set<std::uint32_t>& straight)
{
  const auto isOneRun = [&](const Piece& a, const Piece& b) {
    return a.line == b.line && straight.count(a.line) == 0;
  };
  const std::size_t n = pieces.size();
  std::size_t first = 0; // where a run begins
  while (first + 1 < n && isOneRun(pieces[(first + n - 1) % n], pieces[first]))
    ++first;
  std::vector<Run> runs;
  for (std::size_t k = 0; k < n; ++k) {
    const Piece& piece = pieces[(first + k) % n];
    const Eigen::Vector2d& from = places.at(piece.from);
    const Eigen::Vector2d& to = places.at(piece.to);
    if (k == 0 || !isOneRun(pieces[(first + k - 1) % n], piece)) {
      const bool is_chord = straight.count(piece.line) > 0;
      runs.push_back({is_chord ? lineThrough(from, to) : curves[piece.line],
                      piece.line,
                      {from},
                      to,
                      is_chord});
    }
    runs.back().places.push_back(to);
    runs.back().end = to;
  }
  return runs;
}

/** @brief Gives runs that part hardly any area from the curve before and after them to
 * that, those first that part least: as where another curve touches it. */
void
bridgeTouching(std::vector<Run>& runs)
{
  while (runs.size() > 1) {
    const std::size_t n = runs.size();
    const auto at = [&](std::size_t k) -> Run& { return runs[k % n]; };
    double smallest = min_area;
    std::size_t first = n; // with the curve
    std::size_t last = 0;
    for (std::size_t i = 0; i < n; ++i) {
      double area = 0;
      std::size_t k = i + 1;
      for (; !at(i).is_chord && at(k).line != at(i).line && area < smallest; ++k)
        area += n == 2 && at(i).curve.isCircle() && at(k).isWithin(at(i).curve, apart)
                    ? 0
                    : at(k).areaTo(at(i).curve);
      if (k > i + 1 && area < smallest) {
        smallest = area;
        first = i;
        last = k;
      }
    }
    if (first == n)
      return;
    std::rotate(runs.begin(), runs.begin() + static_cast<std::ptrdiff_t>(first),
                runs.end());
    last -= first;
    Run& run = runs[0];
    for (std::size_t k = 1; k <= std::min(last, n - 1); ++k) {
      run.places.insert(run.places.end(), runs[k].places.begin() + 1,
                        runs[k].places.end());
      run.end = runs[k].end;
    }
    runs.erase(runs.begin() + 1,
               runs.begin() + 1 + static_cast<std::ptrdiff_t>(std::min(last, n - 1)));
  }
}

/** @brief Moves the ends of runs to where their curves meet, and leaves out those that
 * then have no length or run back, and short ones between curves that nearly touch. */
void
closeJoints(std::vector<Run>& runs)
{
  const auto at = [&](std::size_t k) -> Run& { return runs[k % runs.size()]; };
  for (std::size_t k = 0; runs.size() > 1 && k < runs.size(); ++k)
    at(k).end = jointOf(at(k), at(k + 1), at(k).end);
  for (std::size_t k = 0; runs.size() > 1 && k < runs.size();) {
    const std::size_t before = k + runs.size() - 1;
    const Eigen::Vector2d way = at(k).end - at(before).end;
    const Eigen::Vector2d was = at(k).places.back() - at(k).places.front();
    Eigen::Vector2d joint = (at(k).end + at(before).end) / 2;
    const bool is_round = at(k).curve.isCircle() && std::abs(at(k).swept()) > M_PI / 2;
    const bool is_gone =
        !is_round &&
        (way.norm() < same_line || way.dot(was) <= 0 ||
         (runs.size() > 2 && way.norm() < near_joint &&
          touch(at(before).curve, at(k + 1).curve, at(before).end, joint)));
    if (!is_gone) {
      ++k;
      continue;
    }
    at(before).end = jointOf(at(before), at(k + 1), joint);
    runs.erase(runs.begin() + static_cast<std::ptrdiff_t>(k));
    k = 0;
  }
}

/** @brief Returns the element of a run. An arc whose ends are not on its circle gets
 * another centre. */
PlanElement
elementOf(const Run& run, const Eigen::Vector2d& start)
{
  PlanElement e;
  e.start = start;
  e.end = run.end;
  e.inliers = 1;
  if (!run.curve.isCircle())
    return e;
  const double swept = run.swept();
  e.counter_clockwise = swept > 0;
  e.centre = run.curve.point;
  e.radius = run.curve.radius;
  if (std::max(run.curve.distance(start), run.curve.distance(run.end)) < same_point)
    return e;
  const Eigen::Vector2d half = (e.end - e.start) / 2;
  e.radius = std::max(e.radius, half.norm());
  const double up = std::sqrt(e.radius * e.radius - half.squaredNorm());
  const bool is_left = (swept > 0) == (std::abs(swept) < M_PI);
  e.centre = e.start + half + (is_left ? up : -up) * leftOf(half.normalized());
  return e;
}

/** @brief Returns the loop of runs; empty if it is none. */
PlanLoop
loopOf(std::vector<Run> runs)
{
  std::vector<Eigen::Vector2d> corners;
  for (const Run& run : runs)
    corners.insert(corners.end(), run.places.begin() + 1, run.places.end());
  closeJoints(runs);
  PlanLoop loop;
  if (runs.size() == 1) {
    if (!runs[0].curve.isCircle())
      return loop;
    runs[0].end = runs[0].curve.project(runs[0].places.front());
  }
  for (std::size_t k = 0; k < runs.size(); ++k)
    loop.elements.push_back(
        elementOf(runs[k], runs[(k + runs.size() - 1) % runs.size()].end));
  if (runs.size() == 1 && 2 * std::abs(signedArea(corners)) < std::abs(loop.area()))
    loop.elements.clear(); // a sliver between an arc and its chord, no circle
  return loop;
}

bool
isOutline(const PlanLoop& loop)
{
  return outlineProblem(loop.area() < 0 ? reversed(loop) : loop).empty();
}

/** @brief The loops of all labels, which share their lines and arcs. */
class LabelOutlines {
public:
  LabelOutlines(const std::vector<PlanCurve>& curves)
      : curves_(curves)
  {}

  /** @brief Follows the borders of a label. */
  void
  add(const std::vector<CellBorder>& borders, const std::vector<int>& labels, int label)
  {
    std::vector<Piece> pieces;
    for (const CellBorder& border : borders) {
      const bool is_left = labels[border.left] == label;
      if (is_left == (labels[border.right] == label))
        continue;
      const std::size_t a = places_.numberOf(border.start);
      const std::size_t b = places_.numberOf(border.end);
      if (a != b)
        pieces.push_back({is_left ? a : b, is_left ? b : a, border.line});
    }
    std::vector<Outline>& all = of_label_.emplace_back();
    for (std::vector<Piece>& loop : loopsOf(pieces, places_)) {
      const double area = areaOf(loop, places_);
      if (std::abs(area) > min_area)
        all.push_back({std::move(loop), area, {}});
    }
  }

  /** @brief Returns the loops of each label. Where arcs cross something that their
   * chords do not, all loops get the chords. */
  std::vector<LabelLoops> found()
  {
    for (bool is_done = false; !is_done;) {
      const std::size_t before = straight_.size();
      for (std::vector<Outline>& all : of_label_)
        for (Outline& outline : all) {
          outline.loop = loopOfPieces(outline.pieces);
          if (!outline.loop.elements.empty() && !isOutline(outline.loop))
            straighten(outline.pieces);
        }
      is_done = straight_.size() == before;
    }
    std::vector<LabelLoops> loops;
    for (const std::vector<Outline>& all : of_label_)
      loops.push_back(loopsOfLabel(all));
    return loops;
  }

private:
  struct Outline {
    std::vector<Piece> pieces;
    double area;
    PlanLoop loop;
  };

  PlanLoop loopOfPieces(const std::vector<Piece>& pieces) const
  {
    const std::vector<Run> runs = runsOf(pieces, curves_, places_, straight_);
    std::vector<Run> bridged = runs;
    bridgeTouching(bridged);
    PlanLoop loop = loopOf(std::move(bridged));
    return isOutline(loop) ? loop : loopOf(runs);
  }

  /** @brief Replaces one circle of a loop by chords if that is enough, else all. */
  void straighten(const std::vector<Piece>& pieces)
  {
    std::set<std::uint32_t> circles;
    for (const Piece& piece : pieces)
      if (curves_[piece.line].isCircle() && straight_.count(piece.line) == 0)
        circles.insert(piece.line);
    for (const std::uint32_t circle : circles) {
      straight_.insert(circle);
      if (isOutline(loopOfPieces(pieces)))
        return;
      straight_.erase(circle);
    }
    straight_.insert(circles.begin(), circles.end());
    if (!isOutline(loopOfPieces(pieces)))
      for (const std::uint32_t circle : circles)
        straight_.erase(circle); // they do not help
  }

  static LabelLoops loopsOfLabel(const std::vector<Outline>& all)
  {
    LabelLoops found;
    double largest = 0;
    for (const Outline& outline : all)
      if (outline.area < 0)
        found.holes.push_back(outline.loop);
      else if (outline.area > largest) {
        largest = outline.area;
        found.outer = outline.loop;
      }
    const auto isOutside = [&](const PlanLoop& hole) {
      return hole.elements.empty() ||
             !found.outer.contains(hole.elements.front().start);
    };
    found.holes.erase(std::remove_if(found.holes.begin(), found.holes.end(), isOutside),
                      found.holes.end());
    return found;
  }

  const std::vector<PlanCurve>& curves_;
  PlaceNumbers places_;
  std::vector<std::vector<Outline>> of_label_;
  std::set<std::uint32_t> straight_; ///< circles of which all pieces are segments
};

} // namespace

std::vector<LabelLoops>
labelLoops(const std::vector<CellBorder>& borders,
           const std::vector<int>& labels,
           int max_label,
           const std::vector<PlanCurve>& curves)
{
  LabelOutlines outlines(curves);
  for (int label = 1; label <= max_label; ++label)
    outlines.add(borders, labels, label);
  return outlines.found();
}

} // namespace pcl::sedr
