// SPDX-License-Identifier: BSD-3-Clause
#include "dimension_rows.h"

#include "../mesh/mesh_outlines.h"
#include "sedr_filters/src/plan/plan_geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::sedr {
namespace {

constexpr double nowhere = std::numeric_limits<double>::infinity();

/** @brief The wall that is visible at a place along a side, null for none, and its
 * depth there. */
struct Sight {
  const PlanElement* wall = nullptr;
  double depth = nowhere;
};

double
depthAt(const PlanElement& e, double x)
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

/** @brief Walls turned so that the side is at the bottom: x to the right along it, y
 * into the plan. Between the `ends` of walls, one of them is visible, or none. */
class SideView {
public:
  SideView(const std::vector<PlanElement>& walls, const Eigen::Vector2d& off)
  {
    frame_.turn = -M_PI / 2 - std::atan2(off.y(), off.x());
    for (const PlanElement& wall : walls) {
      const PlanElement turned = frame_(wall);
      Eigen::AlignedBox2d box = boundsOf({{turned}}); // with the extremes of an arc
      box.extend(turned.end);
      walls_.push_back({turned, box.min().x(), box.max().x()});
      for (const auto& place : {turned.start, turned.end, box.min(), box.max()})
        ends.push_back(place.x());
    }
    std::sort(walls_.begin(), walls_.end(),
              [](const Wall& a, const Wall& b) { return a.low < b.low; });
    std::sort(ends.begin(), ends.end());
    const auto is_same = [](double a, double b) { return b - a < 2 * hair; };
    ends.erase(std::unique(ends.begin(), ends.end(), is_same), ends.end());
    findSights();
  }

  Eigen::Vector2d toPlan(const Eigen::Vector2d& p) const { return frame_.toPlan(p); }

  /** @brief Returns the depth of what is visible before or after an end. */
  double depthBeside(std::size_t end, bool is_after) const
  {
    const Sight& sight = sights[is_after ? end + 1 : end];
    if (!sight.wall)
      return nowhere;
    const double depth = depthAt(*sight.wall, ends[end] + (is_after ? hair : -hair));
    return std::isfinite(depth) ? depth : sight.depth; // it may begin a hair farther on
  }

  std::vector<double> ends;      ///< along the side, increasing
  std::vector<Sight> sights{{}}; ///< before, between and after them

private:
  static constexpr double hair = 1e-6; // metres

  struct Wall {
    PlanElement element;
    double low; ///< its ends along the side
    double high;
  };

  void findSights()
  {
    std::vector<const Wall*> here;
    auto next = walls_.begin();
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
      const double x = (ends[k] + ends[k + 1]) / 2;
      for (; next != walls_.end() && next->low < x; ++next)
        here.push_back(&*next);
      here.erase(std::remove_if(here.begin(), here.end(),
                                [x](const Wall* wall) { return wall->high < x; }),
                 here.end());
      Sight nearest;
      for (const Wall* wall : here)
        if (const double depth = depthAt(wall->element, x); depth < nearest.depth)
          nearest = {&wall->element, depth};
      sights.push_back(nearest);
    }
    sights.emplace_back();
  }

  PlanFrame frame_;
  std::vector<Wall> walls_;
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

/** @brief Returns whether two chains have the same dimensions. */
bool
areAlike(const DimensionChain& a, const DimensionChain& b)
{
  if (a.places.size() != b.places.size())
    return false;
  constexpr double same = 0.01; // metres
  for (std::size_t k = 0; k < a.places.size(); ++k)
    if (std::abs(a.along(k) - b.along(k)) > same)
      return false;
  return true;
}

void
sortAlong(DimensionChain& chain)
{
  std::sort(
      chain.places.begin(), chain.places.end(),
      [way = wayAlong(chain.side)](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
        return a.dot(way) < b.dot(way);
      });
}

/** @brief Returns the corners of walls that are visible from a side, in order. What
 * lies behind a gap that is no wider than a wall does not count. */
DimensionChain
chainAlong(const std::vector<PlanElement>& walls,
           const Eigen::Vector2d& side,
           double max_wall)
{
  SideView view(walls, side);
  auto& sights = view.sights;
  for (std::size_t first = 1; first + 1 < sights.size(); ++first) {
    const double rim = sights[first - 1].depth + max_wall;
    std::size_t last = first; // sights[first] to sights[last - 1] are in a gap
    while (last + 1 < sights.size() && sights[last].depth > rim)
      ++last;
    if (sights[last].wall && last > first &&
        view.ends[last - 1] - view.ends[first - 1] <= max_wall)
      std::fill(sights.begin() + static_cast<std::ptrdiff_t>(first),
                sights.begin() + static_cast<std::ptrdiff_t>(last), Sight{});
  }
  DimensionChain chain{side, {}};
  for (std::size_t k = 0; k < view.ends.size(); ++k)
    if (!goesOn(sights[k], sights[k + 1])) // where walls meet, the nearer of their ends
      chain.places.push_back(
          view.toPlan({view.ends[k], std::min(view.depthBeside(k, false),
                                              view.depthBeside(k, true))}));
  sortAlong(chain);
  dropSmallSteps(chain, min_step);
  return chain;
}

} // namespace

std::vector<DimensionChain>
openingChains(const Floorplan& plan,
              const PlanFrame& frame,
              const Eigen::AlignedBox2d& whole)
{
  constexpr double along = 0.9998; // cosine of one degree
  std::vector<DimensionChain> chains;
  for (const Eigen::Vector2d& side : {Eigen::Vector2d(0, -1), Eigen::Vector2d(-1, 0),
                                      Eigen::Vector2d(0, 1), Eigen::Vector2d(1, 0)}) {
    DimensionChain chain{side, {whole.min(), whole.max()}};
    const double off = (side.sum() < 0 ? whole.min() : whole.max()).dot(side);
    for (Eigen::Vector2d& end : chain.places)
      end = end.dot(wayAlong(side)) * wayAlong(side) + off * side;
    const Eigen::Vector2d out = Eigen::Rotation2Dd(-frame.turn) * side; // in the plan
    for (const PlanOpening& opening : plan.openings) {
      const Eigen::Vector2d way = (opening.end - opening.start).normalized();
      const Eigen::Vector2d left = leftOf(way);
      const SectionLine sight{(opening.start + opening.end) / 2,
                              (opening.start + opening.end) / 2 + out};
      const auto hides = [&](const PlanRoom& room) {
        const auto ranges = rangesIn(room.boundary, sight);
        return !ranges.empty() && ranges.back().second > opening.depth;
      };
      if (opening.leadsOutside() &&
          (opening.rooms[0] == 0 ? left : -left).dot(out) > along &&
          std::none_of(plan.rooms.begin(), plan.rooms.end(), hides))
        for (const Eigen::Vector2d& end : {opening.start, opening.end})
          chain.places.push_back(frame(end + opening.depth / 2 * out));
    }
    if (chain.places.size() == 2)
      continue;
    sortAlong(chain);
    dropSmallSteps(chain, min_step);
    chains.push_back(chain);
  }
  return chains;
}

void
dropSmallSteps(DimensionChain& chain, double least)
{
  while (chain.places.size() > 2) {
    std::size_t nearest = 0;
    for (std::size_t k = 1; k + 1 < chain.places.size(); ++k)
      if (chain.length(k) < chain.length(nearest))
        nearest = k;
    if (chain.length(nearest) >= least)
      return;
    const bool is_deeper = chain.places[nearest].dot(chain.side) <
                           chain.places[nearest + 1].dot(chain.side);
    chain.places.erase(chain.places.begin() +
                       static_cast<std::ptrdiff_t>(nearest + (is_deeper ? 0 : 1)));
  }
}

std::vector<DimensionChain>
wallChains(const std::vector<PlanElement>& walls, double max_wall)
{
  std::vector<DimensionChain> chains;
  for (const Eigen::Vector2d& side : {Eigen::Vector2d(0, -1), Eigen::Vector2d(-1, 0)}) {
    const DimensionChain first = chainAlong(walls, side, max_wall);
    const DimensionChain second = chainAlong(walls, -side, max_wall);
    if (first.places.size() > 2)
      chains.push_back(first);
    if (second.places.size() > 2 && !areAlike(first, second))
      chains.push_back(second);
  }
  return chains;
}

} // namespace pcl::sedr
