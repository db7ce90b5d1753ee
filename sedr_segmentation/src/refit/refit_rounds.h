// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "refit_sums.h"
#include "refit_targets.h"

#include "plan_refit.h"
#include "sedr_filters/src/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace pcl::sedr {

/** @brief Iterative fit of the surfaces of a plan. */
class Refit {
public:
  Refit(Floorplan& plan,
        PlanCurves& curves,
        const RawPoints& raw,
        const RefitParameters& parameters)
      : curves_(curves)
      , parameters_(parameters)
      , raw_(raw)
      , targets_(plan, curves, parameters.reach, parameters.threads)
      , is_fitted_(targets_.size(), false)
      , noise_(targets_.size(), 0)
  {
    raw_.step = rawStep(raw_.size(), std::max<std::size_t>(1, parameters.max_points));
  }

  void run()
  {
    constexpr int rounds = 3;
    std::vector<double> centre;
    std::vector<double> band;
    const Sightings sightings(raw_, targets_, parameters_.priors);
    scatters_ = sightings.scatters(parameters_.reach);
    for (std::size_t t = 0; t < targets_.size(); ++t) {
      centre.push_back(scatters_[t].centre);
      band.push_back(bandOf(t, scatters_[t].deviation));
    }
    for (int round = 0; round < rounds; ++round) {
      const std::vector<PatchFit> fits = fitsOf(sightings.patchSums(centre, band));
      for (std::size_t t = 0; t < targets_.size(); ++t) {
        const PatchFit& fit = fits[t];
        if (fit.count < static_cast<double>(parameters_.min_points))
          continue;
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
  /** @brief Lines and slabs with a larger standard deviation of their direction are
   * only shifted, radians. */
  static constexpr double largest_deviation_of_turn = 0.005;

  /** @brief Narrower slabs, such as the bottom of a niche, are only shifted, as
   * adjacent walls would rotate them, metres. */
  static constexpr double min_width = 0.5;

  /** @brief Half width of the inlier band, in standard deviations. */
  static constexpr double band_sigmas = 3;

  /** @brief Minimum half width of the inlier band, metres. */
  static constexpr double min_band = 0.0015;

  /** @brief Returns the half width of the inlier band, reduced near another surface. */
  double bandOf(std::size_t t, double deviation) const
  {
    const double band =
        std::clamp(band_sigmas * deviation, min_band, parameters_.reach);
    return std::min(band, std::max({min_band, deviation,
                                    targets_.gap(t) - band_sigmas * deviation}));
  }

  /** @brief Returns the number of fitted parameters of a surface. */
  Eigen::Index parametersOf(std::size_t t) const
  {
    const auto tellsDirection = [&](double extent) {
      const double deviation =
          scatters_[t].deviation * std::sqrt(12.0 / std::max(1.0, scatters_[t].count));
      return deviation <= largest_deviation_of_turn * extent;
    };
    if (t >= curves_.curves.size()) {
      const std::size_t k = t - curves_.curves.size();
      const double width = targets_.widthOfSlab(k);
      return targets_.parent(k) == k && width >= min_width && tellsDirection(width) ? 3
                                                                                    : 1;
    }
    if (curves_.curves[t].curve.isCircle())
      return 3;
    return tellsDirection(targets_.lengthOf(t)) ? 2 : 1;
  }

  /** @brief Fits each surface to its patches. */
  std::vector<PatchFit> fitsOf(const std::vector<std::vector<PatchSums>>& sums) const
  {
    std::vector<PatchFit> fits(targets_.size());
    parallelBlocks(fits.size(), 1, raw_.threads, [&](std::size_t t, std::size_t) {
      std::vector<bool> is_top;
      for (std::size_t p = 0; p < sums[t].size(); ++p)
        is_top.push_back(targets_.isTop(t, p));
      fits[t] = fitPatches(sums[t], is_top, parametersOf(t), scatters_[t].deviation);
    });
    return fits;
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
    // Points above the slab have positive distances.
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

  /** @brief Keeps slabs parallel to their parents. */
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

} // namespace pcl::sedr
