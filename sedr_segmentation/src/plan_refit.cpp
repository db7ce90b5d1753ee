// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_segmentation/plan_refit.h>

#include "refit_sums.h"
#include "refit_targets.h"

#include <pcl/sedr_filters/plane_fit.h>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace sedr {

namespace {

/** @brief Lines whose points tell their direction no better are shifted only, radians.
 */
constexpr double largest_deviation_of_turn = 0.005;

/** @brief Half width of the band of points that count, in standard deviations. */
constexpr double band_sigmas = 3;

/** @brief Half width of the narrowest band, metres. */
constexpr double least_band = 0.0015;

/** @brief The surfaces of a plan while they are fitted. */
class Refit {
public:
  Refit(Floorplan& plan,
        PlanCurves& curves,
        const RawPoints& raw,
        const RefitParameters& parameters)
      : curves_(curves)
      , parameters_(parameters)
      , raw_(raw)
      , targets_(plan, curves, parameters.reach)
      , is_fitted_(targets_.size(), false)
      , noise_(targets_.size(), 0)
  {}

  void run()
  {
    constexpr int rounds = 3;
    std::vector<double> centre;
    std::vector<double> band;
    scatters_ = scatterOf(raw_, targets_, parameters_.reach);
    settleScatters();
    for (std::size_t t = 0; t < targets_.size(); ++t) {
      centre.push_back(scatters_[t].centre);
      band.push_back(bandOf(t, scatters_[t].deviation));
    }
    for (int round = 0; round < rounds; ++round) {
      const std::vector<PatchSums> sums = patchSums(raw_, targets_, centre, band);
      for (std::size_t t = 0; t < targets_.size(); ++t) {
        if (isSparse(t) && round > 0)
          continue;
        PatchFit fit = isSparse(t) ? shiftTo(scatters_[t]) : fitOf(sums, t);
        if (fit.count < static_cast<double>(parameters_.least_points))
          continue;
        if (!isSparse(t) && isBesideAnother(t, scatters_[t].deviation))
          undoCut(centre[t], band[t], scatters_[t].deviation, fit);
        move(t, fit);
        noise_[t] = fit.deviation;
        centre[t] = 0;
        band[t] = bandOf(t, fit.deviation);
      }
      followParents();
    }
  }

  bool isFitted(std::size_t t) const { return is_fitted_[t]; }
  double noise(std::size_t t) const { return noise_[t]; }
  const RefitTargets& targets() const { return targets_; }

private:
  /** @brief The scatter of few points is known by that of others better. */
  void settleScatters()
  {
    constexpr double points_of_usual = 100;
    std::vector<double> deviations;
    for (const Scatter& s : scatters_)
      if (s.count >= points_of_usual)
        deviations.push_back(s.deviation);
    if (deviations.empty())
      return;
    const auto middle =
        deviations.begin() + static_cast<std::ptrdiff_t>(deviations.size() / 2);
    std::nth_element(deviations.begin(), middle, deviations.end());
    const double usual = *middle;
    for (Scatter& s : scatters_) {
      const double share = s.count / (s.count + points_of_usual);
      s.deviation = share * s.deviation + (1 - share) * usual;
    }
  }

  /** @brief Whether a line is shown by too few points for patches. */
  bool isSparse(std::size_t t) const
  {
    constexpr double few = 150;
    return t < curves_.curves.size() && !curves_.curves[t].curve.isCircle() &&
           scatters_[t].count < few;
  }

  /** @brief A shift to where most of the points are. */
  static PatchFit shiftTo(const Scatter& scatter)
  {
    PatchFit fit;
    fit.step[0] = scatter.centre;
    fit.count = scatter.count;
    fit.deviation = scatter.deviation;
    return fit;
  }

  /** @brief Whether the points of another surface reach into the band of this one. */
  bool isBesideAnother(std::size_t t, double deviation) const
  {
    return targets_.gap(t) < 2 * band_sigmas * deviation;
  }

  /** @brief Half width of the band of points that count: narrower where those of
   * another surface are beside it. */
  double bandOf(std::size_t t, double deviation) const
  {
    const double band =
        std::clamp(band_sigmas * deviation, least_band, parameters_.reach);
    return std::min(band, std::max({least_band, deviation,
                                    targets_.gap(t) - band_sigmas * deviation}));
  }

  /** @brief Points cut off at a band draw its centre after them by a part of the way
   * only: the whole way, as it is for the normal distribution. */
  static void undoCut(double centre, double band, double deviation, PatchFit& fit)
  {
    constexpr double least_part = 0.2;
    const double z = band / deviation;
    const double kept = std::erf(z / std::sqrt(2.0));
    const double part = 1 - 2 * z * std::exp(-z * z / 2) / std::sqrt(2 * M_PI) / kept;
    fit.step[0] -= centre;
    fit.step /= std::max(least_part, part);
    fit.step[0] += centre;
    fit.deviation = deviation;
  }

  /** @brief How many parameters of a surface are fitted. */
  Eigen::Index parametersOf(std::size_t t) const
  {
    if (t >= curves_.curves.size()) {
      const std::size_t k = t - curves_.curves.size();
      return targets_.parent(k) == k ? 3 : 1;
    }
    if (curves_.curves[t].curve.isCircle())
      return 3;
    const double deviation = scatters_[t].deviation *
                             std::sqrt(12.0 / std::max(1.0, scatters_[t].count)) /
                             targets_.lengthOf(t);
    return deviation <= largest_deviation_of_turn ? 2 : 1;
  }

  PatchFit fitOf(const std::vector<PatchSums>& sums, std::size_t t) const
  {
    const std::size_t first = targets_.firstPatch(t);
    const std::size_t last = targets_.firstPatch(t + 1);
    std::vector<bool> is_top;
    for (std::size_t p = first; p < last; ++p)
      is_top.push_back(targets_.isTop(t, p));
    return fitPatches(sums, first, last, is_top, parametersOf(t),
                      scatters_[t].deviation);
  }

  void move(std::size_t t, const PatchFit& fit)
  {
    const std::size_t curves = curves_.curves.size();
    if (t >= curves)
      moveSlab(targets_.slab(t - curves), targets_.middle(t - curves), fit);
    else if (curves_.curves[t].curve.isCircle())
      moveCircle(curves_.curves[t].curve, fit);
    else
      moveLine(curves_.curves[t], fit);
    is_fitted_[t] = true;
  }

  static void moveCircle(PlanCurve& circle, const PatchFit& fit)
  {
    if (circle.radius + fit.step[2] <= 0)
      return;
    circle.point += fit.step.head<2>();
    circle.radius += fit.step[2];
    circle.inliers = static_cast<std::size_t>(fit.count);
    circle.residual = fit.deviation;
  }

  static void moveLine(MeasuredCurve& m, const PatchFit& fit)
  {
    PlanCurve& line = m.curve;
    const Eigen::Vector2d left = leftOf(line.direction);
    line.point = line.project(m.pivot) + fit.step[0] * left;
    line.direction = (line.direction + fit.step[1] * left).normalized();
    line.inliers = static_cast<std::size_t>(fit.count);
    line.residual = fit.deviation;
  }

  static void
  moveSlab(PlanSlab& slab, const Eigen::Vector2d& middle, const PatchFit& fit)
  {
    // Its height falls by the distance of what is above it.
    const double height = slab.heightAt(middle) + fit.step[0] / slab.plane[2];
    Eigen::Vector3d normal = slab.plane.head<3>();
    normal.head<2>() -= fit.step.tail<2>();
    setPlane(normal, middle, height, slab);
    slab.inliers = static_cast<std::size_t>(fit.count);
    slab.residual = fit.deviation;
  }

  static void setPlane(Eigen::Vector3d normal,
                       const Eigen::Vector2d& place,
                       double height,
                       PlanSlab& slab)
  {
    normal.normalize();
    slab.plane.head<3>() = normal;
    slab.plane[3] = -normal.dot(Eigen::Vector3d(place.x(), place.y(), height));
  }

  /** @brief Slabs that are parallel to another stay so. */
  void followParents()
  {
    for (std::size_t k = 0; k < targets_.slabCount(); ++k) {
      const std::size_t parent = targets_.parent(k);
      if (parent == k)
        continue;
      PlanSlab& slab = targets_.slab(k);
      setPlane(targets_.slab(parent).plane.head<3>(), targets_.middle(k),
               slab.heightAt(targets_.middle(k)), slab);
    }
  }

  PlanCurves& curves_;
  const RefitParameters& parameters_;
  RawPoints raw_;
  RefitTargets targets_;
  std::vector<bool> is_fitted_;
  std::vector<double> noise_;
  std::vector<Scatter> scatters_;
};

/** @brief The noise that a surface may have been misplaced by: that of what it was
 * found on, or of the scan. */
double
noiseOf(std::size_t inliers, double residual, double noise)
{
  constexpr double unseen = 0.02;
  return std::max(noise, inliers > 0 ? residual : unseen);
}

/** @brief Places along what a plan shows of each of its curves. */
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

/** @brief The farthest that a curve is from where it was. An arc moves less than its
 * centre does. */
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

/** @brief The slabs of a room in the order of RefitTargets, and the loops they cover.
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

/** @brief Notes the joints that are smooth, to be kept so. */
void
noteTangents(PlanCurves& curves, std::vector<CurveTie>& ties)
{
  constexpr double smooth = 1e-4; // radians
  for (const auto& loop : curves.loops) {
    const auto& elements = loop.loop->elements;
    for (std::size_t i = 0; i < elements.size(); ++i) {
      const std::size_t j = (i + 1) % elements.size();
      std::size_t a = loop.curves[i];
      std::size_t b = loop.curves[j];
      if (a == b || !PlanCurves::meetSmoothly(elements[i], elements[j], smooth))
        continue;
      if (curves.curves[a].curve.isCircle())
        std::swap(a, b);
      if (!curves.curves[b].curve.isCircle())
        continue;
      ties.push_back({TieKind::Tangent, a, b});
      curves.tangents.insert({std::min(a, b), std::max(a, b)});
    }
  }
}

/** @brief Why a plan cannot be fitted, a sentence: a loop of it is empty. */
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
  RawPoints points{raw, indices.empty() ? nullptr : &indices, 1, parameters.threads};
  points.step = points.size() / std::max<std::size_t>(parameters.most_points, 1) + 1;
  PlanCurves curves(plan);
  std::vector<CurveTie> ties;
  noteTangents(curves, ties);
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
  std::vector<bool> is_kept(slabs_were.size(), false);
  for (auto& room : plan.rooms)
    for (const auto& [slab, loop] : slabsOf(room)) {
      const std::size_t t = curves.curves.size() + k;
      const std::size_t parent = refit.targets().parent(k);
      is_kept[k] =
          refit.isFitted(t) && (parent >= k || is_kept[parent]) &&
          moveOf(slabs_were[k], *slab, *loop) <= parameters.farthest + refit.noise(t);
      if (!is_kept[k])
        *slab = slabs_were[k];
      report.slabs += is_kept[k] ? 1 : 0;
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
  }
  if (std::none_of(is_fitted.begin(), is_fitted.end(), [](bool b) { return b; }))
    return report;
  const auto restore = [&](const PlanCurves::Loop& loop) {
    for (const std::size_t c : loop.curves) {
      curves.curves[c] = was[c];
      is_fitted[c] = false;
    }
  };
  for (int tries = 0; tries < 10; ++tries) {
    const std::vector<MeasuredCurve> fitted = curves.curves;
    if (!adjustCurves(curves.curves, ties)) {
      curves.curves = was;
      is_fitted.assign(was.size(), false);
    }
    const std::vector<std::size_t> broken =
        curves.rebuild(2 * (parameters.farthest + parameters.reach));
    if (broken.empty())
      break;
    curves.curves = fitted;
    for (const std::size_t l : broken)
      restore(curves.loops[l]);
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

} // namespace sedr
} // namespace pcl
