// SPDX-License-Identifier: BSD-3-Clause
#include "loop_assignment.h"

#include "wall_stretch.h"

#include "sedr_filters/src/base/exactness.h"
#include "sedr_filters/src/base/parallel_for.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl::sedr {

namespace {

/** @brief Cosine of the maximum angle between a contour and its curve. */
const double min_cosine = std::cos(35.0 * M_PI / 180.0);

/** @brief Returns the cost of an outlier, in units of (half a tolerance) squared;
 * beyond it the cost grows only slowly. */
double
outlierCost(const Priors& priors)
{
  return priors.sigmas * priors.sigmas;
}

/** @brief Returns the cost of an unsupported sample on a curve. The wall may run
 * outside the contour, hidden behind furniture, or inside it at an opening. Both are
 * cheap over some tenths of a metre and costly beyond. */
double
costUnsupported(const ContourSample& sample,
                const PlanCurve& curve,
                const Priors& priors)
{
  const double farthest_outside = priors.max_wall;
  const double farthest_inside = priors.max_wall / 2;
  const double inside =
      (curve.project(sample.place) - sample.place).dot(leftOf(sample.tangent));
  const double d = curve.distance(sample.place);
  const double excess = inside < 0 ? d / farthest_outside : d / farthest_inside;
  const double cheap = (inside < 0 ? 0.05 : 0.2) + 0.45 * excess;
  return excess <= 1 ? cheap
                     : sample.weight() * outlierCost(priors) + priors.far_cost * d;
}

/** @brief The positions and tangents of all curves at one sample. */
class CurvesAt {
public:
  void look(const ContourSample& sample, const std::vector<PlanCurve>& curves)
  {
    places_.clear();
    tangents_.clear();
    for (const auto& curve : curves) {
      places_.push_back(curve.project(sample.position));
      tangents_.push_back(curve.tangentAt(sample.position));
    }
  }

  /** @brief Returns the extra cost of a change between adjacent parallel curves, which
   * is rare for walls; 0 if they meet at an angle or touch. */
  double sideStep(std::size_t a, std::size_t b, double tolerance) const
  {
    if (std::abs(tangents_[a].dot(tangents_[b])) < 0.97)
      return 0;
    return 4 * std::min(1.0, (places_[a] - places_[b]).norm() / tolerance);
  }

private:
  std::vector<Eigen::Vector2d> places_;
  std::vector<Eigen::Vector2d> tangents_;
};

} // namespace

CurveAssignment::CurveAssignment(const std::vector<ContourSample>& samples,
                                 const PlanPoints& evidence,
                                 const LoopParameters& parameters)
    : samples_(samples)
    , evidence_(evidence)
    , parameters_(parameters)
    , points_(samples.size())
    , wall_(samples.size(), 0)
{
  parallelFor(samples.size(), samples_a_block, parameters.threads, [&](std::size_t i) {
    if (samples[i].isSupported())
      lookAround(i);
  });
}

/** @brief Returns the maximum distance of the wall from the contour. */
double
CurveAssignment::reach() const
{
  return std::abs(parameters_.expected_offset) + parameters_.reach;
}

void
CurveAssignment::lookAround(std::size_t i)
{
  const ContourSample& sample = samples_[i];
  evidence_.forEachWithin(
      sample.place,
      std::hypot(reach() + parameters_.tolerance, parameters_.evidence_span),
      [&](const Eigen::Vector2d& p) { points_[i].push_back(p); });
  wall_[i] = wallAcross(evidence_, sample.place, sample.tangent, parameters_).count;
}

/** @brief Computes the costs of all curves for a sample. */
void
CurveAssignment::judge(std::size_t i,
                       const std::vector<PlanCurve>& curves,
                       double* costs) const
{
  const ContourSample& sample = samples_[i];
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const double cosine =
        std::abs(curves[c].tangentAt(sample.place).dot(sample.tangent));
    costs[c] = cosine < min_cosine ? sample.weight() : 0;
    if (!sample.isSupported())
      costs[c] += costUnsupported(sample, curves[c], parameters_.priors);
  }
  if (!sample.isSupported())
    return;
  std::vector<Testimony> testimonies;
  double most = 0.6 * static_cast<double>(wall_[i]);
  for (const auto& curve : curves) {
    testimonies.push_back(hear(i, curve));
    most = std::max(most, testimonies.back().count);
  }
  for (std::size_t c = 0; c < curves.size(); ++c)
    costs[c] += costSupported(sample, curves[c], testimonies[c], most);
}

CurveAssignment::Testimony
CurveAssignment::hear(std::size_t i, const PlanCurve& curve) const
{
  const ContourSample& sample = samples_[i];
  Testimony heard;
  if (curve.distance(sample.place) > reach())
    return heard;
  const Eigen::Vector2d foot = curve.project(sample.place);
  const Eigen::Vector2d along = curve.tangentAt(sample.place);
  for (const Eigen::Vector2d& p : points_[i]) {
    const double d = curve.signedDistance(p);
    const double share = d / parameters_.tolerance;
    if (std::abs(share) >= 1 ||
        std::abs((p - foot).dot(along)) > parameters_.evidence_span)
      continue;
    const double weight = 1 - share * share;
    heard.count += weight;
    heard.offset += weight * d;
  }
  if (heard.count > 0)
    heard.offset /= heard.count;
  return heard;
}

double
CurveAssignment::costSupported(const ContourSample& sample,
                               const PlanCurve& curve,
                               const Testimony& heard,
                               double most) const
{
  // A curve with most of the points here costs nothing for lack of points.
  const Priors& priors = parameters_.priors;
  const double enough = 1 - priors.share_unseen;
  const double outlier_cost = outlierCost(priors);
  const double far = curve.distance(sample.place) - reach();
  if (far > 0)
    return sample.weight() * outlier_cost + priors.far_cost * far;
  const double lack = std::max(0.0, 1 - heard.count / (enough * most));
  const double squared = std::pow(heard.offset / (parameters_.tolerance / 2), 2);
  return sample.weight() * std::min(outlier_cost, squared + outlier_cost * lack);
}

std::vector<std::size_t>
CurveAssignment::assign(const std::vector<PlanCurve>& curves) const
{
  const std::size_t n = samples_.size();
  const std::size_t k = curves.size();
  std::vector<double> costs(n * k);
  parallelFor(n, samples_a_block, parameters_.threads,
              [&](std::size_t i) { judge(i, curves, costs.data() + i * k); });

  // Two rounds, so that the start no longer affects the second.
  const std::size_t rounds = 2 * n;
  std::vector<double> cost(k, 0);
  std::vector<double> next(k, 0);
  std::vector<std::uint16_t> from(rounds * k);
  CurvesAt here;
  std::vector<std::size_t> cheapest(k);
  for (std::size_t step = 0; step < rounds; ++step) {
    here.look(samples_[step % n], curves);
    std::iota(cheapest.begin(), cheapest.end(), 0);
    std::stable_sort(cheapest.begin(), cheapest.end(),
                     [&](std::size_t a, std::size_t b) { return cost[a] < cost[b]; });
    for (std::size_t c = 0; c < k; ++c) {
      std::size_t best = c;
      double least = cost[c];
      for (const std::size_t other : cheapest) {
        if (cost[other] + parameters_.priors.change_cost >= least)
          break;
        const double changed = cost[other] + parameters_.priors.change_cost +
                               here.sideStep(other, c, parameters_.tolerance);
        if (changed < least) {
          least = changed;
          best = other;
        }
      }
      from[step * k + c] = static_cast<std::uint16_t>(best);
      next[c] = least + costs[step % n * k + c];
    }
    cost.swap(next);
  }
  auto current = static_cast<std::size_t>(std::min_element(cost.begin(), cost.end()) -
                                          cost.begin());
  std::vector<std::size_t> assigned(n);
  for (std::size_t step = rounds; step-- > 0;) {
    // The central part of the two rounds has neighbours on both sides.
    if (step >= n / 2 && step < n / 2 + n)
      assigned[step % n] = current;
    current = from[step * k + current];
  }
  return assigned;
}

} // namespace pcl::sedr
