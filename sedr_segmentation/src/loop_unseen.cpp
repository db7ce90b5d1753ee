// SPDX-License-Identifier: BSD-3-Clause
#include "loop_unseen.h"

#include "link_fit.h"
#include "loop_window.h"
#include "main_directions.h"

#include <algorithm>
#include <cmath>

namespace pcl {
namespace sedr {

namespace {

/** @brief Points along every link, for each metre. */
std::vector<double>
densitiesOf(const LoopChain& chain, const PlanPoints& evidence, double tolerance)
{
  constexpr double least_length = 0.01;
  std::vector<double> densities;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const double length = chain.element(i).length();
    densities.push_back(
        length < least_length
            ? 0
            : static_cast<double>(pointsAlong(chain, i, evidence, tolerance).size()) /
                  length);
  }
  return densities;
}

/** @brief Which links are seen less than one in twenty of what is usual: half of the
 * loop's length is seen better than that. */
std::vector<bool>
unseenLinks(const LoopChain& chain, const PlanPoints& evidence, double tolerance)
{
  constexpr double least_share = 0.05;
  const std::vector<double> densities = densitiesOf(chain, evidence, tolerance);
  std::vector<std::pair<double, double>> ordered; // and lengths
  double all = 0;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    ordered.emplace_back(densities[i], chain.element(i).length());
    all += ordered.back().second;
  }
  std::sort(ordered.begin(), ordered.end());
  double usual = 0;
  double length = 0;
  for (const auto& [density, own] : ordered) {
    length += own;
    usual = density;
    if (2 * length >= all)
      break;
  }
  std::vector<bool> unseen;
  for (std::size_t i = 0; i < chain.size(); ++i)
    unseen.push_back(usual > 0 && densities[i] < least_share * usual &&
                     !chain.links[i].is_known);
  return unseen;
}

std::vector<Eigen::Vector2d>
directionsSeen(const LoopChain& chain, const std::vector<bool>& unseen)
{
  std::vector<DirectedLine> lines;
  for (std::size_t i = 0; i < chain.size(); ++i)
    if (!unseen[i] && !chain.links[i].curve.isCircle())
      lines.push_back({chain.element(i).length(), chain.links[i].curve.direction});
  return mainDirections(std::move(lines));
}

/** @brief Turns a line to the nearest of some directions; false where none is near. */
bool
turnTo(const std::vector<Eigen::Vector2d>& directions, PlanCurve& line)
{
  double nearest = 0.35; // radians
  Eigen::Vector2d best = line.direction;
  for (const auto& d : directions) {
    const double turn =
        std::asin(std::min(1.0, std::abs(leftOf(d).dot(line.direction))));
    if (turn >= nearest)
      continue;
    nearest = turn;
    best = d.dot(line.direction) < 0 ? Eigen::Vector2d(-d) : d;
  }
  const bool is_found = nearest < 0.35;
  line.direction = best;
  return is_found;
}

/** @brief Shifts a line to where the contour beside an element reaches farthest
 * outwards, but for a few samples. */
void
shiftOutwards(const PlanElement& e,
              const std::vector<ContourSample>& samples,
              const LoopParameters& parameters,
              PlanCurve& line)
{
  constexpr double few = 0.03;
  constexpr double reach = 0.6; // metres
  constexpr double least_cosine = 0.9;
  std::vector<double> outwards;
  const Eigen::Vector2d way = (e.end - e.start).normalized();
  for (const auto& s : samples) {
    const double along = (s.place - e.start).dot(way);
    if (along > 0 && along < e.length() && e.distance(s.place) < reach &&
        s.tangent.dot(way) > least_cosine)
      outwards.push_back(leftOf(line.direction).dot(line.point - s.place));
  }
  if (outwards.empty())
    return;
  std::sort(outwards.begin(), outwards.end());
  const auto at =
      static_cast<std::size_t>((1 - few) * static_cast<double>(outwards.size() - 1));
  // Cells at a wall that is seen are its own; where it is not, they reach beyond it.
  line.point -= (outwards[at] + parameters.expected_offset) * leftOf(line.direction);
}

/** @brief The straight way between the corners of a link. */
LoopLink
chordOf(const LoopChain& chain, std::size_t i)
{
  LoopLink chord;
  chord.curve = lineThrough(chain.corners[i], chain.corners[chain.after(i)]);
  return chord;
}

} // namespace

void
squareUnseenLinks(LoopChain& chain,
                  const std::vector<ContourSample>& samples,
                  const PlanPoints& evidence,
                  const LoopParameters& parameters)
{
  constexpr double least_length = 0.2; // a shorter one is between what was seen
  if (chain.size() < 3)
    return;
  const std::vector<bool> unseen = unseenLinks(chain, evidence, parameters.tolerance);
  const std::vector<Eigen::Vector2d> directions = directionsSeen(chain, unseen);
  for (std::size_t i = 0; i < chain.size(); ++i) {
    if (!unseen[i])
      continue;
    const PlanElement e = chain.element(i);
    if (e.length() < least_length)
      continue;
    if (chain.links[i].curve.isCircle())
      chain.links[i] = chordOf(chain, i);
    LoopLink link = chain.links[i];
    link.curve.point = link.curve.project((e.start + e.end) / 2);
    if (!turnTo(directions, link.curve))
      continue;
    shiftOutwards(e, samples, parameters, link.curve);
    link.is_bridge = false;
    const std::size_t before = chain.before(i);
    const std::size_t after = chain.after(i);
    LoopChain turned = chain;
    turned.links[i] = link;
    if (!findCorner(chain.links[before].curve, link.curve, e.start, parameters,
                    turned.corners[i]) ||
        !findCorner(link.curve, chain.links[after].curve, e.end, parameters,
                    turned.corners[after]))
      continue;
    const auto isForward = [&](std::size_t k) {
      return runsForward(turned.links[k], turned.element(k), 1e-4);
    };
    if (isForward(before) && isForward(i) && isForward(after))
      chain = std::move(turned);
  }
}

} // namespace sedr
} // namespace pcl
