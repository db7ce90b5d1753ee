// SPDX-License-Identifier: BSD-3-Clause
#include "plan_regularisation.h"

#include "../curves/plan_curves.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace pcl::sedr {

namespace {

/** @brief Proposes ties between the curves of a plan. */
class TieFinder {
public:
  TieFinder(const PlanCurves& plan, const RegularisationParameters& parameters)
      : plan_(plan)
      , parameters_(parameters)
      , max_(parameters.max_sigmas * parameters.max_sigmas)
  {}

  std::vector<CurveTie> find()
  {
    findTangents();
    findDirections();
    findCollinear();
    findRadii();
    return ties_;
  }

private:
  const PlanCurve& curve(std::size_t c) const { return plan_.curves[c].curve; }

  double contradictionOf(std::size_t a, std::size_t b, TieKind kind) const
  {
    return contradiction(plan_.curves[a], plan_.curves[b], kind);
  }

  /** @brief Returns the curves of a kind, the most accurate first. */
  std::vector<std::size_t> ordered(bool are_circles) const
  {
    std::vector<std::size_t> order;
    for (std::size_t c = 0; c < plan_.curves.size(); ++c)
      if (curve(c).isCircle() == are_circles)
        order.push_back(c);
    const Eigen::Index weight = are_circles ? 2 : 0;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return plan_.curves[a].information(weight, weight) >
             plan_.curves[b].information(weight, weight);
    });
    return order;
  }

  void findTangents()
  {
    for (const auto& loop : plan_.loops) {
      const auto& elements = loop.loop->elements;
      for (std::size_t i = 0; i < elements.size() && elements.size() > 1; ++i) {
        const std::size_t j = (i + 1) % elements.size();
        std::size_t a = loop.curves[i];
        std::size_t b = loop.curves[j];
        if (a == b || (!curve(a).isCircle() && !curve(b).isCircle()) ||
            !PlanCurves::meetSmoothly(elements[i], elements[j],
                                      parameters_.largest_tangent_angle))
          continue;
        if (curve(a).isCircle())
          std::swap(a, b);
        if (contradictionOf(a, b, TieKind::Tangent) <= max_)
          ties_.push_back({TieKind::Tangent, a, b});
      }
    }
  }

  /** @brief Ties every line to the reference line with the least contradiction. */
  void findDirections()
  {
    std::vector<std::size_t> references;
    for (const std::size_t c : ordered(false)) {
      double least = max_;
      CurveTie best;
      bool is_found = false;
      for (const std::size_t r : references)
        for (const TieKind kind : {TieKind::Parallel, TieKind::Perpendicular}) {
          const Eigen::Vector2d& other = curve(r).direction;
          const double sine = kind == TieKind::Parallel
                                  ? std::abs(leftOf(other).dot(curve(c).direction))
                                  : std::abs(other.dot(curve(c).direction));
          if (sine > parameters_.largest_angle)
            continue;
          const double contradicted = contradictionOf(r, c, kind);
          if (contradicted > least)
            continue;
          least = contradicted;
          best = {kind, r, c};
          is_found = true;
        }
      if (is_found)
        ties_.push_back(best);
      else
        references.push_back(c);
    }
  }

  /** @brief Ties collinear walls of one room. */
  void findCollinear()
  {
    constexpr double max_freedom = 1.3; // threshold of two equations relative to one
    std::vector<bool> is_tied(plan_.curves.size(), false);
    for (const auto& loop : plan_.loops) {
      if (!loop.is_boundary)
        continue;
      const auto& elements = loop.loop->elements;
      for (std::size_t i = 0; i < elements.size(); ++i)
        for (std::size_t j = i + 1; j < elements.size(); ++j) {
          const std::size_t a = loop.curves[i];
          const std::size_t b = loop.curves[j];
          const bool may_be = a != b && !is_tied[b] && !curve(a).isCircle() &&
                              !curve(b).isCircle() && curve(a).inliers > 0 &&
                              curve(b).inliers > 0 &&
                              (elements[i].end - elements[i].start)
                                      .dot(elements[j].end - elements[j].start) > 0;
          if (!may_be ||
              std::abs(leftOf(curve(a).direction).dot(curve(b).direction)) >
                  parameters_.largest_angle ||
              contradictionOf(a, b, TieKind::Collinear) > max_freedom * max_)
            continue;
          ties_.push_back({TieKind::Collinear, a, b});
          is_tied[b] = true;
        }
    }
  }

  void findRadii()
  {
    std::vector<std::size_t> references;
    for (const std::size_t c : ordered(true)) {
      double least = max_;
      std::size_t best = c;
      for (const std::size_t r : references) {
        const double contradicted = contradictionOf(r, c, TieKind::EqualRadius);
        if (contradicted > least || curve(r).inliers == 0 || curve(c).inliers == 0)
          continue;
        least = contradicted;
        best = r;
      }
      if (best == c)
        references.push_back(c);
      else
        ties_.push_back({TieKind::EqualRadius, best, c});
    }
  }

  const PlanCurves& plan_;
  const RegularisationParameters& parameters_;
  double max_;
  std::vector<CurveTie> ties_;
};

/** @brief Returns the move of a curve, in standard deviations. */
double
moveOf(const MeasuredCurve& from, const MeasuredCurve& to)
{
  Eigen::Vector3d step;
  if (from.curve.isCircle())
    step << to.curve.point - from.curve.point, to.curve.radius - from.curve.radius;
  else {
    const Eigen::Vector2d left = leftOf(from.curve.direction);
    const double turn = std::asin(std::clamp(left.dot(to.curve.direction), -1.0, 1.0));
    const Eigen::Vector2d shift =
        to.curve.project(from.pivot) - from.curve.project(from.pivot);
    step << turn, left.dot(shift), 0;
  }
  return std::sqrt(std::max(0.0, step.dot(from.information * step)));
}

bool
isTiedTo(const CurveTie& tie, std::size_t curve)
{
  return tie.a == curve || tie.b == curve;
}

RegularisationReport
reportOf(const std::vector<CurveTie>& ties)
{
  RegularisationReport report;
  for (const auto& tie : ties) {
    report.parallel +=
        tie.kind == TieKind::Parallel || tie.kind == TieKind::Perpendicular ? 1 : 0;
    report.collinear += tie.kind == TieKind::Collinear ? 1 : 0;
    report.tangent += tie.kind == TieKind::Tangent ? 1 : 0;
    report.equal_radius += tie.kind == TieKind::EqualRadius ? 1 : 0;
  }
  return report;
}

/** @brief Adjusts the curves. Removes the ties of curves that would move more than the
 * measurements allow, one curve at a time.
 * @return whether any ties remain */
bool
adjust(PlanCurves& plan,
       std::vector<CurveTie>& ties,
       const RegularisationParameters& parameters)
{
  while (!ties.empty()) {
    std::vector<MeasuredCurve> moved = plan.curves;
    std::size_t worst = 0;
    double most = parameters.max_sigmas;
    if (!adjustCurves(moved, ties)) {
      // The ties are infeasible; tangent ties are the most demanding.
      const auto last = std::find_if(ties.rbegin(), ties.rend(), [](const CurveTie& t) {
        return t.kind == TieKind::Tangent;
      });
      ties.erase(last == ties.rend() ? ties.end() - 1 : std::next(last).base());
      continue;
    }
    for (std::size_t c = 0; c < moved.size(); ++c) {
      const double move = moveOf(plan.curves[c], moved[c]);
      if (move <= most)
        continue;
      most = move;
      worst = c;
    }
    if (most <= parameters.max_sigmas) {
      plan.curves = std::move(moved);
      return true;
    }
    ties.erase(std::remove_if(ties.begin(), ties.end(),
                              [&](const CurveTie& t) { return isTiedTo(t, worst); }),
               ties.end());
  }
  return false;
}

/** @brief Removes the ties of all curves of a loop. */
void
release(const PlanCurves::Loop& loop, std::vector<CurveTie>& ties)
{
  ties.erase(std::remove_if(ties.begin(), ties.end(),
                            [&](const CurveTie& t) {
                              return std::any_of(
                                  loop.curves.begin(), loop.curves.end(),
                                  [&](std::size_t c) { return isTiedTo(t, c); });
                            }),
             ties.end());
}

} // namespace

RegularisationReport
regularisePlan(Floorplan& plan, const RegularisationParameters& parameters)
{
  constexpr int max_tries = 10;
  std::vector<CurveTie> ties =
      TieFinder(PlanCurves(plan, parameters.priors), parameters).find();
  for (int tries = 0; tries < max_tries; ++tries) {
    PlanCurves curves(plan, parameters.priors);
    if (!adjust(curves, ties, parameters))
      return {};
    for (const auto& tie : ties)
      if (tie.kind == TieKind::Tangent)
        curves.tangents.insert({std::min(tie.a, tie.b), std::max(tie.a, tie.b)});
    const std::vector<std::size_t> broken = curves.rebuild(parameters.farthest);
    if (broken.empty())
      return reportOf(ties);
    for (const std::size_t l : broken)
      release(curves.loops[l], ties);
  }
  return {};
}

} // namespace pcl::sedr
