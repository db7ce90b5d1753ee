// SPDX-License-Identifier: BSD-3-Clause
#include "plan_adjustment.h"

#include "loop_corners.h"
#include "patch_points.h"
#include "plan_ties.h"
#include "plan_unknowns.h"
#include "surface_fit.h"

#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/base/quantiles.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

namespace {

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

void
removeTies(const std::vector<bool>& of, std::vector<PlanTie>& ties)
{
  ties.erase(std::remove_if(ties.begin(), ties.end(),
                            [&](const PlanTie& tie) { return of[tie.a] || of[tie.b]; }),
             ties.end());
}

/** @brief Finds the unknowns that all their ties together move farther than is worth
 * it, those that cost most. */
std::vector<bool>
overstrained(const std::vector<PlanTie>& ties, const std::vector<double>& costs)
{
  std::vector<double> excess = costs;
  for (const PlanTie& tie : ties) {
    excess[tie.a] -= tie.cost;
    excess[tie.b] -= tie.a == tie.b ? 0 : tie.cost;
  }
  const double most = *std::max_element(excess.begin(), excess.end());
  std::vector<bool> are(excess.size(), false);
  for (std::size_t u = 0; u < excess.size(); ++u)
    are[u] = excess[u] > 0 && excess[u] >= most / 2;
  return are;
}

/** @brief Solves the ties; those of overstrained unknowns are removed. */
void
tie(std::vector<PlanTie>& ties, std::vector<Unknown>& unknowns)
{
  constexpr int max_tries = 30;
  for (int tries = 0; tries < max_tries && !ties.empty(); ++tries) {
    std::vector<Unknown> moved = unknowns;
    const std::vector<double> costs = solveTies(ties, moved);
    if (costs.empty()) { // tangents are the most demanding
      const auto last = std::find_if(ties.rbegin(), ties.rend(), [](const PlanTie& t) {
        return t.kind == PlanTieKind::Tangent;
      });
      ties.erase(last == ties.rend() ? ties.end() - 1 : std::next(last).base());
      continue;
    }
    const std::vector<bool> are = overstrained(ties, costs);
    if (std::find(are.begin(), are.end(), true) == are.end()) {
      unknowns = std::move(moved);
      return;
    }
    removeTies(are, ties);
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
