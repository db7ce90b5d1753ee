// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_segmentation/loop_fit.h>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace sedr {

namespace {

/** @brief Samples first .. first + count - 1 (around the loop) that follow one curve.
 */
struct Run {
  PlanCurve curve;
  std::size_t first = 0;
  std::size_t count = 0;
};

/** @brief The curves of a loop and which of them each sample follows. */
struct Assignment {
  std::vector<PlanCurve> curves;
  std::size_t known = 0; ///< so many of the curves, the first ones, stay as they are
  std::vector<std::size_t> curve_of;
};

std::vector<Run>
runsOf(const Assignment& a)
{
  const std::size_t n = a.curve_of.size();
  std::size_t start = 0;
  while (start < n && a.curve_of[start] == a.curve_of[(start + n - 1) % n])
    ++start;
  if (start == n)
    return {{a.curves[a.curve_of[0]], 0, n}};
  std::vector<Run> runs;
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = (start + k) % n;
    if (k == 0 || a.curve_of[i] != a.curve_of[(i + n - 1) % n])
      runs.push_back({a.curves[a.curve_of[i]], i, 0});
    ++runs.back().count;
  }
  return runs;
}

/** @brief What a curve is fitted to: the points of the wall along the samples that
 * follow it, and these samples themselves. */
struct CurveEvidence {
  std::vector<WeightedPoint> walls;
  std::vector<WeightedPoint> places;
};

/** @brief Collects the evidence of all curves. The samples beside a change of curve are
 * left out: they belong to the corner. */
std::vector<CurveEvidence>
collectEvidence(const Assignment& a,
                const std::vector<ContourSample>& samples,
                const PlanPoints& walls,
                double tolerance)
{
  constexpr std::size_t margin = 2;
  const std::size_t n = samples.size();
  std::vector<CurveEvidence> evidence(a.curves.size());
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t c = a.curve_of[i];
    CurveEvidence& own = evidence[c];
    if (a.curve_of[(i + margin) % n] != c || a.curve_of[(i + n - margin) % n] != c)
      continue;
    own.places.push_back({samples[i].position, samples[i].weight()});
    if (!samples[i].isSupported())
      continue;
    const Eigen::Vector2d middle = a.curves[c].project(samples[i].position);
    const Eigen::Vector2d along = a.curves[c].tangentAt(middle);
    // Half of the way to the next sample on each side, so that no point counts twice.
    const double half =
        0.5 *
            std::abs((samples[(i + 1) % n].position - samples[i].position).dot(along)) +
        1e-9;
    walls.forEachWithin(middle, std::hypot(tolerance, half), [&](const auto& p) {
      if (std::abs((p - middle).dot(along)) <= half)
        own.walls.push_back({p, 1});
    });
  }
  return evidence;
}

/** @brief Whether an arc does no better than a line: it hardly bends along its samples.
 */
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
         line_sum < std::pow(tolerance / 5, 2) * static_cast<double>(places.size());
}

/** @brief Fits every curve that is in use anew to all that follows it. */
void
refit(Assignment& a,
      const std::vector<ContourSample>& samples,
      const PlanPoints& walls,
      const LoopParameters& parameters)
{
  const std::vector<CurveEvidence> evidence =
      collectEvidence(a, samples, walls, parameters.tolerance);
  for (std::size_t c = a.known; c < a.curves.size(); ++c) {
    const CurveEvidence& own = evidence[c];
    if (own.places.size() < 2)
      continue;
    PlanCurve start = a.curves[c];
    if (start.isCircle() && isStraight(start, own.places, parameters.tolerance))
      start = fitLine(own.places);
    const auto& fitted_to =
        own.walls.size() >= 3 * own.places.size() ? own.walls : own.places;
    a.curves[c] = fitRobustly(fitted_to, start, parameters.tolerance,
                              parameters.minimum_radius, parameters.maximum_radius);
  }
}

/** @brief Keeps the curves that enough samples follow. */
void
dropUnused(Assignment& a, std::size_t least_samples)
{
  std::vector<std::size_t> followers(a.curves.size(), 0);
  for (const std::size_t c : a.curve_of)
    ++followers[c];
  std::vector<PlanCurve> kept(a.curves.begin(),
                              a.curves.begin() + static_cast<std::ptrdiff_t>(a.known));
  for (std::size_t c = a.known; c < a.curves.size(); ++c)
    if (followers[c] >= least_samples)
      kept.push_back(a.curves[c]);
  if (!kept.empty())
    a.curves = std::move(kept);
}

/** @brief Proposes curves, then assigns samples and fits the curves in turn (as Isack
 * and Boykov's PEARL, 2012, does), so that doubles and accidents of the first search
 * go. */
Assignment
findAssignment(const std::vector<ContourSample>& samples,
               const PlanPoints& walls,
               const std::vector<PlanCurve>& known,
               const LoopParameters& parameters)
{
  constexpr int rounds = 3;
  constexpr std::size_t least_samples = 3;
  LoopParameters search = parameters;
  search.tolerance = sampleTolerance(samples, parameters);
  Assignment a;
  a.curves = findCurves(samples, known, search);
  a.known = known.size();
  if (a.curves.empty())
    return a;
  for (int round = 0; round < rounds; ++round) {
    a.curve_of = assignCurves(samples, a.curves, search);
    refit(a, samples, walls, parameters);
    dropUnused(a, least_samples);
  }
  a.curve_of = assignCurves(samples, a.curves, search);
  return a;
}

/** @brief Whether two runs lie on one curve, seen from the samples of both. */
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

/** @brief A run of so many samples cannot be told from the blur of a corner. */
constexpr std::size_t blur = 4;

/** @brief Whether a run is a blur only: short, and its neighbours lie on one curve or
 * meet near by without it. */
bool
isBlur(const Run& before,
       const Run& run,
       const Run& after,
       const std::vector<ContourSample>& samples,
       const LoopParameters& parameters)
{
  if (run.count > blur)
    return false;
  if (isSameCurve(before, after, samples, parameters.tolerance / 2))
    return true;
  const Eigen::Vector2d place =
      samples[(run.first + run.count / 2) % samples.size()].position;
  const Eigen::Vector2d a = before.curve.tangentAt(place);
  const Eigen::Vector2d b = after.curve.tangentAt(place);
  if (std::abs(a.x() * b.y() - a.y() * b.x()) < 0.25)
    return false;
  const std::vector<Eigen::Vector2d> meetings =
      intersections(before.curve, after.curve);
  return std::any_of(meetings.begin(), meetings.end(), [&](const Eigen::Vector2d& p) {
    return (p - place).norm() < parameters.corner_reach;
  });
}

/** @brief Joins neighbouring runs that lie on one curve, and takes out blurs. */
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

/** @brief Where two neighbouring curves join: one corner, or two with a short piece
 * between where they do not meet nearby. */
std::vector<Eigen::Vector2d>
joint(const Run& a,
      const Run& b,
      const Eigen::Vector2d& place,
      const LoopParameters& parameters)
{
  const double farthest = 4 * parameters.corner_reach;
  const Eigen::Vector2d on_a = a.curve.project(place);
  const Eigen::Vector2d on_b = b.curve.project(place);
  const double sine =
      std::abs(a.curve.tangentAt(place).x() * b.curve.tangentAt(place).y() -
               a.curve.tangentAt(place).y() * b.curve.tangentAt(place).x());
  const bool is_offset = sine < 0.25 && (on_a - on_b).norm() > parameters.tolerance;
  std::vector<Eigen::Vector2d> corner;
  double nearest = farthest;
  if (!is_offset)
    for (const auto& p : intersections(a.curve, b.curve))
      if ((p - place).norm() < nearest) {
        nearest = (p - place).norm();
        corner = {p};
      }
  if (corner.empty())
    corner = {on_a, on_b};
  return corner;
}

PlanElement
segment(const Eigen::Vector2d& start, const Eigen::Vector2d& end)
{
  PlanElement e;
  e.start = start;
  e.end = end;
  return e;
}

/** @brief The part of a run's curve between two corners; an arc runs the way its
 * samples do. */
PlanElement
elementOf(const Run& run,
          const Eigen::Vector2d& start,
          const Eigen::Vector2d& end,
          const std::vector<ContourSample>& samples)
{
  PlanElement e = segment(start, end);
  e.inliers = run.curve.inliers;
  e.residual = run.curve.residual;
  if (!run.curve.isCircle())
    return e;
  double turn = 0;
  for (std::size_t k = 0; k < run.count; ++k) {
    const ContourSample& s = samples[(run.first + k) % samples.size()];
    const Eigen::Vector2d outward = s.position - run.curve.point;
    turn += outward.x() * s.tangent.y() - outward.y() * s.tangent.x();
  }
  e.centre = run.curve.point;
  e.radius = run.curve.radius;
  e.counter_clockwise = turn > 0;
  return e;
}

PlanLoop
wholeCircle(const Run& run, const std::vector<ContourSample>& samples)
{
  const Eigen::Vector2d start = run.curve.project(samples[run.first].position);
  return {{elementOf(run, start, start, samples)}};
}

/** @brief Joins the runs to a closed loop. */
PlanLoop
join(const std::vector<Run>& runs,
     const std::vector<ContourSample>& samples,
     const LoopParameters& parameters)
{
  std::vector<std::vector<Eigen::Vector2d>> joints; // joints[i] after runs[i]
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const Run& next = runs[(r + 1) % runs.size()];
    const std::size_t last = (next.first + samples.size() - 1) % samples.size();
    const Eigen::Vector2d place =
        (samples[last].position + samples[next.first].position) / 2;
    joints.push_back(joint(runs[r], next, place, parameters));
  }
  PlanLoop loop;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const auto& before = joints[(r + runs.size() - 1) % runs.size()];
    const auto& after = joints[r];
    loop.elements.push_back(elementOf(runs[r], before.back(), after.front(), samples));
    if (after.size() > 1)
      loop.elements.push_back(segment(after.front(), after.back()));
  }
  return loop;
}

/** @brief Whether no segment runs backwards against the samples that it was made from.
 */
bool
runsForward(const PlanLoop& loop)
{
  return std::none_of(loop.elements.begin(), loop.elements.end(),
                      [](const PlanElement& e) {
                        return e.isArc() && std::abs(e.sweep()) > 1.95 * M_PI &&
                               (e.start - e.end).norm() > 1e-9;
                      });
}

/** @brief Whether the loop is a sound outline of the contour: it does not cross itself,
 * and its area is that of the contour but for a rim. */
bool
isSound(const PlanLoop& loop, const Contour& contour, const LoopParameters& parameters)
{
  if (loop.elements.empty() || !runsForward(loop))
    return false;
  const std::vector<Eigen::Vector2d> polygon = loop.polygon(0.005);
  if (polygon.size() < 3 || crossesItself(polygon))
    return false;
  const double area = signedArea(contour);
  const double rim = parameters.corner_reach * loop.length() + 0.01;
  return std::abs(loop.area() - area) < std::min(rim, 0.5 * std::abs(area) + 0.01) &&
         (loop.area() > 0) == (area > 0);
}

/** @brief The contour itself, its staircase evened out. */
PlanLoop
polygonLoop(const std::vector<ContourSample>& samples, double tolerance)
{
  std::vector<Eigen::Vector2d> places;
  for (const auto& s : samples)
    places.push_back(s.position);
  PlanLoop loop;
  const std::vector<Eigen::Vector2d> corners = simplified(places, tolerance);
  for (std::size_t i = 0; i < corners.size(); ++i)
    loop.elements.push_back(segment(corners[i], corners[(i + 1) % corners.size()]));
  return loop;
}

/** @brief Drops elements of no length, and closes the gaps they leave. */
void
dropPoints(PlanLoop& loop)
{
  auto& elements = loop.elements;
  for (std::size_t i = 0; i < elements.size() && elements.size() > 2;) {
    PlanElement& e = elements[i];
    if (e.isArc() || e.length() > 1e-6) {
      ++i;
      continue;
    }
    elements[(i + 1) % elements.size()].start = e.start;
    elements.erase(elements.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

} // namespace

PlanLoop
fitLoop(const Contour& contour,
        const PlanPoints& evidence,
        const std::vector<PlanCurve>& known,
        const LoopParameters& parameters,
        std::vector<ContourSample>* places)
{
  if (contour.size() < 4)
    return {};
  const std::vector<ContourSample> samples =
      sampleContour(contour, evidence, parameters);
  if (places)
    *places = samples;
  const Assignment assignment = findAssignment(samples, evidence, known, parameters);
  if (!assignment.curves.empty()) {
    const std::vector<Run> runs = tidied(runsOf(assignment), samples, parameters);
    PlanLoop loop;
    if (runs.size() > 1)
      loop = join(runs, samples, parameters);
    else if (runs[0].curve.isCircle())
      loop = wholeCircle(runs[0], samples);
    dropPoints(loop);
    if (isSound(loop, contour, parameters))
      return loop;
  }
  for (const double tolerance : {parameters.tolerance, 0.0}) {
    const PlanLoop loop = polygonLoop(samples, tolerance);
    if (isSound(loop, contour, parameters))
      return loop;
  }
  PlanLoop staircase;
  const std::vector<Eigen::Vector2d> corners = simplified(contour, 1e-9);
  for (std::size_t i = 0; i < corners.size(); ++i)
    staircase.elements.push_back(
        segment(corners[i], corners[(i + 1) % corners.size()]));
  return staircase;
}

} // namespace sedr
} // namespace pcl
