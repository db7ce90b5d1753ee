// SPDX-License-Identifier: BSD-3-Clause
#include "detour_lines.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

namespace {

/** @brief A point of a zone as seen across lines of a direction. */
struct CrossPoint {
  double offset; ///< to the left of the origin
  double cost;   ///< on the path as it is

  bool operator<(const CrossPoint& other) const { return offset < other.offset; }
};

/** @brief A line that may be followed, and what it might save. */
struct Proposal {
  LoopLink link;
  double unexplained; ///< cost of the points on it as it is
};

/** @brief The densest lines of a direction through the points, where the path as it is
 * leaves some of them unexplained. `points` are used up. */
void
appendLines(const Eigen::Vector2d& direction,
            std::vector<CrossPoint>& points,
            double tolerance,
            double density,
            const Priors& priors,
            std::vector<Proposal>& lines)
{
  const double min_length = priors.element_cost; // a shorter one cannot pay
  const double min_unexplained = minGain(priors);
  constexpr std::size_t max_lines = 5;
  const double width = tolerance / 2;
  std::sort(points.begin(), points.end());
  for (std::size_t k = 0; k < max_lines && !points.empty(); ++k) {
    auto best_first = points.begin();
    auto best_last = points.begin();
    for (auto first = points.begin(), last = first; last != points.end(); ++last) {
      while (last->offset - first->offset > width)
        ++first;
      if (last - first > best_last - best_first) {
        best_first = first;
        best_last = last;
      }
    }
    double sum = 0;
    double cost = 0;
    for (auto it = best_first; it <= best_last; ++it) {
      sum += it->offset;
      cost += it->cost;
    }
    const auto count = static_cast<double>(best_last - best_first + 1);
    if (count < min_length * density)
      return;
    const double offset = sum / count;
    if (cost >= min_unexplained * density) {
      LoopLink link;
      link.curve.direction = direction;
      link.curve.point = offset * leftOf(direction);
      link.keeps_direction = true;
      lines.push_back({link, cost});
    }
    // What is beside the line is its noise.
    points.erase(std::lower_bound(points.begin(), points.end(),
                                  CrossPoint{offset - tolerance, 0}),
                 std::upper_bound(points.begin(), points.end(),
                                  CrossPoint{offset + tolerance, 0}));
  }
}

/** @brief Adds a link turned about its middle into the nearest of the directions. */
void
appendAligned(const LoopLink& link,
              const PlanElement& e,
              const std::vector<Eigen::Vector2d>& directions,
              std::vector<LoopLink>& lines)
{
  constexpr double largest_turn = 0.6; // sine
  double least = largest_turn;
  LoopLink aligned = link;
  for (const auto& d : directions) {
    const double turn = std::abs(leftOf(d).dot(link.curve.direction));
    if (turn >= least)
      continue;
    least = turn;
    aligned.curve.direction = d;
  }
  aligned.curve.point = (e.start + e.end) / 2;
  aligned.keeps_direction = true;
  aligned.is_bridge = false;
  if (least > 0.001 && least < largest_turn)
    lines.push_back(aligned);
}

/** @brief Whether a known curve is that of a link of the window. */
bool
isFollowed(const PlanCurve& curve, const LoopChain& chain, const Window& window)
{
  const auto is = [&](std::size_t i) {
    return chain.links[i].is_known && chain.links[i].curve.point == curve.point;
  };
  return is(window.before) || is(window.after) ||
         std::any_of(window.inner.begin(), window.inner.end(), is);
}

} // namespace

std::vector<LoopLink>
detourLines(const LoopChain& chain,
            const Window& window,
            const PathCost& cost,
            const PathCost::Zone& zone,
            const Guides& guides,
            const Priors& priors)
{
  constexpr std::size_t max_lines = 10;
  std::vector<Proposal> proposals;
  const std::vector<double> costs = cost.pointCosts(window.path, zone);
  for (const auto& direction : guides.directions) {
    std::vector<CrossPoint> points;
    for (std::size_t i = 0; i < zone.points.size(); ++i)
      points.push_back({zone.points[i].dot(leftOf(direction)), costs[i]});
    appendLines(direction, points, cost.tolerance(), zone.density, priors, proposals);
  }
  std::stable_sort(proposals.begin(), proposals.end(),
                   [](const Proposal& a, const Proposal& b) {
                     return a.unexplained > b.unexplained;
                   });
  std::vector<LoopLink> lines;
  for (std::size_t i = 0; i < std::min(max_lines, proposals.size()); ++i)
    lines.push_back(proposals[i].link);
  for (std::size_t k = 0; k < window.inner.size(); ++k) {
    const LoopLink& link = chain.links[window.inner[k]];
    if (link.curve.isCircle())
      continue;
    lines.push_back(link);
    if (!link.is_known)
      appendAligned(link, window.path[k + 1], guides.directions, lines);
  }
  for (const auto& curve : guides.known)
    if (!curve.isCircle() && curve.distance(window.middle) < window.radius &&
        !isFollowed(curve, chain, window)) {
      LoopLink link;
      link.curve = curve;
      link.is_known = true;
      lines.push_back(link);
    }
  return lines;
}

} // namespace pcl::sedr
