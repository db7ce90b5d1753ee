// SPDX-License-Identifier: BSD-3-Clause
#include "loop_corners.h"

#include "sedr_filters/src/base/exactness.h"

#include "../curves/contour.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace pcl::sedr {

namespace {

using UnknownPair = std::pair<std::size_t, std::size_t>;

/** @brief Returns the point where two tangent curves touch. */
Eigen::Vector2d
touchOf(const PlanCurve& a, const PlanCurve& b)
{
  if (!a.isCircle() || !b.isCircle())
    return a.isCircle() ? b.project(a.point) : a.project(b.point);
  // Seen from the larger circle's centre, the point lies in the direction of the
  // smaller one's centre, beyond it if inside.
  return a.radius < b.radius ? b.project(a.point) : a.project(b.point);
}

class LoopBuilder {
public:
  LoopBuilder(const PlanUnknowns& plan,
              const std::vector<PlanTie>& ties,
              double farthest)
      : plan_(plan)
      , farthest_(farthest)
  {
    for (const PlanTie& tie : ties)
      if (tie.kind == PlanTieKind::Tangent)
        tangents_.insert(std::minmax(tie.a, tie.b));
  }

  /** @brief Rebuilds a loop; returns the indices of the elements at which it would
   * break. */
  std::vector<std::size_t> build(const UnknownLoop& loop, PlanLoop& result) const
  {
    result = *loop.loop;
    auto& elements = result.elements;
    const std::size_t n = elements.size();
    std::vector<std::size_t> broken;
    for (std::size_t i = 0; i < n; ++i) {
      Eigen::Vector2d corner;
      if (cornerOf(loop, i, corner)) {
        elements[i].start = corner;
        elements[(i + n - 1) % n].end = corner;
      }
      else
        broken.insert(broken.end(), {i, (i + n - 1) % n});
    }
    for (std::size_t i = 0; i < n && broken.empty(); ++i) {
      PlanElement& e = elements[i];
      const PlanElement& old = loop.loop->elements[i];
      const Unknown& u = plan_.all[loop.of_element[i]];
      if (e.isArc()) {
        e.centre = u.point;
        e.radius = u.radius;
      }
      const bool is_turned = e.isArc()
                                 ? std::abs(e.sweep() - old.sweep()) > 0.5
                                 : (e.end - e.start).dot(old.end - old.start) <= 0;
      if (is_turned || (e.length() < same_line && old.length() >= same_line))
        broken = {(i + n - 1) % n, i, (i + 1) % n};
    }
    if (broken.empty() && crossesItself(result.polygon(chord)) &&
        !crossesItself(loop.loop->polygon(chord)))
      for (std::size_t i = 0; i < n; ++i)
        broken.push_back(i);
    return broken;
  }

private:
  /** @brief Finds the start of an element.
   * @return false if the curves do not meet near the old corner */
  bool cornerOf(const UnknownLoop& loop, std::size_t i, Eigen::Vector2d& corner) const
  {
    const auto& elements = loop.loop->elements;
    const std::size_t n = elements.size();
    const Eigen::Vector2d& old = elements[i].start;
    const std::size_t a = loop.of_element[(i + n - 1) % n];
    const std::size_t b = loop.of_element[i];
    const PlanCurve before = plan_.all[a].curve();
    const PlanCurve after = plan_.all[b].curve();
    if (a == b) {
      corner = after.project(old);
      return (corner - old).norm() <= farthest_;
    }
    if (tangents_.count(std::minmax(a, b)) > 0) {
      // The place of a smooth joint along the curves is uncertain.
      corner = touchOf(before, after);
      return elements[i].distance(corner) <= farthest_ ||
             elements[(i + n - 1) % n].distance(corner) <= farthest_;
    }
    const double sine =
        std::abs(before.tangentAt(old).dot(leftOf(after.tangentAt(old))));
    double nearest = farthest_ / std::max(sine, 0.3);
    bool is_found = false;
    for (const Eigen::Vector2d& p : intersections(before, after)) {
      if ((p - old).norm() > nearest)
        continue;
      nearest = (p - old).norm();
      corner = p;
      is_found = true;
    }
    if (!is_found && sine < 1e-6) { // two parts of one line, tied
      corner = after.project(old);
      is_found = before.distance(corner) < same_place;
    }
    return is_found;
  }

  const PlanUnknowns& plan_;
  double farthest_;
  std::set<UnknownPair> tangents_;
};

} // namespace

std::vector<std::size_t>
rebuildLoops(const PlanUnknowns& plan,
             const std::vector<PlanTie>& ties,
             const std::vector<bool>& are_kept,
             double farthest)
{
  const LoopBuilder builder(plan, ties, farthest);
  std::vector<std::size_t> broken;
  std::vector<PlanLoop> results(plan.loops.size());
  for (std::size_t l = 0; l < results.size(); ++l) {
    const std::vector<std::size_t>& of = plan.loops[l].of_element;
    const auto isKept = [&](std::size_t u) { return are_kept[u]; };
    if (std::all_of(of.begin(), of.end(), isKept)) {
      results[l] = *plan.loops[l].loop;
      continue;
    }
    std::vector<std::size_t> at;
    for (const std::size_t i : builder.build(plan.loops[l], results[l]))
      at.push_back(of[i]);
    if (std::all_of(at.begin(), at.end(), isKept) && !at.empty())
      at = of;
    broken.insert(broken.end(), at.begin(), at.end());
  }
  if (broken.empty())
    for (std::size_t l = 0; l < results.size(); ++l)
      *plan.loops[l].loop = std::move(results[l]);
  return broken;
}

} // namespace pcl::sedr
