// SPDX-License-Identifier: BSD-3-Clause
#include "dimension_chains.h"

#include "sheet_layout.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace pcl::sedr {
namespace {

constexpr double nowhere = std::numeric_limits<double>::infinity();

/** @brief What is visible at a place along a side: a wall, null for none, and its depth
 * there. */
struct Sight {
  const PlanElement* wall = nullptr;
  double depth = nowhere;
};

/** @brief Walls turned so that the side is at the bottom: x to the right along it, y
 * into the plan. */
class SideView {
public:
  SideView(const std::vector<PlanElement>& walls, const Eigen::Vector2d& off)
  {
    frame_.turn = -M_PI / 2 - std::atan2(off.y(), off.x());
    for (const PlanElement& wall : walls)
      walls_.push_back(frame_(wall));
  }

  Eigen::Vector2d toPlan(const Eigen::Vector2d& p) const { return frame_.toPlan(p); }

  /** @brief Returns the ends of walls along the side, sorted. */
  std::vector<double> ends() const
  {
    std::vector<double> ends;
    for (const PlanElement& e : walls_) {
      ends.push_back(e.start.x());
      ends.push_back(e.end.x());
      // The extremes of an arc are two points of its circle.
      for (const double sign : {-1.0, 1.0}) {
        const Eigen::Vector2d place = e.centre + Eigen::Vector2d(sign * e.radius, 0);
        if (e.isArc() && e.distance(place) < 1e-6 * e.radius)
          ends.push_back(place.x());
      }
    }
    std::sort(ends.begin(), ends.end());
    return ends;
  }

  Sight sightAt(double x) const
  {
    Sight nearest;
    for (const PlanElement& wall : walls_) {
      const double depth = depthAt(wall, x);
      if (depth < nearest.depth)
        nearest = {&wall, depth};
    }
    return nearest;
  }

private:
  static double depthAt(const PlanElement& e, double x)
  {
    if (!e.isArc()) {
      const double share = (x - e.start.x()) / (e.end.x() - e.start.x());
      return share >= 0 && share <= 1 ? e.start.y() + share * (e.end.y() - e.start.y())
                                      : nowhere;
    }
    const double half = e.radius * e.radius - (x - e.centre.x()) * (x - e.centre.x());
    for (const double sign : {-1.0, 1.0}) {
      const double y = e.centre.y() + sign * std::sqrt(std::max(half, 0.0));
      if (half > 0 && e.distance({x, y}) < 1e-6 * e.radius)
        return y;
    }
    return nowhere;
  }

  PlanFrame frame_;
  std::vector<PlanElement> walls_;
};

/** @brief Returns whether one wall goes on as another, as a straight one in two parts.
 */
bool
goesOn(const Sight& before, const Sight& after)
{
  constexpr double off = 0.01; // metres
  if (before.wall == after.wall)
    return true;
  if (!before.wall || !after.wall || before.wall->isArc() || after.wall->isArc())
    return false;
  const auto line =
      Eigen::Hyperplane<double, 2>::Through(before.wall->start, before.wall->end);
  return line.absDistance(after.wall->start) < off &&
         line.absDistance(after.wall->end) < off;
}

/** @brief Returns the ends with a minimum distance, including the first and last
 * one. */
std::vector<double>
placesOf(const std::vector<double>& ends, double least)
{
  std::vector<double> places;
  for (const double x : ends)
    if (places.empty() || x - places.back() >= least)
      places.push_back(x);
  if (places.size() > 1)
    places.back() = ends.back();
  return places;
}

/** @brief Returns whether two chains have the same dimensions. */
bool
areAlike(const DimensionChain& a, const DimensionChain& b, double least)
{
  if (a.places.size() != b.places.size())
    return false;
  for (std::size_t k = 0; k < a.places.size(); ++k)
    if (std::abs(a.along(k) - b.along(k)) > least)
      return false;
  return true;
}

/** @brief Removes places until no two neighbouring dimensions are both shorter than
 * `room`, as on ragged walls; the shortest pair first. A single short one, such as a
 * wall thickness, stays. */
void
thinOut(DimensionChain& chain, double room)
{
  while (true) {
    std::size_t shortest = 0;
    double least = nowhere;
    for (std::size_t k = 1; k + 1 < chain.places.size(); ++k) {
      const double before = chain.along(k) - chain.along(k - 1);
      const double after = chain.along(k + 1) - chain.along(k);
      if (std::max(before, after) < room && before + after < least) {
        least = before + after;
        shortest = k;
      }
    }
    if (shortest == 0)
      return;
    chain.places.erase(chain.places.begin() + static_cast<std::ptrdiff_t>(shortest));
  }
}

/** @brief Returns the corners of walls that are visible from a side, in order. What
 * lies behind a gap that is no wider than a wall does not count. */
DimensionChain
chainAlong(const std::vector<PlanElement>& walls,
           const Eigen::Vector2d& side,
           double max_wall,
           double least)
{
  const SideView view(walls, side);
  const std::vector<double> places = placesOf(view.ends(), least);
  std::vector<Sight> sights{{}}; // before, between and after the places
  for (std::size_t k = 0; k + 1 < places.size(); ++k)
    sights.push_back(view.sightAt((places[k] + places[k + 1]) / 2));
  sights.emplace_back();
  for (std::size_t first = 1; first + 1 < sights.size(); ++first) {
    const double rim = sights[first - 1].depth + max_wall;
    std::size_t last = first; // sights[first] to sights[last - 1] are in a gap
    while (last + 1 < sights.size() && sights[last].depth > rim)
      ++last;
    if (sights[last].wall && last > first &&
        places[last - 1] - places[first - 1] <= max_wall)
      std::fill(sights.begin() + static_cast<std::ptrdiff_t>(first),
                sights.begin() + static_cast<std::ptrdiff_t>(last), Sight{});
  }
  DimensionChain chain{side, {}};
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (goesOn(sights[k], sights[k + 1]))
      continue;
    // Where walls meet, the nearer of their ends.
    const double off = least / 4;
    double depth = std::min(view.sightAt(places[k] - off).depth,
                            view.sightAt(places[k] + off).depth);
    if (depth == nowhere)
      depth = std::min(sights[k].depth, sights[k + 1].depth);
    chain.places.push_back(view.toPlan({places[k], depth}));
  }
  std::sort(chain.places.begin(), chain.places.end(),
            [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
              return a.dot(wayAlong(side)) < b.dot(wayAlong(side));
            });
  return chain;
}

} // namespace

std::vector<DimensionChain>
wallChains(const std::vector<PlanElement>& walls,
           double max_wall,
           double least,
           double room)
{
  std::vector<DimensionChain> chains;
  for (const Eigen::Vector2d& side : {Eigen::Vector2d(0, -1), Eigen::Vector2d(-1, 0)}) {
    DimensionChain first = chainAlong(walls, side, max_wall, least);
    DimensionChain second = chainAlong(walls, -side, max_wall, least);
    thinOut(first, room);
    thinOut(second, room);
    if (first.places.size() > 2)
      chains.push_back(first);
    if (second.places.size() > 2 && !areAlike(first, second, least))
      chains.push_back(second);
  }
  return chains;
}

} // namespace pcl::sedr
