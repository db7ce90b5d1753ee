// SPDX-License-Identifier: BSD-3-Clause
#include "plan_refit.h"

#include "plan_regularisation.h"
#include "refit_rounds.h"

#include "sedr_filters/src/base/plane_fit.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

namespace {

/** @brief Returns the noise that may have displaced a surface: that of its original
 * inliers, or of the scan. */
double
noiseOf(std::size_t inliers, double residual, double noise)
{
  constexpr double unseen = 0.02;
  return std::max(noise, inliers > 0 ? residual : unseen);
}

/** @brief Returns positions along the elements of each curve of a plan. */
std::vector<std::vector<Eigen::Vector2d>>
placesAlong(const PlanCurves& curves)
{
  constexpr std::size_t parts = 8;
  std::vector<std::vector<Eigen::Vector2d>> places(curves.curves.size());
  for (const auto& loop : curves.loops)
    for (std::size_t i = 0; i < loop.curves.size(); ++i) {
      const PlanElement& e = loop.loop->elements[i];
      for (std::size_t k = 0; k <= parts; ++k)
        places[loop.curves[i]].push_back(
            e.pointAt(e.length() * static_cast<double>(k) / parts));
    }
  return places;
}

/** @brief Returns the maximum distance of a curve from its old positions. An arc moves
 * less than its centre. */
double
moveOf(const std::vector<Eigen::Vector2d>& were, const PlanCurve& curve)
{
  double farthest = 0;
  for (const auto& p : were)
    farthest = std::max(farthest, curve.distance(p));
  return farthest;
}

double
moveOf(const PlanSlab& from, const PlanSlab& to, const PlanLoop& loop)
{
  double farthest = 0;
  for (const auto& e : loop.elements)
    farthest =
        std::max(farthest, std::abs(to.heightAt(e.start) - from.heightAt(e.start)));
  return farthest;
}

/** @brief Returns the slabs of a room, in the order of RefitTargets, with their loops.
 */
std::vector<std::pair<PlanSlab*, const PlanLoop*>>
slabsOf(PlanRoom& room)
{
  std::vector<std::pair<PlanSlab*, const PlanLoop*>> slabs;
  slabs.emplace_back(&room.ceiling, &room.boundary);
  for (auto& detail : room.details)
    slabs.emplace_back(&detail.slab, &detail.boundary);
  slabs.emplace_back(&room.floor, &room.boundary);
  for (auto& detail : room.floor_details)
    slabs.emplace_back(&detail.slab, &detail.boundary);
  for (auto& niche : room.niches) {
    slabs.emplace_back(&niche.bottom, &niche.boundary);
    slabs.emplace_back(&niche.top, &niche.boundary);
  }
  return slabs;
}

/** @brief Returns tangent ties for smooth joints, and for nearly smooth ones consistent
 * with the scan. Otherwise the intersection of nearly parallel curves is unstable. */
std::vector<CurveTie>
tangentTies(PlanCurves& curves)
{
  constexpr double smooth = 1e-4; // radians
  const RegularisationParameters limits;
  std::vector<CurveTie> ties;
  for (const auto& loop : curves.loops) {
    const auto& elements = loop.loop->elements;
    for (std::size_t i = 0; i < elements.size(); ++i) {
      const std::size_t j = (i + 1) % elements.size();
      std::size_t a = loop.curves[i];
      std::size_t b = loop.curves[j];
      if (a == b || !PlanCurves::meetSmoothly(elements[i], elements[j],
                                              limits.largest_tangent_angle))
        continue;
      if (curves.curves[a].curve.isCircle())
        std::swap(a, b);
      if (!curves.curves[b].curve.isCircle() ||
          (!PlanCurves::meetSmoothly(elements[i], elements[j], smooth) &&
           contradiction(curves.curves[a], curves.curves[b], TieKind::Tangent) >
               limits.max_sigmas * limits.max_sigmas))
        continue;
      ties.push_back({TieKind::Tangent, a, b});
      curves.tangents.insert({std::min(a, b), std::max(a, b)});
    }
  }
  return ties;
}

/** @brief Returns the reason, an empty loop, why a plan cannot be fitted, or "". */
std::string
loopProblem(Floorplan& plan)
{
  for (auto& room : plan.rooms)
    for (const PlanLoop* loop : loopsOf(room))
      if (loop->elements.empty())
        return "room " + std::to_string(room.id) + " has a loop of 0 elements";
  return {};
}

} // namespace

RefitReport
refitToRaw(Floorplan& plan,
           const PointView& raw,
           const std::vector<int>& indices,
           const RefitParameters& parameters)
{
  RefitReport report;
  report.problem = loopProblem(plan);
  if (!report.problem.empty())
    return report;
  const RawPoints points{raw, indices.empty() ? nullptr : &indices, 1,
                         parameters.threads};
  PlanCurves curves(plan, parameters.priors);
  const std::vector<MeasuredCurve> was = curves.curves;
  const std::vector<std::vector<Eigen::Vector2d>> places = placesAlong(curves);
  std::vector<PlanSlab> slabs_were;
  for (auto& room : plan.rooms)
    for (const auto& [slab, loop] : slabsOf(room))
      slabs_were.push_back(*slab);

  Refit refit(plan, curves, points, parameters);
  report.problem = refit.targets().problem();
  if (!report.problem.empty())
    return report;
  refit.run();

  std::size_t k = 0;
  for (auto& room : plan.rooms)
    for (const auto& [slab, loop] : slabsOf(room)) {
      const std::size_t t = curves.curves.size() + k;
      const bool is_kept =
          refit.isFitted(t) &&
          moveOf(slabs_were[k], *slab, *loop) <= parameters.farthest + refit.noise(t);
      if (!is_kept)
        *slab = slabs_were[k];
      report.slabs += is_kept ? 1 : 0;
      ++k;
    }
  std::vector<bool> is_fitted(was.size(), false);
  for (std::size_t c = 0; c < was.size(); ++c) {
    const double limit =
        parameters.farthest +
        noiseOf(was[c].curve.inliers, was[c].curve.residual, refit.noise(c));
    is_fitted[c] =
        refit.isFitted(c) && moveOf(places[c], curves.curves[c].curve) <= limit;
    if (!is_fitted[c])
      curves.curves[c] = was[c];
    curves.remeasure(c);
  }
  if (std::none_of(is_fitted.begin(), is_fitted.end(), [](bool b) { return b; }))
    return report;
  const std::vector<CurveTie> ties = tangentTies(curves);
  const auto restore = [&](const PlanCurves::Loop& loop) {
    for (const std::size_t c : loop.curves) {
      curves.curves[c] = was[c];
      is_fitted[c] = false;
    }
  };
  bool is_whole = false;
  for (int tries = 0; tries < 10 && !is_whole; ++tries) {
    const std::vector<MeasuredCurve> fitted = curves.curves;
    if (!adjustCurves(curves.curves, ties)) {
      curves.curves = was;
      is_fitted.assign(was.size(), false);
    }
    const std::vector<std::size_t> broken =
        curves.rebuild(2 * (parameters.farthest + parameters.reach));
    is_whole = broken.empty();
    if (is_whole)
      break;
    curves.curves = fitted;
    for (const std::size_t l : broken)
      restore(curves.loops[l]);
  }
  if (!is_whole) { // the loops were not changed
    curves.curves = was;
    is_fitted.assign(was.size(), false);
  }
  for (const auto& loop : curves.loops)
    for (std::size_t i = 0; i < loop.curves.size(); ++i) {
      loop.loop->elements[i].inliers = curves.curves[loop.curves[i]].curve.inliers;
      loop.loop->elements[i].residual = curves.curves[loop.curves[i]].curve.residual;
    }
  for (std::size_t c = 0; c < was.size(); ++c)
    report.curves += is_fitted[c] ? 1 : 0;
  return report;
}

} // namespace pcl::sedr
