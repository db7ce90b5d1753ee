// SPDX-License-Identifier: BSD-3-Clause
#include "../loop/loop_fit.h"

#include "sedr_filters/src/base/exactness.h"
#include "sedr_filters/src/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>

namespace pcl::sedr {

namespace {

/** @brief Cosine of the maximum angle between a contour and its curve. */
const double min_cosine_of_tangents = std::cos(35.0 * M_PI / 180.0);

/** @brief Returns the agreement of a sample with a curve: its weight, decreasing to 0
 * at the tolerance. Without points it is at least the contour's staircase, half a cell.
 */
double
agreement(const ContourSample& sample,
          const PlanCurve& curve,
          const LoopParameters& parameters)
{
  const double tolerance =
      sample.isSupported()
          ? parameters.tolerance
          : std::max(parameters.tolerance, parameters.evidence_span / 2);
  const double d = curve.distance(sample.position) / tolerance;
  if (d >= 1 || std::abs(curve.tangentAt(sample.position).dot(sample.tangent)) <
                    min_cosine_of_tangents)
    return 0;
  return sample.weight() * (1 - d * d);
}

/** @brief RANSAC for one loop. It draws nearby samples, so most draws lie on one wall.
 */
class CurveSearch {
public:
  CurveSearch(const std::vector<ContourSample>& samples,
              const LoopParameters& parameters)
      : samples_(samples)
      , parameters_(parameters)
      , random_(parameters.seed)
      , is_seen_(std::any_of(samples.begin(),
                             samples.end(),
                             [](const ContourSample& s) { return s.isSupported(); }))
  {}

  /** @brief Returns the best line through open samples, refined. */
  PlanCurve bestLine(const std::vector<std::size_t>& open, double& best_score)
  {
    std::vector<PlanCurve> drawn;
    drawn.reserve(trials);
    for (int trial = 0; trial < trials; ++trial) {
      const std::size_t i = open[random_() % open.size()];
      const std::size_t j = (i + 3 + random_() % 60) % samples_.size();
      drawn.push_back(lineThrough(samples_[i].position, samples_[j].position));
    }
    return refined(bestOf(drawn, open, best_score), open, best_score);
  }

  /** @brief Returns the best circle within the radius limits, refined; radius 0 if
   * there is none. */
  PlanCurve bestCircle(const std::vector<std::size_t>& open, double& best_score)
  {
    std::vector<PlanCurve> drawn;
    drawn.reserve(2 * trials);
    for (int trial = 0; trial < 2 * trials; ++trial) {
      const std::size_t i = open[random_() % open.size()];
      const std::size_t step = 3 + random_() % 40;
      const PlanCurve circle = circleThrough(
          samples_[i].position, samples_[(i + step) % samples_.size()].position,
          samples_[(i + 2 * step) % samples_.size()].position);
      if (circle.radius >= parameters_.minimum_radius &&
          circle.radius <= parameters_.maximum_radius)
        drawn.push_back(circle);
    }
    const PlanCurve best = bestOf(drawn, open, best_score);
    return best.isCircle() ? refined(best, open, best_score) : best;
  }

private:
  static constexpr int trials = 400;

  /** @brief Returns the score of a curve over the open samples. Unsupported samples
   * count for circles only if the whole loop is unsupported, as hidden walls are
   * assumed straight. The sum is aborted if it cannot exceed `least`. */
  double scoreOf(const PlanCurve& curve,
                 const std::vector<std::size_t>& open,
                 double least) const
  {
    // No sample has a weight above 1.
    double sum = 0;
    auto left = static_cast<double>(open.size());
    for (const std::size_t i : open) {
      if (samples_[i].isSupported() || !curve.isCircle() || !is_seen_)
        sum += agreement(samples_[i], curve, parameters_);
      left -= 1;
      if (sum + left + same_place < least)
        break;
    }
    return sum;
  }

  /** @brief Returns the first drawn curve of maximum score, a default line if all are
   * 0. */
  PlanCurve bestOf(const std::vector<PlanCurve>& drawn,
                   const std::vector<std::size_t>& open,
                   double& best_score) const
  {
    constexpr std::size_t curves_a_block = 100;
    struct Scored {
      std::size_t curve = 0;
      double score = 0;
    };
    std::vector<Scored> best_of(drawn.size() / curves_a_block + 1);
    parallelBlocks(drawn.size(), curves_a_block, parameters_.threads,
                   [&](std::size_t begin, std::size_t end) {
                     Scored& best = best_of[begin / curves_a_block];
                     for (std::size_t c = begin; c < end; ++c) {
                       const double score = scoreOf(drawn[c], open, best.score);
                       if (score > best.score)
                         best = {c, score};
                     }
                   });
    PlanCurve best;
    for (const Scored& own : best_of)
      if (own.score > best_score) {
        best_score = own.score;
        best = drawn[own.curve];
      }
    return best;
  }

  PlanCurve refined(PlanCurve curve,
                    const std::vector<std::size_t>& open,
                    double& best_score) const
  {
    std::vector<WeightedPoint> inliers;
    for (const std::size_t i : open)
      if (agreement(samples_[i], curve, parameters_) > 0)
        inliers.push_back({samples_[i].position, samples_[i].weight()});
    if (inliers.size() < 4)
      return curve;
    const PlanCurve fitted =
        fitRobustly(inliers, curve, parameters_.tolerance, parameters_.minimum_radius,
                    parameters_.maximum_radius);
    const double s = scoreOf(fitted, open, best_score);
    if (s <= best_score)
      return curve;
    best_score = s;
    return fitted;
  }

  const std::vector<ContourSample>& samples_;
  const LoopParameters& parameters_;
  std::mt19937_64 random_;
  bool is_seen_; ///< any sample is supported
};

void
eraseExplained(const std::vector<ContourSample>& samples,
               const PlanCurve& curve,
               const LoopParameters& parameters,
               std::vector<std::size_t>& open)
{
  open.erase(std::remove_if(open.begin(), open.end(),
                            [&](std::size_t i) {
                              return agreement(samples[i], curve, parameters) > 0;
                            }),
             open.end());
}

/** @brief Returns the sorted `all` without the sorted `some`. */
std::vector<std::size_t>
difference(const std::vector<std::size_t>& all, const std::vector<std::size_t>& some)
{
  std::vector<std::size_t> rest;
  std::set_difference(all.begin(), all.end(), some.begin(), some.end(),
                      std::back_inserter(rest));
  return rest;
}

/** @brief Appends up to six lines through the open samples, best first. */
void
proposeLines(CurveSearch& search,
             const std::vector<ContourSample>& samples,
             std::vector<std::size_t> open,
             const LoopParameters& parameters,
             double min_score,
             std::vector<PlanCurve>& curves)
{
  for (int k = 0; k < 6 && open.size() >= 3; ++k) {
    double line_score = 0;
    const PlanCurve line = search.bestLine(open, line_score);
    if (line_score < min_score)
      break;
    curves.push_back(line);
    eraseExplained(samples, line, parameters, open);
  }
}

} // namespace

std::vector<PlanCurve>
findCurves(const std::vector<ContourSample>& samples,
           const std::vector<PlanCurve>& known,
           const LoopParameters& parameters)
{
  constexpr std::size_t max_curves = 120;
  // A circle must explain clearly more than a line, or straight walls would become
  // arcs.
  constexpr double circle_advantage = 1.15;
  const double circle_surplus = parameters.priors.min_evidence;

  std::vector<PlanCurve> curves = known;
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < samples.size(); ++i)
    open.push_back(i);
  for (const auto& curve : known)
    eraseExplained(samples, curve, parameters, open);

  const double edge =
      samples.size() < 2
          ? 1
          : std::max(1e-6, (samples[1].position - samples[0].position).norm());
  const double min_score = std::max(2.0, 0.5 * parameters.minimum_length / edge);
  CurveSearch search(samples, parameters);
  while (open.size() >= 3 && curves.size() < max_curves) {
    double line_score = 0;
    double circle_score = 0;
    const PlanCurve line = search.bestLine(open, line_score);
    const PlanCurve circle = search.bestCircle(open, circle_score);
    const bool is_circle =
        circle.isCircle() &&
        circle_score > circle_advantage * line_score + circle_surplus;
    if (std::max(line_score, is_circle ? circle_score : 0.0) < min_score)
      break;
    curves.push_back(is_circle ? circle : line);
    std::vector<std::size_t> left = open;
    eraseExplained(samples, curves.back(), parameters, left);
    if (is_circle) // a square column resembles a circle, so its sides are proposed, too
      proposeLines(search, samples, difference(open, left), parameters, min_score,
                   curves);
    open.swap(left);
  }
  return curves;
}

} // namespace pcl::sedr
