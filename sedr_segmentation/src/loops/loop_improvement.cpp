// SPDX-License-Identifier: BSD-3-Clause
#include "../curves/fitted_curve.h"
#include "loop_proposals.h"
#include "loop_solver.h"
#include "sedr_filters/src/base/middle_value.h"

#include <algorithm>

namespace pcl::sedr {

/** @brief Returns whether one curve along a span costs less than the present ones. */
bool
LoopSolver::pays(std::size_t c, const Span& span, const LoopCandidate& instead) const
{
  const std::size_t n = labels_[c].size();
  const auto at = [&](std::size_t k) { return (span.first + k) % n; };
  double saved = costOf(c, span) - instead.cost;
  std::vector<std::size_t> within;
  for (std::size_t k = 0; k < span.length; ++k) {
    saved -= maker_.costOf(samples_.firstOf(c) + at(k), instead);
    within.push_back(labels_[c][at(k)]);
  }
  std::sort(within.begin(), within.end());
  for (std::size_t k = 0; k < within.size();) {
    std::size_t end = k;
    while (end < within.size() && within[end] == within[k])
      ++end;
    if (use_[within[k]] == end - k)
      saved += pool_[within[k]].cost;
    k = end;
  }
  if (span.length < n) {
    const auto& samples = contours_[c].samples;
    const std::size_t first = at(0);
    const std::size_t last = at(span.length - 1);
    const std::size_t before = (first + n - 1) % n;
    const std::size_t after = (last + 1) % n;
    saved -= joint(pool_[labels_[c][before]], instead,
                   (samples[before].place + samples[first].place) / 2)
                 .cost;
    saved -= joint(instead, pool_[labels_[c][after]],
                   (samples[last].place + samples[after].place) / 2)
                 .cost;
  }
  return saved > maker_.search().least_gain;
}

/** @brief Returns curves that lower the energy where they replace others: the used ones
 * fitted again, straight or bent, turned, and one instead of some neighbours. */
std::vector<LoopCandidate>
LoopSolver::improvements() const
{
  constexpr std::size_t fewest = 3; // samples, or places of a fit
  const double sigma = maker_.sigma();
  std::vector<LoopCandidate> proposals;
  for (std::size_t c = 0; c < labels_.size(); ++c) {
    if (labels_[c].empty())
      continue;
    const auto& samples = contours_[c].samples;
    const std::size_t n = samples.size();
    const auto runs = labelRuns(labels_[c]);
    for (const std::size_t together : {1, 2, 3, 4, 6})
      for (std::size_t r = 0; r < runs.size() && together <= runs.size(); ++r) {
        const auto& [last, last_length] = runs[(r + together - 1) % runs.size()];
        Span span{runs[r].first, (last + n - runs[r].first) % n + last_length};
        std::vector<Eigen::Vector2d> places;
        std::size_t seen = 0;
        const PlanCurve& present = pool_[labels_[c][span.first]].curve();
        for (std::size_t k = 0; k < span.length; ++k) {
          const std::size_t i = (span.first + k) % n;
          if (!samples[i].isSeen())
            continue;
          ++seen;
          if (together > 1)
            places.push_back(samples[i].anchor);
          else
            for (std::size_t q = contours_[c].first[i]; q < contours_[c].first[i + 1];
                 ++q)
              if (present.distance(contours_[c].points[q]) < 4 * sigma)
                places.push_back(contours_[c].points[q]);
        }
        if (seen < fewest || places.size() < fewest)
          continue;
        SeededCurve path;
        path.seed = samples[(span.first + span.length / 2) % n].place;
        const auto propose = [&](const PlanCurve& curve) {
          path.curve = curve;
          if (!maker_.isPossible(curve))
            return;
          std::vector<SeededCurve> paths = maker_.snapped(path);
          paths.push_back(path);
          for (const SeededCurve& p : paths)
            if (const LoopCandidate candidate = maker_.priced(p);
                pays(c, span, candidate))
              proposals.push_back(maker_.candidate(p));
        };
        propose(fitCurve(false, places, sigma));
        if (seen > 2 * fewest)
          propose(fitCurve(true, places, sigma));
        if (together == 1 && !present.isCircle()) { // the direction kept
          std::vector<double> offsets;
          for (const Eigen::Vector2d& q : places)
            offsets.push_back(present.signedDistance(q));
          PlanCurve moved = present;
          moved.point += middleValue(std::move(offsets)) * leftOf(present.direction);
          propose(moved);
        }
      }
  }
  return maker_.distinct(std::move(proposals), sigma / 4);
}

} // namespace pcl::sedr
