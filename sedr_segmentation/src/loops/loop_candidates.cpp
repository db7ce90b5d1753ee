// SPDX-License-Identifier: BSD-3-Clause
#include "../faces/wall_lines.h"
#include "loop_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace pcl::sedr {

namespace {

constexpr double aligned = 1e-6; // radians

/** @brief Returns the runs of equal labels around a cycle: first sample and length. */
std::vector<std::pair<std::size_t, std::size_t>>
labelRuns(const std::vector<std::size_t>& labels)
{
  const std::size_t n = labels.size();
  std::vector<std::size_t> starts;
  for (std::size_t i = 0; i < n; ++i)
    if (labels[i] != labels[(i + n - 1) % n])
      starts.push_back(i);
  std::vector<std::pair<std::size_t, std::size_t>> runs;
  for (std::size_t k = 0; k < starts.size(); ++k)
    runs.push_back(
        {starts[k], (starts[(k + 1) % starts.size()] + n - starts[k] - 1) % n + 1});
  if (runs.empty())
    runs.push_back({0, n});
  return runs;
}

} // namespace

double
LoopSolver::angleFromMain(const PlanCurve& curve) const
{
  return angleOff(std::atan2(curve.direction.y(), curve.direction.x()), directions_);
}

LoopCandidate
LoopSolver::candidateOf(const PlanCurve& curve) const
{
  LoopCandidate candidate;
  candidate.curve = curve;
  if (curve.isCircle()) {
    candidate.cost = 3 * parameter_ + energy_.rare_arc;
    candidate.unseen = 1;
  }
  else if (std::abs(angleFromMain(curve)) < aligned)
    candidate.cost = parameter_;
  else {
    candidate.cost = 2 * parameter_ + energy_.rare_oblique;
    candidate.unseen = energy_.unseen_oblique;
  }
  setExtent(candidate);
  return candidate;
}

void
LoopSolver::setExtent(LoopCandidate& candidate) const
{
  constexpr double beyond = 6; // metres: walls go on in line
  if (candidate.curve.isCircle())
    return;
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const LoopContour& contour : contours_)
    for (const LoopSample& sample : contour.samples)
      if (candidate.curve.distance(sample.anchor) < 2 * sigma_) {
        const double s =
            (sample.anchor - candidate.curve.point).dot(candidate.curve.direction);
        low = std::min(low, s);
        high = std::max(high, s);
      }
  candidate.from = low - beyond;
  candidate.to = high + beyond;
}

std::vector<PlanCurve>
LoopSolver::snapped(const PlanCurve& curve) const
{
  const double off = curve.isCircle() ? 1 : angleFromMain(curve);
  if (std::abs(off) < aligned || std::abs(off) > 0.07) // 4 degrees
    return {};
  PlanCurve line = curve;
  const double angle = std::atan2(curve.direction.y(), curve.direction.x()) - off;
  line.direction = {std::cos(angle), std::sin(angle)};
  std::vector<double> offsets;
  for (const LoopContour& contour : contours_)
    for (const LoopSample& sample : contour.samples)
      if (sample.isSeen() && curve.distance(sample.anchor) < 2 * sigma_)
        offsets.push_back(line.signedDistance(sample.anchor));
  if (offsets.size() < 2)
    return {};
  const auto middle = offsets.begin() + static_cast<std::ptrdiff_t>(offsets.size() / 2);
  std::nth_element(offsets.begin(), middle, offsets.end());
  line.point += *middle * leftOf(line.direction);
  return {line};
}

std::vector<PlanCurve>
LoopSolver::proposals(const LoopContour& contour) const
{
  const std::size_t n = contour.samples.size();
  std::vector<PlanCurve> curves;
  const auto addCircle = [&](const std::vector<Eigen::Vector2d>& places) {
    const PlanCurve circle = fitCurve(true, places, sigma_);
    if (circle.radius <= energy_.min_radius || circle.radius >= energy_.max_radius)
      return;
    const PlanCurve line = fitCurve(false, places, sigma_);
    double low = 0;
    double high = 0;
    for (const Eigen::Vector2d& p : places) {
      low = std::min(low, line.signedDistance(p));
      high = std::max(high, line.signedDistance(p));
    }
    if (high - low > 3 * sigma_)
      curves.push_back(circle);
  };
  for (const std::size_t window : {6, 12, 24, 48})
    for (std::size_t s = 0; s < n; s += std::max<std::size_t>(2, window / 4)) {
      const std::size_t length = std::min(window, n);
      std::vector<Eigen::Vector2d> seen;
      std::vector<Eigen::Vector2d> unseen;
      for (std::size_t k = 0; k < length; ++k) {
        const LoopSample& sample = contour.samples[(s + k) % n];
        if (sample.isSeen())
          seen.push_back(sample.anchor);
        else
          unseen.push_back(sample.place);
      }
      const double share =
          static_cast<double>(seen.size()) / static_cast<double>(length);
      if (share >= 0.6) {
        curves.push_back(fitCurve(false, seen, sigma_));
        if (window >= 12 || contour.is_hole)
          addCircle(seen);
      }
      else if (share < 0.4 && window <= 24)
        curves.push_back(fitCurve(false, unseen, energy_.reach / 60));
    }
  if (contour.is_hole) {
    std::vector<Eigen::Vector2d> seen;
    for (const LoopSample& sample : contour.samples)
      if (sample.isSeen())
        seen.push_back(sample.anchor);
    if (seen.size() > 6)
      addCircle(seen);
  }
  return distinct(std::move(curves), 1.5);
}

std::vector<PlanCurve>
LoopSolver::unseenProposals(const LoopContour& contour) const
{
  const std::size_t n = contour.samples.size();
  std::vector<std::size_t> seen(n);
  for (std::size_t i = 0; i < n; ++i)
    seen[i] = contour.samples[i].isSeen() ? 1 : 0;
  std::vector<PlanCurve> curves;
  for (const auto& [first, length] : labelRuns(seen)) {
    if (seen[first])
      continue;
    Eigen::Vector2d out = Eigen::Vector2d::Zero();
    for (std::size_t k = 0; k < length; ++k)
      out += contour.samples[(first + k) % n].normal;
    for (const double axis : directions_)
      for (const double turn : {axis, axis + M_PI / 2}) {
        Eigen::Vector2d v(std::cos(turn), std::sin(turn));
        if (std::abs(v.dot(out)) <= 0.5 * out.norm())
          continue;
        if (v.dot(out) < 0)
          v = -v;
        std::vector<double> offsets;
        for (std::size_t k = 0; k < length; ++k)
          offsets.push_back(v.dot(contour.samples[(first + k) % n].place));
        std::sort(offsets.begin(), offsets.end());
        for (const double quantile : {0.5, 0.9}) {
          PlanCurve line;
          line.direction = {v.y(), -v.x()};
          line.point = offsets[static_cast<std::size_t>(
                           quantile * static_cast<double>(offsets.size() - 1))] *
                       v;
          // Relative to the sample: far from the origin the point should be near.
          line.point += line.direction *
                        line.direction.dot(contour.samples[first].place - line.point);
          curves.push_back(line);
        }
      }
  }
  return curves;
}

std::vector<PlanCurve>
LoopSolver::distinct(std::vector<PlanCurve> curves, double tolerance) const
{
  // Samples are those of all contours; each curve's are found once.
  struct Support {
    std::vector<std::uint32_t> samples;
    std::size_t index;
  };
  std::vector<const LoopSample*> samples;
  for (const LoopContour& contour : contours_)
    for (const LoopSample& sample : contour.samples)
      if (sample.isSeen())
        samples.push_back(&sample);
  std::vector<Support> supports(curves.size());
  for (std::size_t c = 0; c < curves.size(); ++c) {
    supports[c].index = c;
    for (std::size_t i = 0; i < samples.size(); ++i)
      if (curves[c].distance(samples[i]->anchor) < tolerance * sigma_)
        supports[c].samples.push_back(static_cast<std::uint32_t>(i));
  }
  std::stable_sort(
      supports.begin(), supports.end(), [&](const Support& a, const Support& b) {
        const auto rank = [&](const Support& s) {
          return 2 * s.samples.size() - (curves[s.index].isCircle() ? 1 : 0);
        };
        return rank(a) > rank(b);
      });
  constexpr std::size_t least = 3; // samples of a curve that may explain nothing new
  constexpr double same = 0.95;
  std::vector<std::vector<std::uint32_t>> kept_at(samples.size());
  std::vector<PlanCurve> kept;
  std::vector<std::size_t> shared;
  for (const Support& support : supports) {
    const PlanCurve& curve = curves[support.index];
    bool is_new = true;
    if (support.samples.size() >= least) {
      shared.assign(kept.size(), 0);
      for (const std::uint32_t i : support.samples)
        for (const std::uint32_t k : kept_at[i])
          ++shared[k];
      for (std::size_t k = 0; k < kept.size() && is_new; ++k)
        is_new = !((!kept[k].isCircle() || curve.isCircle()) &&
                   static_cast<double>(shared[k]) >
                       same * static_cast<double>(support.samples.size()));
    }
    if (!is_new)
      continue;
    for (const std::uint32_t i : support.samples)
      kept_at[i].push_back(static_cast<std::uint32_t>(kept.size()));
    kept.push_back(curve);
  }
  return kept;
}

void
LoopSolver::findDirections(const std::vector<PlanCurve>& curves)
{
  std::vector<double> angles;
  std::vector<double> weights;
  for (const PlanCurve& curve : curves) {
    if (curve.isCircle())
      continue;
    double on = 0;
    for (const LoopContour& contour : contours_)
      for (const LoopSample& sample : contour.samples)
        on += sample.isSeen() && curve.distance(sample.anchor) < 1.5 * sigma_ ? 1 : 0;
    angles.push_back(std::atan2(curve.direction.y(), curve.direction.x()));
    weights.push_back(on * on);
  }
  directions_ = mainAngles(angles, weights, 4, 0.15);
}

/** @brief Replaces the pool by the used curves and proposals to improve them: fitted
 * again, straightened, bent, turned, merged with their neighbours.
 * @return the present labels in the new pool */
LoopSolver::Labels
LoopSolver::improve()
{
  std::vector<PlanCurve> more;
  const auto isPossible = [&](const PlanCurve& curve) {
    return !curve.isCircle() ||
           (curve.radius > energy_.min_radius && curve.radius < energy_.max_radius);
  };
  for (std::size_t p = 0; p < pool_.size(); ++p) {
    if (use_[p] == 0 || pool_[p].is_known)
      continue;
    const PlanCurve& curve = pool_[p].curve;
    std::vector<Eigen::Vector2d> near;
    std::size_t samples = 0;
    for (std::size_t c = 0; c < contours_.size(); ++c)
      for (std::size_t i = 0; i < labels_[c].size(); ++i) {
        if (labels_[c][i] != p || !contours_[c].samples[i].isSeen())
          continue;
        ++samples;
        for (std::size_t k = contours_[c].first[i]; k < contours_[c].first[i + 1]; ++k)
          if (curve.distance(contours_[c].points[k]) < 4 * sigma_)
            near.push_back(contours_[c].points[k]);
      }
    if (samples < 3 || near.size() < 6)
      continue;
    const PlanCurve again = fitCurve(curve.isCircle(), near, sigma_);
    if (isPossible(again)) {
      more.push_back(again);
      for (const PlanCurve& turned : snapped(again))
        more.push_back(turned);
    }
    if (!curve.isCircle()) { // the direction kept
      std::vector<double> offsets;
      for (const Eigen::Vector2d& q : near)
        offsets.push_back(curve.signedDistance(q));
      const auto middle =
          offsets.begin() + static_cast<std::ptrdiff_t>(offsets.size() / 2);
      std::nth_element(offsets.begin(), middle, offsets.end());
      PlanCurve moved = curve;
      moved.point += *middle * leftOf(curve.direction);
      more.push_back(moved);
    }
    if (samples > 8)
      if (const PlanCurve other = fitCurve(!curve.isCircle(), near, sigma_);
          isPossible(other))
        more.push_back(other);
  }
  for (std::size_t c = 0; c < contours_.size(); ++c) {
    const auto runs = labelRuns(labels_[c]);
    const std::size_t n = labels_[c].size();
    for (const std::size_t together : {2, 3, 4, 6})
      for (std::size_t r = 0; r < runs.size() && together <= runs.size(); ++r) {
        std::vector<Eigen::Vector2d> anchors;
        for (std::size_t k = 0; k < together; ++k) {
          const auto& [first, length] = runs[(r + k) % runs.size()];
          for (std::size_t i = first; i < first + length; ++i)
            if (contours_[c].samples[i % n].isSeen())
              anchors.push_back(contours_[c].samples[i % n].anchor);
        }
        if (anchors.size() < 8)
          continue;
        for (const bool is_circle : {true, false}) {
          const PlanCurve curve = fitCurve(is_circle, anchors, sigma_);
          const auto on = static_cast<double>(
              std::count_if(anchors.begin(), anchors.end(), [&](const auto& q) {
                return curve.distance(q) < 3 * sigma_;
              }));
          if (!isPossible(curve) || on <= 0.6 * static_cast<double>(anchors.size()))
            continue;
          more.push_back(curve);
          for (const PlanCurve& turned : snapped(curve))
            more.push_back(turned);
        }
      }
  }
  std::vector<LoopCandidate> pool;
  std::vector<std::size_t> place(pool_.size(), 0);
  for (std::size_t p = 0; p < pool_.size(); ++p)
    if (use_[p] > 0 || pool_[p].is_known) {
      place[p] = pool.size();
      pool.push_back(pool_[p]);
    }
  for (const PlanCurve& curve : distinct(std::move(more), 0.5))
    pool.push_back(candidateOf(curve));
  pool_ = std::move(pool);
  Labels now = labels_;
  for (auto& labels : now)
    for (std::size_t& label : labels)
      label = place[label];
  return now;
}

} // namespace pcl::sedr
