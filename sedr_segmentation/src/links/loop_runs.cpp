// SPDX-License-Identifier: BSD-3-Clause
#include "loop_runs.h"

#include "loop_assignment.h"

#include "sedr_filters/src/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

namespace {

/** @brief The curves of a loop and the curve of each sample. */
struct Assignment {
  std::vector<PlanCurve> curves;
  std::size_t known = 0; ///< number of known curves, which come first
  std::vector<std::size_t> curve_of;
};

/** @brief Returns the number of samples of each curve. */
std::vector<std::size_t>
followersOf(const Assignment& a)
{
  std::vector<std::size_t> followers(a.curves.size(), 0);
  for (const std::size_t c : a.curve_of)
    ++followers[c];
  return followers;
}

std::vector<Run>
runsOf(const Assignment& a)
{
  const std::size_t n = a.curve_of.size();
  std::size_t start = 0;
  while (start < n && a.curve_of[start] == a.curve_of[(start + n - 1) % n])
    ++start;
  if (start == n)
    return {{a.curves[a.curve_of[0]], 0, n, a.curve_of[0] < a.known}};
  std::vector<Run> runs;
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = (start + k) % n;
    if (k == 0 || a.curve_of[i] != a.curve_of[(i + n - 1) % n])
      runs.push_back({a.curves[a.curve_of[i]], i, 0, a.curve_of[i] < a.known});
    ++runs.back().count;
  }
  return runs;
}

/** @brief Data for a curve fit: wall points along the curve's samples, and the samples.
 */
struct CurveEvidence {
  std::vector<WeightedPoint> walls;
  std::vector<WeightedPoint> places;
};

/** @brief Appends the points along a sample that are on its curve and on none of the
 * neighbours `others`. */
void
appendWall(const ContourSample& sample,
           double half,
           const PlanCurve& curve,
           const std::vector<PlanCurve>& others,
           const PlanPoints& walls,
           double tolerance,
           std::vector<WeightedPoint>& points)
{
  const Eigen::Vector2d middle = curve.project(sample.position);
  const Eigen::Vector2d along = curve.tangentAt(middle);
  walls.forEachWithin(middle, std::hypot(tolerance, half), [&](const auto& p) {
    const bool is_at_corner =
        std::any_of(others.begin(), others.end(), [&](const PlanCurve& other) {
          return other.distance(p) < tolerance / 2;
        });
    if (std::abs((p - middle).dot(along)) <= half && !is_at_corner)
      points.push_back({p, 1});
  });
}

/** @brief Collects the evidence of a curve without that at its corners: points on a
 * next curve at an angle, and the samples near it. */
CurveEvidence
collectEvidence(const Assignment& a,
                std::size_t c,
                const std::vector<ContourSample>& samples,
                const PlanPoints& walls,
                const LoopParameters& parameters)
{
  const double tolerance = parameters.tolerance;
  const auto margin = static_cast<std::size_t>(parameters.priors.blur / 2);
  const std::size_t n = samples.size();
  const PlanCurve& curve = a.curves[c];
  CurveEvidence own;
  for (std::size_t i = 0; i < n; ++i) {
    if (a.curve_of[i] != c)
      continue;
    std::vector<PlanCurve> others;
    bool is_beside = false; // near a smooth transition to another curve
    for (const std::size_t other :
         {a.curve_of[(i + margin) % n], a.curve_of[(i + n - margin) % n]}) {
      if (other == c)
        continue;
      const PlanCurve& next = a.curves[other];
      const Eigen::Vector2d& p = samples[i].position;
      if (std::abs(next.tangentAt(p).dot(leftOf(curve.tangentAt(p)))) > 0.4)
        others.push_back(next);
      else
        is_beside = true;
    }
    if (is_beside)
      continue;
    if (others.empty())
      own.places.push_back({samples[i].position, samples[i].weight()});
    if (!samples[i].isSupported())
      continue;
    // Half of the distance to the next sample on each side, so that no point counts
    // twice.
    const double half = 0.5 * std::abs((samples[(i + 1) % n].place - samples[i].place)
                                           .dot(curve.tangentAt(samples[i].position))) +
                        1e-9;
    appendWall(samples[i], half, curve, others, walls, tolerance, own.walls);
  }
  return own;
}

/** @brief Returns whether a line fits the samples of an arc about as well, or well
 * within `tolerance`. */
bool
isStraight(const PlanCurve& arc,
           const std::vector<WeightedPoint>& places,
           double tolerance)
{
  if (places.size() < 3)
    return false;
  const PlanCurve line = fitLine(places);
  double arc_sum = 0;
  double line_sum = 0;
  for (const auto& p : places) {
    arc_sum += std::pow(arc.distance(p.position), 2);
    line_sum += std::pow(line.distance(p.position), 2);
  }
  return line_sum <= 1.2 * arc_sum ||
         line_sum < std::pow(0.4 * tolerance, 2) * static_cast<double>(places.size());
}

/** @brief Refits every curve in use to its evidence.
 * @param of_samples sampleTolerance() */
void
refit(Assignment& a,
      const std::vector<ContourSample>& samples,
      const PlanPoints& walls,
      double of_samples,
      const LoopParameters& parameters)
{
  std::vector<PlanCurve> fitted = a.curves;
  const auto fit = [&](std::size_t c) {
    const CurveEvidence own = collectEvidence(a, c, samples, walls, parameters);
    if (own.places.size() < 2)
      return;
    PlanCurve start = a.curves[c];
    if (start.isCircle() && isStraight(start, own.places, of_samples))
      start = fitLine(own.places);
    const auto& fitted_to =
        own.walls.size() >= 3 * own.places.size() ? own.walls : own.places;
    fitted[c] = fitRobustly(fitted_to, start, parameters.tolerance,
                            parameters.minimum_radius, parameters.maximum_radius);
  };
  parallelBlocks(a.curves.size() - a.known, 1, parameters.threads,
                 [&](std::size_t k, std::size_t) { fit(a.known + k); });
  a.curves = std::move(fitted);
}

/** @brief Removes the curves with fewer than `min_samples`. */
void
dropUnused(Assignment& a, std::size_t min_samples)
{
  const std::vector<std::size_t> followers = followersOf(a);
  std::vector<PlanCurve> kept;
  for (std::size_t c = 0; c < a.curves.size(); ++c)
    if (c < a.known || followers[c] >= min_samples)
      kept.push_back(a.curves[c]);
  if (!kept.empty())
    a.curves = std::move(kept);
}

/** @brief Proposes curves, then alternates between assigning samples and fitting curves
 * (PEARL, Isack and Boykov 2012). This removes duplicate and spurious curves. */
Assignment
findAssignment(const std::vector<ContourSample>& samples,
               const PlanPoints& walls,
               const std::vector<PlanCurve>& known,
               const LoopParameters& parameters)
{
  constexpr int rounds = 4;
  constexpr std::size_t min_samples = 2;
  LoopParameters search = parameters;
  search.tolerance = sampleTolerance(samples, parameters);
  Assignment a;
  a.curves = findCurves(samples, known, search);
  a.known = known.size();
  if (a.curves.empty())
    return a;
  const CurveAssignment assignment(samples, walls, search);
  for (int round = 0; round < rounds; ++round) {
    a.curve_of = assignment.assign(a.curves);
    refit(a, samples, walls, search.tolerance, parameters);
    dropUnused(a, min_samples);
  }
  a.curve_of = assignment.assign(a.curves);
  return a;
}

/** @brief Returns whether two runs lie on one curve, tested at the samples of both. */
bool
isSameCurve(const Run& a,
            const Run& b,
            const std::vector<ContourSample>& samples,
            double tolerance)
{
  if (a.curve.isCircle() != b.curve.isCircle())
    return false;
  const auto isOnBoth = [&](const Run& run, std::size_t k) {
    const Eigen::Vector2d p = samples[(run.first + k) % samples.size()].position;
    return (a.curve.project(p) - b.curve.project(p)).norm() < tolerance;
  };
  return isOnBoth(a, 0) && isOnBoth(a, a.count - 1) && isOnBoth(b, 0) &&
         isOnBoth(b, b.count - 1);
}

/** @brief Returns whether a run is spurious: a few samples between runs of one curve.
 */
bool
isBlur(const Run& before,
       const Run& run,
       const Run& after,
       const std::vector<ContourSample>& samples,
       const LoopParameters& parameters)
{
  return static_cast<double>(run.count) <= parameters.priors.blur &&
         isSameCurve(before, after, samples, parameters.tolerance / 2);
}

/** @brief Joins adjacent runs on one curve and removes spurious ones. */
std::vector<Run>
tidied(std::vector<Run> runs,
       const std::vector<ContourSample>& samples,
       const LoopParameters& parameters)
{
  for (std::size_t i = 0; i < runs.size() && runs.size() > 1;) {
    Run& before = runs[(i + runs.size() - 1) % runs.size()];
    const Run& after = runs[(i + 1) % runs.size()];
    const bool is_same =
        isSameCurve(before, runs[i], samples, parameters.tolerance / 2);
    if (!is_same &&
        (runs.size() < 4 || !isBlur(before, runs[i], after, samples, parameters))) {
      ++i;
      continue;
    }
    if (is_same && runs[i].count > before.count)
      before.curve = runs[i].curve;
    before.count += runs[i].count;
    runs.erase(runs.begin() + static_cast<std::ptrdiff_t>(i));
    i = 0;
  }
  return runs;
}

} // namespace

std::vector<Run>
findRuns(const std::vector<ContourSample>& samples,
         const PlanPoints& evidence,
         const std::vector<PlanCurve>& known,
         const LoopParameters& parameters)
{
  const Assignment assignment = findAssignment(samples, evidence, known, parameters);
  if (assignment.curves.empty())
    return {};
  return tidied(runsOf(assignment), samples, parameters);
}

} // namespace pcl::sedr
