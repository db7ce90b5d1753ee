// SPDX-License-Identifier: BSD-3-Clause
#include "plan_adjustment.h"

#include "../curves/contour.h"
#include "plan_ties.h"
#include "surface_fit.h"

#include "sedr_filters/src/base/exactness.h"
#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/base/quantiles.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <vector>

namespace pcl::sedr {

namespace {

using UnknownPair = std::pair<std::size_t, std::size_t>;

/** @brief Returns the point where two tangent curves touch. */
Eigen::Vector2d
touchOf(const PlanCurve& a, const PlanCurve& b)
{
  if (!a.isCircle() || !b.isCircle())
    return a.isCircle() ? b.project(a.point) : a.project(b.point);
  // Seen from the larger circle's centre, the point lies in the direction of the
  // smaller one's centre, beyond it if inside.
  return a.radius < b.radius ? b.project(a.point) : a.project(b.point);
}

class LoopBuilder {
public:
  LoopBuilder(const PlanUnknowns& plan,
              const std::vector<PlanTie>& ties,
              double farthest)
      : plan_(plan)
      , farthest_(farthest)
  {
    for (const PlanTie& tie : ties)
      if (tie.kind == PlanTieKind::Tangent)
        tangents_.insert(std::minmax(tie.a, tie.b));
  }

  /** @brief Rebuilds a loop; returns the indices of the elements at which it would
   * break. */
  std::vector<std::size_t> build(const UnknownLoop& loop, PlanLoop& result) const
  {
    result = *loop.loop;
    auto& elements = result.elements;
    const std::size_t n = elements.size();
    std::vector<std::size_t> broken;
    for (std::size_t i = 0; i < n; ++i) {
      Eigen::Vector2d corner;
      if (cornerOf(loop, i, corner)) {
        elements[i].start = corner;
        elements[(i + n - 1) % n].end = corner;
      }
      else
        broken.insert(broken.end(), {i, (i + n - 1) % n});
    }
    for (std::size_t i = 0; i < n && broken.empty(); ++i) {
      PlanElement& e = elements[i];
      const PlanElement& old = loop.loop->elements[i];
      const Unknown& u = plan_.all[loop.of_element[i]];
      if (e.isArc()) {
        e.centre = u.point;
        e.radius = u.radius;
      }
      const bool is_turned = e.isArc()
                                 ? std::abs(e.sweep() - old.sweep()) > 0.5
                                 : (e.end - e.start).dot(old.end - old.start) <= 0;
      if (is_turned || (e.length() < same_line && old.length() >= same_line))
        broken = {(i + n - 1) % n, i, (i + 1) % n};
    }
    if (broken.empty() && crossesItself(result.polygon(chord)) &&
        !crossesItself(loop.loop->polygon(chord)))
      for (std::size_t i = 0; i < n; ++i)
        broken.push_back(i);
    return broken;
  }

private:
  /** @brief Finds the start of an element.
   * @return false if the curves do not meet near the old corner */
  bool cornerOf(const UnknownLoop& loop, std::size_t i, Eigen::Vector2d& corner) const
  {
    const auto& elements = loop.loop->elements;
    const std::size_t n = elements.size();
    const Eigen::Vector2d& old = elements[i].start;
    const std::size_t a = loop.of_element[(i + n - 1) % n];
    const std::size_t b = loop.of_element[i];
    const PlanCurve before = plan_.all[a].curve();
    const PlanCurve after = plan_.all[b].curve();
    if (a == b) {
      corner = after.project(old);
      return (corner - old).norm() <= farthest_;
    }
    if (tangents_.count(std::minmax(a, b)) > 0) {
      // The place of a smooth joint along the curves is uncertain.
      corner = touchOf(before, after);
      return elements[i].distance(corner) <= farthest_ ||
             elements[(i + n - 1) % n].distance(corner) <= farthest_;
    }
    const double sine =
        std::abs(before.tangentAt(old).dot(leftOf(after.tangentAt(old))));
    double nearest = farthest_ / std::max(sine, 0.3);
    bool is_found = false;
    for (const Eigen::Vector2d& p : intersections(before, after)) {
      if ((p - old).norm() > nearest)
        continue;
      nearest = (p - old).norm();
      corner = p;
      is_found = true;
    }
    if (!is_found &&
        sine < 0.3) { // parts of one line, or with a step too low to be seen
      const Eigen::Vector2d on_after = after.project(old);
      corner = (on_after + before.project(on_after)) / 2;
      is_found = before.distance(on_after) < farthest_ / 2;
    }
    return is_found;
  }

  const PlanUnknowns& plan_;
  double farthest_;
  std::set<UnknownPair> tangents_;
};

/** @brief Rebuilds the loops of a plan on moved unknowns: corners are intersections of
 * neighbouring curves, or the points where tied curves touch.
 * @param are_kept unknowns that were not moved; loops of these alone do not change
 * @param farthest maximum move of a corner between square walls, metres
 * @return the unknowns at whose elements loops would break, i.e. cross themselves,
 * reverse an element or lose a corner. The plan is changed only if there are none. */
std::vector<std::size_t>
rebuildLoops(const PlanUnknowns& plan,
             const std::vector<PlanTie>& ties,
             const std::vector<bool>& are_kept,
             double farthest)
{
  const LoopBuilder builder(plan, ties, farthest);
  std::vector<std::size_t> broken;
  std::vector<PlanLoop> results(plan.loops.size());
  for (std::size_t l = 0; l < results.size(); ++l) {
    const std::vector<std::size_t>& of = plan.loops[l].of_element;
    const auto isKept = [&](std::size_t u) { return are_kept[u]; };
    if (std::all_of(of.begin(), of.end(), isKept)) {
      results[l] = *plan.loops[l].loop;
      continue;
    }
    std::vector<std::size_t> at;
    for (const std::size_t i : builder.build(plan.loops[l], results[l]))
      at.push_back(of[i]);
    if (std::all_of(at.begin(), at.end(), isKept) && !at.empty())
      at = of;
    broken.insert(broken.end(), at.begin(), at.end());
  }
  if (broken.empty())
    for (std::size_t l = 0; l < results.size(); ++l)
      *plan.loops[l].loop = std::move(results[l]);
  return broken;
}

/** @brief Returns the reason, an empty loop, why a plan cannot be adjusted, or "". */
std::string
emptyLoop(const PlanUnknowns& unknowns, const Floorplan& plan)
{
  for (const UnknownLoop& loop : unknowns.loops)
    if (loop.of_element.empty())
      return "room " + std::to_string(plan.rooms[loop.room].id) +
             " has a loop of 0 elements";
  return {};
}

/** @brief Limits the information to the accuracy of built surfaces. */
void
limitInformation(const AdjustmentParameters& parameters, Unknown& u)
{
  const double offset = parameters.accuracy;
  const double turn = offset * std::sqrt(3.0) / std::max(0.05, u.half);
  Eigen::Vector3d deviations(offset, turn, turn);
  if (u.kind == UnknownKind::Circle)
    deviations.setConstant(offset);
  else if (u.kind == UnknownKind::Line)
    deviations[2] = u.is_tilted ? offset : 0;
  Eigen::Matrix3d covariance = u.information.inverse();
  covariance += deviations.cwiseAbs2().asDiagonal().toDenseMatrix();
  u.information = covariance.inverse();
}

/** @brief Solves the ties. While that fails, as they contradict each other, the last
 * tangent goes, or the last tie if there is none; after 30 tries all. */
void
tie(std::vector<PlanTie>& ties, std::vector<Unknown>& unknowns)
{
  constexpr int max_tries = 30;
  for (int tries = 0; tries < max_tries && !ties.empty(); ++tries) {
    if (solveTies(ties, unknowns))
      return;
    // Tangents are the most demanding.
    const auto last = std::find_if(ties.rbegin(), ties.rend(), [](const PlanTie& t) {
      return t.kind == PlanTieKind::Tangent;
    });
    ties.erase(last == ties.rend() ? ties.end() - 1 : std::next(last).base());
  }
  ties.clear();
}

/** @brief Finds the distance within which 95 % of the points within reach of each
 * surface lie; each of its patches counts the same. */
void
measureDeviations(const PatchPoints& points,
                  const AdjustmentParameters& parameters,
                  std::vector<Unknown>& unknowns)
{
  parallelBlocks(
      unknowns.size(), 1, parameters.threads, [&](std::size_t u, std::size_t) {
        std::vector<Weighted> distances;
        const auto [first, last] = points.patchesOf(u);
        for (std::size_t p = first; p < last; ++p) {
          const std::size_t before = distances.size();
          for (const Eigen::Vector3f* at = points.begin(p); at != points.end(p); ++at)
            if (const double d = std::abs(unknowns[u].distance(at->cast<double>()));
                d < parameters.reach)
              distances.emplace_back(d, 0);
          for (std::size_t k = before; k < distances.size(); ++k)
            distances[k].second = 1 / static_cast<double>(distances.size() - before);
        }
        unknowns[u].deviation = weightedQuantile(std::move(distances), 0.95);
      });
}

} // namespace

AdjustmentReport
adjustPlan(Floorplan& plan,
           const PointView& raw,
           const std::vector<int>& indices,
           const AdjustmentParameters& parameters)
{
  constexpr int max_tries = 12;
  AdjustmentReport report;
  PlanUnknowns unknowns(plan, parameters);
  report.problem = emptyLoop(unknowns, plan);
  if (!report.problem.empty())
    return report;
  std::vector<Unknown> given = unknowns.all;
  const PatchPoints points(plan, unknowns, raw, indices, parameters);
  report.problem = points.problem();
  if (!report.problem.empty())
    return report;
  const ScanErrors errors = SurfaceFit(unknowns, points, parameters).run();
  report.noise = errors.noise;
  report.waviness = errors.waviness;
  report.correlation = errors.correlation;
  for (std::size_t u = 0; u < given.size(); ++u)
    if (given[u].may_tilt) {
      given[u].run = unknowns.all[u].is_tilted ? given[u].run : 0;
      given[u].describeAt(given[u].foot);
    }
  unknowns.standOnFeet();
  for (Unknown& u : unknowns.all)
    limitInformation(parameters, u);
  std::vector<PlanTie> ties;
  const std::vector<Unknown> fitted = unknowns.all;
  std::vector<bool> are_kept(fitted.size(), false);
  for (int tries = 0; tries < max_tries; ++tries) {
    unknowns.all = fitted;
    for (std::size_t u = 0; u < given.size(); ++u)
      if (are_kept[u]) {
        unknowns.all[u] = given[u];
        unknowns.all[u].is_kept = true;
      }
    ties = chooseTies(unknowns, parameters);
    tie(ties, unknowns.all);
    const std::vector<std::size_t> broken =
        rebuildLoops(unknowns, ties, are_kept, 2 * parameters.reach);
    if (broken.empty())
      break;
    for (const std::size_t u : broken)
      are_kept[u] = true;
    if (tries + 1 < max_tries)
      continue;
    ties.clear(); // slabs may move though walls do not
    for (std::size_t u = 0; u < given.size(); ++u)
      if (given[u].kind != UnknownKind::Plane)
        unknowns.all[u] = given[u];
  }
  setCovariances(ties, parameters.threads, unknowns.all);
  measureDeviations(points, parameters, unknowns.all);
  unknowns.write();
  for (const Unknown& u : unknowns.all)
    if (u.isSeen())
      ++(u.kind == UnknownKind::Plane ? report.slabs : report.walls);
  return report;
}

void
stateSlabs(Floorplan& plan,
           const PointView& raw,
           const std::vector<int>& indices,
           const AdjustmentParameters& parameters)
{
  Floorplan part; // the rooms with such slabs
  for (const PlanRoom& room : plan.rooms) {
    const auto isUnstated = [](const PlanSlab& slab) {
      return !slab.curve && !slab.accuracy.isKnown();
    };
    const auto hasUnstated = [&](const PlanDetail& d) { return isUnstated(d.slab); };
    const auto hasAny = [&](const std::vector<PlanDetail>& details) {
      return std::any_of(details.begin(), details.end(), hasUnstated);
    };
    if (isUnstated(room.floor) || isUnstated(room.ceiling) || hasAny(room.details) ||
        hasAny(room.floor_details))
      part.rooms.push_back(room);
  }
  PlanUnknowns unknowns(part, parameters);
  if (part.rooms.empty() || !emptyLoop(unknowns, part).empty())
    return;
  const PatchPoints points(part, unknowns, raw, indices, parameters);
  if (!points.problem().empty())
    return;
  std::vector<Unknown> given = unknowns.all;
  SurfaceFit(unknowns, points, parameters).run();
  measureDeviations(points, parameters, given);
  for (const UnknownSlab& s : unknowns.slabs) {
    Unknown& fitted = unknowns.all[s.unknown];
    if (s.slab->curve || s.slab->accuracy.isKnown() || !fitted.isSeen())
      continue;
    limitInformation(parameters, fitted);
    fitted.covariance = fitted.information.inverse();
    const double off = fitted.height - given[s.unknown].height;
    s.slab->accuracy = {std::hypot(fitted.accuracyAt(fitted.point).standard_error, off),
                        given[s.unknown].deviation};
  }
  for (PlanRoom& room : part.rooms)
    *findRoom(plan, room.id) = std::move(room);
}

} // namespace pcl::sedr
