// SPDX-License-Identifier: BSD-3-Clause
#include "dimension_chains.h"

#include <pcl/sedr_filters/priors.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::sedr {
namespace {

constexpr double nowhere = std::numeric_limits<double>::infinity();
constexpr std::size_t no_wall = std::numeric_limits<std::size_t>::max();
constexpr std::size_t gap = no_wall - 1; ///< between two faces of a wall

/** @brief Walls in the frame of a side: x along it, y into the plan. */
class SideView {
public:
  SideView(const std::vector<PlanElement>& walls, DrawingSide side)
      : along_(wayAlong(side))
      , in_(-wayOff(side))
  {
    for (const PlanElement& wall : walls)
      walls_.push_back({wall, toView(wall.start), toView(wall.end)});
  }

  Eigen::Vector2d toPlan(const Eigen::Vector2d& p) const
  {
    return p.x() * along_ + p.y() * in_;
  }

  /** @brief Returns the ends of walls along the side, sorted. */
  std::vector<double> ends() const
  {
    std::vector<double> ends;
    for (const Wall& wall : walls_) {
      ends.push_back(wall.start.x());
      ends.push_back(wall.end.x());
      // The extremes of an arc are two points of its circle.
      const PlanElement& e = wall.element;
      for (const double sign : {-1.0, 1.0}) {
        const Eigen::Vector2d place = e.centre + sign * e.radius * along_;
        if (e.isArc() && e.distance(place) < 1e-6 * e.radius)
          ends.push_back(place.dot(along_));
      }
    }
    std::sort(ends.begin(), ends.end());
    return ends;
  }

  /** @brief What is visible at a place along the side: a wall and its depth there. */
  struct Sight {
    std::size_t wall = no_wall;
    double depth = nowhere;

    bool isWall() const { return wall < gap; }
  };

  Sight sightAt(double x) const
  {
    Sight nearest;
    for (std::size_t w = 0; w < walls_.size(); ++w) {
      const double depth = depthAt(walls_[w], x);
      if (depth < nearest.depth)
        nearest = {w, depth};
    }
    return nearest;
  }

  /** @brief Returns whether two walls are collinear at a place. */
  bool areInLine(std::size_t a, std::size_t b) const
  {
    constexpr double parallel = 0.01;
    constexpr double off = 0.01;
    const Wall& first = walls_[a];
    const Wall& second = walls_[b];
    if (first.element.isArc() || second.element.isArc())
      return false;
    const Eigen::Vector2d way = (first.end - first.start).normalized();
    const Eigen::Vector2d other = (second.end - second.start).normalized();
    const Eigen::Vector2d between = second.start - first.start;
    return std::abs(way.x() * other.y() - way.y() * other.x()) < parallel &&
           std::abs(way.x() * between.y() - way.y() * between.x()) <
               off * (first.end - first.start).norm();
  }

private:
  struct Wall {
    PlanElement element;
    Eigen::Vector2d start; ///< in the frame of the view
    Eigen::Vector2d end;
  };

  Eigen::Vector2d toView(const Eigen::Vector2d& p) const
  {
    return {p.dot(along_), p.dot(in_)};
  }

  double depthAt(const Wall& wall, double x) const
  {
    const PlanElement& e = wall.element;
    if (!e.isArc()) {
      const double share = (x - wall.start.x()) / (wall.end.x() - wall.start.x());
      return share >= 0 && share <= 1
                 ? wall.start.y() + share * (wall.end.y() - wall.start.y())
                 : nowhere;
    }
    const Eigen::Vector2d centre = toView(e.centre);
    const double half = e.radius * e.radius - (x - centre.x()) * (x - centre.x());
    double depth = nowhere;
    for (const double sign : {-1.0, 1.0}) {
      const double y = centre.y() + sign * std::sqrt(std::max(half, 0.0));
      if (half > 0 && y < depth && e.distance(toPlan({x, y})) < 1e-6 * e.radius)
        depth = y;
    }
    return depth;
  }

  Eigen::Vector2d along_;
  Eigen::Vector2d in_;
  std::vector<Wall> walls_;
};

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

/** @brief Marks as gap a place between two nearer walls that is no wider than a wall:
 * it lies between the faces of one wall. */
void
closeGaps(const std::vector<double>& places,
          double thickest,
          std::vector<SideView::Sight>& sights)
{
  for (std::size_t first = 1; first + 1 < sights.size(); ++first) {
    std::size_t last = first; // sights[first] to sights[last - 1] are deeper
    const double rim = sights[first - 1].depth + thickest;
    while (last + 1 < sights.size() && sights[last].depth > rim)
      ++last;
    const bool is_gap = last > first && last + 1 < sights.size() &&
                        sights[last].isWall() &&
                        places[last - 1] - places[first - 1] <= thickest;
    for (std::size_t k = first; is_gap && k < last; ++k)
      sights[k] = {gap, sights[first - 1].depth};
  }
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

} // namespace

Eigen::Vector2d
wayAlong(DrawingSide side)
{
  const bool is_level = side == DrawingSide::Bottom || side == DrawingSide::Top;
  return is_level ? Eigen::Vector2d::UnitX() : Eigen::Vector2d::UnitY();
}

Eigen::Vector2d
wayOff(DrawingSide side)
{
  switch (side) {
  case DrawingSide::Bottom:
    return {0, -1};
  case DrawingSide::Left:
    return {-1, 0};
  case DrawingSide::Top:
    return {0, 1};
  default:
    return {1, 0};
  }
}

DimensionChain
chainAlong(const std::vector<PlanElement>& walls,
           DrawingSide side,
           double max_wall,
           double least)
{
  const SideView view(walls, side);
  const std::vector<double> places = placesOf(view.ends(), least);
  std::vector<SideView::Sight> sights{{}}; // before, between and after the places
  for (std::size_t k = 0; k + 1 < places.size(); ++k)
    sights.push_back(view.sightAt((places[k] + places[k + 1]) / 2));
  sights.emplace_back();
  closeGaps(places, max_wall, sights);
  DimensionChain chain{side, {}};
  for (std::size_t k = 0; k < places.size(); ++k) {
    const SideView::Sight& before = sights[k];
    const SideView::Sight& after = sights[k + 1];
    const bool goes_on =
        before.wall == after.wall ||
        (before.isWall() && after.isWall() && view.areInLine(before.wall, after.wall));
    if (goes_on)
      continue;
    // Where walls meet, the nearer of their ends.
    const double off = least / 4;
    double depth = std::min(view.sightAt(places[k] - off).depth,
                            view.sightAt(places[k] + off).depth);
    if (depth == nowhere)
      depth = std::min(before.depth, after.depth);
    chain.places.push_back(view.toPlan({places[k], depth}));
  }
  return chain;
}

DimensionChain
uncrowded(DimensionChain chain, double room)
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
      return chain;
    chain.places.erase(chain.places.begin() + static_cast<std::ptrdiff_t>(shortest));
  }
}

std::vector<DimensionChain>
wallChains(const std::vector<PlanElement>& walls,
           double max_wall,
           double least,
           double room)
{
  std::vector<DimensionChain> chains;
  for (const auto& [side, opposite] :
       {std::make_pair(DrawingSide::Bottom, DrawingSide::Top),
        std::make_pair(DrawingSide::Left, DrawingSide::Right)}) {
    const DimensionChain first =
        uncrowded(chainAlong(walls, side, max_wall, least), room);
    const DimensionChain second =
        uncrowded(chainAlong(walls, opposite, max_wall, least), room);
    if (first.places.size() > 2)
      chains.push_back(first);
    if (second.places.size() > 2 && !areAlike(first, second, least))
      chains.push_back(second);
  }
  return chains;
}

std::vector<DimensionChain>
overallChains(const Eigen::AlignedBox2d& box)
{
  return {{DrawingSide::Bottom, {box.min(), {box.max().x(), box.min().y()}}},
          {DrawingSide::Left, {box.min(), {box.min().x(), box.max().y()}}}};
}

} // namespace pcl::sedr
