// SPDX-License-Identifier: BSD-3-Clause
#include "loop_bumps.h"

#include "sedr_filters/src/base/exactness.h"

#include "../curves/plan_curve.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace pcl::sedr {

namespace {

constexpr double min_cosine = 0.996; ///< of parallels: 5 degrees
constexpr double square = 0.17;      ///< cosine of what is square to a wall: 10 degrees

/** @brief Sides of a bump: a cable or a curtain has no more. */
constexpr std::size_t max_sides = 6;

Eigen::Vector2d
wayOf(const PlanElement& e)
{
  return (e.end - e.start).normalized();
}

/** @brief A wall, some sides, and a wall again, or the next one. */
struct Bump {
  PlanElement before;
  std::vector<PlanElement> sides;
  PlanElement after;

  /** @param first position of the wall before it */
  Bump(const PlanLoop& loop, std::size_t first, std::size_t count)
  {
    const auto at = [&](std::size_t i) {
      return loop.elements[i % loop.elements.size()];
    };
    before = at(first);
    for (std::size_t k = 1; k <= count; ++k)
      sides.push_back(at(first + k));
    after = at(first + count + 1);
  }

  bool isOne(double narrowest) const
  {
    const auto isWall = [&](const PlanElement& e) {
      return !e.isArc() && e.length() >= narrowest;
    };
    if (!isWall(before) || !isWall(after) || isSquare() ||
        std::any_of(sides.begin(), sides.end(),
                    [](const PlanElement& e) { return e.isArc(); }))
      return false;
    Eigen::Array2d low = Eigen::Array2d::Zero();
    Eigen::Array2d high = Eigen::Array2d::Zero();
    const auto hold = [&](const Eigen::Vector2d& p) {
      const Eigen::Vector2d to = p - before.end;
      const Eigen::Array2d place(wayOf(before).dot(to), leftOf(wayOf(before)).dot(to));
      low = low.min(place);
      high = high.max(place);
    };
    for (const PlanElement& side : sides)
      hold(side.end);
    if (!isAlongOneWall()) {
      const std::vector<Eigen::Vector2d> corner = corners();
      if (corner.empty() || wayOf(before).dot(wayOf(after)) < -min_cosine)
        return false;
      hold(corner.front());
    }
    if (!(high - low < narrowest).all())
      return false;
    const std::vector<PlanElement> straight = straightened();
    return wayOf(before).dot(straight.front().end - before.start) > 0 &&
           wayOf(after).dot(after.end - straight.back().start) > 0;
  }

  /** @brief The elements that stand for it. */
  std::vector<PlanElement> straightened() const
  {
    PlanElement first = before;
    PlanElement last = after;
    if (!isAlongOneWall()) {
      first.end = last.start = corners().front();
      return {first, last};
    }
    if (slant(sides.back()) <= slant(sides.front()))
      first.end = carrierOf(before).project(after.start);
    else
      last.start = carrierOf(after).project(before.end);
    if ((last.start - first.end).norm() > same_corner) {
      PlanElement step;
      step.start = first.end;
      step.end = last.start;
      return {first, step, last};
    }
    first.end = last.end;
    first.inliers += last.inliers;
    return {first};
  }

private:
  /** @brief How far from square to the wall a side is: the cosine of its angle. */
  double slant(const PlanElement& side) const
  {
    return std::abs(wayOf(before).dot(wayOf(side)));
  }

  bool isAlongOneWall() const { return wayOf(before).dot(wayOf(after)) >= min_cosine; }

  /** @brief Where the two walls meet. */
  std::vector<Eigen::Vector2d> corners() const
  {
    return intersections(carrierOf(before), carrierOf(after));
  }

  /** @brief Whether the sides are square to the wall, or along it: a side is short, and
   * its direction as uncertain either way. */
  bool isSquare() const
  {
    return std::all_of(sides.begin(), sides.end(), [&](const PlanElement& side) {
      return slant(side) < square || slant(side) > std::sqrt(1 - square * square);
    });
  }
};

} // namespace

int
dropBumps(PlanLoop& loop, double narrowest)
{
  int dropped = 0;
  std::vector<PlanElement>& elements = loop.elements;
  for (std::size_t i = 0; i < elements.size(); ++i)
    for (std::size_t count = 2;
         count <= max_sides && count + 3 <= elements.size() && i < elements.size();
         ++count) {
      const Bump bump(loop, i, count);
      if (!bump.isOne(narrowest))
        continue;
      const std::vector<PlanElement> straight = bump.straightened();
      std::rotate(elements.begin(), elements.begin() + static_cast<std::ptrdiff_t>(i),
                  elements.end());
      elements.erase(elements.begin(),
                     elements.begin() + static_cast<std::ptrdiff_t>(count + 2));
      elements.insert(elements.begin(), straight.begin(), straight.end());
      ++dropped;
      i = 0;
      count = 1;
    }
  return dropped;
}

} // namespace pcl::sedr
