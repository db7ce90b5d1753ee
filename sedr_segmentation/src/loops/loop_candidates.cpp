// SPDX-License-Identifier: BSD-3-Clause
#include "loop_candidates.h"

#include "../faces/wall_lines.h"
#include "loop_curve.h"
#include "sedr_filters/src/base/middle_value.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

namespace {

constexpr double aligned = 1e-6; // radians

bool
areAlike(const LoopCandidate& a, const LoopCandidate& b, double same)
{
  constexpr double span = 1; // metres: curves are compared over
  if (a.curve().isCircle() != b.curve().isCircle() || a.cost != b.cost ||
      (a.path.seed - b.path.seed).norm() > span)
    return false;
  const auto isNear = [&](double s) { return a.curve().distance(b.path.at(s)) < same; };
  return isNear(-span) && isNear(0) && isNear(span);
}

} // namespace

void
DistinctCandidates::add(const LoopCandidate& candidate)
{
  constexpr std::size_t last = 24; // those of one stretch
  for (std::size_t k = all_.size() - std::min(all_.size(), last); k < all_.size(); ++k)
    if (areAlike(all_[k], candidate, same_))
      return;
  all_.push_back(candidate);
}

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
  const double t = (curve.project(sample.place) - sample.place).dot(sample.normal);
  return outlier_ * (sample.seen * unexplained + (1 - sample.seen) * candidate.unseen) +
         static_cast<double>(samples_.areas(i)[table.at(t)]);
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
