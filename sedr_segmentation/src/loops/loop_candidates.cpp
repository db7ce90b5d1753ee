// SPDX-License-Identifier: BSD-3-Clause
#include "loop_candidates.h"

#include "../faces/wall_lines.h"
#include "../curves/fitted_curve.h"
#include "sedr_filters/src/base/middle_value.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

namespace {

constexpr double aligned = 1e-6; // radians

} // namespace

CandidateMaker::CandidateMaker(const StoreySamples& samples,
                               const LoopEnergy& energy,
                               double spacing,
                               const WallNoise& noise)
    : samples_(samples)
    , energy_(energy)
    , noise_(noise)
    , outlier_(energy.outlier * spacing / noise.correlation)
    , parameter_(std::log(energy.reach / noise.sigma))
{}

void
CandidateMaker::setDirections(std::vector<double> directions)
{
  directions_ = std::move(directions);
}

double
CandidateMaker::angleFromMain(const PlanCurve& curve) const
{
  return angleOff(std::atan2(curve.direction.y(), curve.direction.x()), directions_);
}

LoopCandidate
CandidateMaker::priced(const SeededCurve& path) const
{
  LoopCandidate candidate;
  candidate.path = path;
  if (path.curve.isCircle()) {
    candidate.cost = 3 * parameter_ + energy_.rare_arc;
    candidate.unseen = 1;
  }
  else if (std::abs(angleFromMain(path.curve)) < aligned)
    candidate.cost = parameter_;
  else {
    candidate.cost = 2 * parameter_ + energy_.rare_oblique;
    candidate.unseen = energy_.unseen_oblique;
  }
  return candidate;
}

double
CandidateMaker::costOf(std::size_t i, const LoopCandidate& candidate) const
{
  const LoopSample& sample = samples_[i];
  const PlanCurve& curve = candidate.curve();
  const AreaTable table;
  double unexplained = 1;
  if (sample.seen > 0)
    for (std::size_t q = 0; q < sample.weight.size(); ++q)
      if (sample.before[q] < 1) {
        const double d =
            curve.distance(sample.place + sample.offset[q] * sample.normal) /
            (3 * noise_.spread);
        unexplained = std::min(unexplained, sample.before[q] + d * d);
      }
  const double t = offsetAt(i, curve);
  return outlier_ * (sample.seen * unexplained + (1 - sample.seen) * candidate.unseen) +
         static_cast<double>(samples_.areas(i)[table.at(t)]);
}

/** @brief Returns how far along its normal from a sample a curve is. */
double
CandidateMaker::offsetAt(std::size_t i, const PlanCurve& curve) const
{
  const LoopSample& sample = samples_[i];
  return (curve.project(sample.place) - sample.place).dot(sample.normal);
}

/** @brief Returns the samples that a candidate explains, and where it is there. */
std::vector<std::pair<std::uint32_t, double>>
CandidateMaker::explainedBy(const LoopCandidate& candidate) const
{
  std::vector<std::pair<std::uint32_t, double>> explained;
  for (std::size_t k = 0; k < candidate.samples.size(); ++k)
    if (static_cast<double>(candidate.costs[k]) < outlier_ * 0.9)
      explained.push_back(
          {candidate.samples[k], offsetAt(candidate.samples[k], candidate.curve())});
  return explained;
}

std::vector<LoopCandidate>
CandidateMaker::distinct(std::vector<LoopCandidate> candidates, double same) const
{
  std::vector<std::vector<std::pair<std::uint32_t, double>>> explained;
  std::vector<std::pair<double, std::size_t>> order; // nats a sample
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    explained.push_back(explainedBy(candidates[c]));
    if (!explained[c].empty())
      order.push_back(
          {(candidates[c].cost + parameter_) / static_cast<double>(explained[c].size()),
           c});
  }
  std::stable_sort(order.begin(), order.end());
  std::vector<std::vector<std::size_t>> at(samples_.size()); // those kept
  std::vector<LoopCandidate> kept;
  for (const auto& [rank, c] : order) {
    const auto runsAlong = [&](std::size_t k) {
      const LoopCandidate& other = kept[k];
      return other.cost <= candidates[c].cost && other.unseen <= candidates[c].unseen &&
             std::all_of(
                 explained[c].begin(), explained[c].end(), [&](const auto& place) {
                   return std::binary_search(other.samples.begin(), other.samples.end(),
                                             place.first) &&
                          std::abs(offsetAt(place.first, other.curve()) -
                                   place.second) < same;
                 });
    };
    const auto& beside = at[explained[c].front().first];
    if (std::any_of(beside.begin(), beside.end(), runsAlong))
      continue;
    for (const std::uint32_t i : candidates[c].samples)
      at[i].push_back(kept.size());
    kept.push_back(std::move(candidates[c]));
  }
  return kept;
}

LoopCandidate
CandidateMaker::candidate(LoopCandidate candidate) const
{
  const SeededCurve& path = candidate.path;
  double low = 0; // where surfaces are
  double high = 0;
  samples_.anchors().follow(path, 2 * noise_.sigma, search_.beyond,
                            [&](std::uint32_t, double s) {
                              low = std::min(low, s);
                              high = std::max(high, s);
                              return true;
                            });
  std::vector<std::pair<std::uint32_t, float>> near;
  samples_.places().follow(
      path, energy_.reach, search_.beyond, [&](std::uint32_t i, double s) {
        if (s > low - search_.beyond && s < high + search_.beyond)
          near.push_back({i, static_cast<float>(costOf(i, candidate))});
        return s >= low && s <= high;
      });
  std::sort(near.begin(), near.end());
  for (const auto& [i, cost] : near) {
    candidate.samples.push_back(i);
    candidate.costs.push_back(cost);
  }
  return candidate;
}

std::vector<std::pair<std::uint32_t, double>>
CandidateMaker::support(const SeededCurve& path, double gap) const
{
  constexpr double along = 0.8; // cosine
  std::vector<std::pair<std::uint32_t, double>> found;
  samples_.anchors().follow(
      path, 2 * noise_.sigma, gap, [&](std::uint32_t i, double s) {
        const LoopSample& sample = samples_[i];
        const Eigen::Vector2d tangent = path.curve.tangentAt(sample.anchor);
        const bool is_on =
            sample.isSeen() && std::abs(leftOf(tangent).dot(sample.normal)) > along;
        if (is_on)
          found.push_back({i, s});
        return is_on;
      });
  return found;
}

SeededCurve
CandidateMaker::grown(SeededCurve path) const
{
  for (const double gap : {0.5, 2.0, search_.beyond, search_.beyond}) {
    std::vector<Eigen::Vector2d> places;
    for (const auto& [i, s] : support(path, gap))
      places.push_back(samples_[i].anchor);
    if (places.size() < 3)
      break;
    path.curve = fitCurve(path.curve.isCircle(), places, noise_.sigma);
  }
  return path;
}

std::vector<SeededCurve>
CandidateMaker::snapped(const SeededCurve& path) const
{
  const PlanCurve& curve = path.curve;
  const double off = curve.isCircle() ? 1 : angleFromMain(curve);
  if (std::abs(off) < aligned || std::abs(off) > search_.max_turn)
    return {};
  SeededCurve turned = path;
  const double angle = std::atan2(curve.direction.y(), curve.direction.x()) - off;
  turned.curve.direction = {std::cos(angle), std::sin(angle)};
  std::vector<double> offsets;
  for (const auto& [i, s] : support(path, search_.beyond))
    offsets.push_back(turned.curve.signedDistance(samples_[i].anchor));
  if (offsets.size() < 2)
    return {};
  turned.curve.point +=
      middleValue(std::move(offsets)) * leftOf(turned.curve.direction);
  return {turned};
}

} // namespace pcl::sedr
