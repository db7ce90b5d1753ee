// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_segmentation/niche_fit.h>

#include <pcl/sedr_filters/cell_mask.h>
#include <pcl/sedr_filters/middle_value.h>
#include <pcl/sedr_filters/parallel.h>
#include <pcl/sedr_filters/plane_fit.h>
#include <pcl/sedr_segmentation/cell_count.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl {
namespace sedr {

namespace {

/** @brief A point as seen from a wall: metres along it, above its floor, behind it. */
struct WallPoint {
  double along;
  double up;
  double behind;
};

/** @brief A straight wall of a room, unrolled. */
struct UnrolledWall {
  const PlanElement& element;
  double height = 0;
  double tolerance = 0; ///< distance within which a point is on the wall
  std::vector<WallPoint> points;
};

/** @brief The points of a wall and of what is behind it. */
UnrolledWall
unroll(const PointView& points,
       const std::vector<int>& around,
       const PlanRoom& room,
       const PlanElement& element,
       double farthest)
{
  UnrolledWall wall{element, 0, std::clamp(2.5 * element.residual, 0.03, 0.06), {}};
  const Eigen::Vector2d inside =
      element.pointAt(element.length() / 2) + 0.01 * element.normalAt(0);
  const double floor = room.floorAt(inside);
  wall.height = room.ceilingAt(inside) - floor;
  const Eigen::Vector2d way = (element.end - element.start).normalized();
  const Eigen::Vector2d inwards = element.normalAt(0);
  const double length = element.length();
  for (const int i : around) {
    const Eigen::Vector3d p = points[static_cast<std::size_t>(i)].cast<double>();
    const Eigen::Vector2d d = p.head<2>() - element.start;
    const WallPoint seen{d.dot(way), p.z() - floor, -d.dot(inwards)};
    if (seen.behind >= -wall.tolerance && seen.behind <= farthest && seen.along >= 0 &&
        seen.along <= length && seen.up >= -0.1 && seen.up <= wall.height)
      wall.points.push_back(seen);
  }
  return wall;
}

Cell
cellOf(const CellGrid& grid, const WallPoint& p)
{
  return grid.at(p.along, p.up);
}

/** @brief The cells behind which something is seen while nothing is on the wall. */
CellMask
openCells(const UnrolledWall& wall, const CellGrid& grid)
{
  const CellBox box{{-2, -3},
                    {cellsFor(wall.element.length(), grid.size()) + 2,
                     cellsFor(wall.height, grid.size()) + 2}};
  CellMask on(box);
  CellMask behind(box);
  for (const WallPoint& p : wall.points)
    (p.behind <= wall.tolerance ? on : behind).set(cellOf(grid, p), 1);
  const CellMask open = subtract(behind, on);
  return eroded(dilated(open, 1), 1);
}

/** @brief The depth at which most of the points behind a region lie. */
double
depthOfBack(const std::vector<WallPoint>& region, double tolerance)
{
  std::vector<double> depths;
  for (const WallPoint& p : region)
    if (p.behind > tolerance)
      depths.push_back(p.behind);
  std::sort(depths.begin(), depths.end());
  double best = 0;
  std::size_t most = 0;
  for (std::size_t first = 0, last = 0; last < depths.size(); ++last) {
    while (depths[last] - depths[first] > 2 * tolerance)
      ++first;
    if (last - first + 1 <= most)
      continue;
    most = last - first + 1;
    best = depths[(first + last) / 2];
  }
  return best;
}

/** @brief A recess in a wall: along [left, right], up [low, high]. */
struct Recess {
  double left = 0;
  double right = 0;
  double low = 0;
  double high = 0;
  double depth = 0;
  bool has_bottom = false; ///< seen above the floor

  double mouth() const { return (right - left) * (high - low); }

  /** @brief Whether one is above the other one. */
  bool sharesPlan(const Recess& other) const
  {
    return left < other.right && other.left < right;
  }
};

/** @brief A lower bottom is the floor, metres; a higher head the ceiling. */
constexpr double least_sill = 0.05;
constexpr double least_head = 0.05;

/** @brief Moves the edges of a recess onto the points seen on its sides. */
void
fitEdges(const UnrolledWall& wall, Recess& recess)
{
  constexpr double reach = 0.1;
  const auto fit = [&](double& edge, double WallPoint::*across,
                       double WallPoint::*beside, double low, double high) {
    std::vector<double> places;
    for (const WallPoint& p : wall.points)
      if (std::abs(p.*across - edge) <= reach && p.*beside > low + reach &&
          p.*beside < high - reach && p.behind > wall.tolerance &&
          p.behind < recess.depth - wall.tolerance)
        places.push_back(p.*across);
    if (places.size() < 5)
      return false;
    edge = middleValue(std::move(places));
    return true;
  };
  fit(recess.left, &WallPoint::along, &WallPoint::up, recess.low, recess.high);
  fit(recess.right, &WallPoint::along, &WallPoint::up, recess.low, recess.high);
  recess.has_bottom =
      fit(recess.low, &WallPoint::up, &WallPoint::along, recess.left, recess.right) &&
      recess.low >= least_sill;
  fit(recess.high, &WallPoint::up, &WallPoint::along, recess.left, recess.right);
  std::vector<double> depths;
  for (const WallPoint& p : wall.points)
    if (p.along > recess.left + wall.tolerance &&
        p.along < recess.right - wall.tolerance && p.up > recess.low + wall.tolerance &&
        p.up < recess.high - wall.tolerance &&
        std::abs(p.behind - recess.depth) <= wall.tolerance)
      depths.push_back(p.behind);
  if (!depths.empty())
    recess.depth = middleValue(std::move(depths));
}

/** @brief Whether the back of a region is closed and nothing is seen beyond it, neither
 * through it nor along its sides: the reveal of a window goes on behind the pane. */
bool
isClosed(const CellMask& region,
         const std::vector<WallPoint>& behind,
         const CellGrid& grid,
         double depth,
         double tolerance,
         const NicheParameters& parameters)
{
  const CellMask inside = eroded(region, 1);
  const CellMask rim = subtract(dilated(region, 1), inside);
  CellMask back(region.box());
  CellMask beyond(region.box());
  for (const WallPoint& p : behind) {
    const Cell cell = cellOf(grid, p);
    if (std::abs(p.behind - depth) <= 1.5 * tolerance)
      back.set(cell, 1);
    else if (p.behind > depth)
      beyond.set(cell, 1);
  }
  const auto share = [](const CellMask& seen, const CellMask& of) {
    return static_cast<double>(intersect(seen, of).count()) /
           static_cast<double>(std::max<std::size_t>(1, of.count()));
  };
  return share(back, inside) >= parameters.minimum_coverage &&
         share(beyond, inside) <= parameters.greatest_view &&
         share(beyond, rim) <= parameters.greatest_view;
}

/** @brief The recess of one region of open cells, if it is a niche. */
bool
findRecess(const UnrolledWall& wall,
           const CellMask& region,
           const CellGrid& grid,
           const NicheParameters& parameters,
           Recess& recess)
{
  const CellMask around = dilated(region, 1);
  std::vector<WallPoint> behind;
  for (const WallPoint& p : wall.points)
    if (around.at(cellOf(grid, p)))
      behind.push_back(p);
  recess.depth = depthOfBack(behind, wall.tolerance);
  if (recess.depth < parameters.least_depth ||
      recess.depth > parameters.greatest_depth ||
      !isClosed(region, behind, grid, recess.depth, wall.tolerance, parameters))
    return false;
  const CellBox box = boxOf(region.toSet());
  const double size = grid.size();
  recess.left = box.low.x * size;
  recess.right = (box.high.x + 1) * size;
  recess.low = box.low.y * size;
  recess.high = (box.high.y + 1) * size;
  const double area = (recess.right - recess.left) * (recess.high - recess.low);
  if (static_cast<double>(region.count()) * size * size < 0.7 * area)
    return false;
  fitEdges(wall, recess);
  if (recess.high > wall.height - least_head)
    recess.high = wall.height;
  return recess.right - recess.left >= parameters.least_size &&
         recess.high - recess.low >= parameters.least_size;
}

PlanElement
side(const Eigen::Vector2d& start, const Eigen::Vector2d& end)
{
  PlanElement e;
  e.start = start;
  e.end = end;
  return e;
}

PlanNiche
nicheOf(const PlanRoom& room, const UnrolledWall& wall, const Recess& recess)
{
  const Eigen::Vector2d out = -recess.depth * wall.element.normalAt(0);
  const Eigen::Vector2d left = wall.element.pointAt(recess.left);
  const Eigen::Vector2d right = wall.element.pointAt(recess.right);
  PlanNiche niche;
  niche.boundary.elements = {side(left, left + out), side(left + out, right + out),
                             side(right + out, right), side(right, left)};
  const Eigen::Vector2d inside = (left + right) / 2 + 0.01 * wall.element.normalAt(0);
  const double floor = room.floorAt(inside);
  niche.bottom = recess.low > 0.02 ? horizontalSlab(floor + recess.low)
                                   : room.floorSlab(room.floorDetailAt(inside));
  niche.top = recess.high < wall.height ? horizontalSlab(floor + recess.high)
                                        : room.ceilingSlab(room.detailAt(inside));
  return niche;
}

/** @brief Whether a niche reaches into its own room, another wing of which lies behind
 * the wall. */
bool
reachesInto(const PlanRoom& room, const PlanNiche& niche)
{
  constexpr double step = 0.05;
  const auto& sides = niche.boundary.elements;
  const Eigen::Vector2d back = sides[1].end - sides[1].start;
  const Eigen::Vector2d out = sides[0].end - sides[0].start;
  for (double s = step; s < back.norm(); s += step)
    for (double d = step; d < out.norm() + step; d += step)
      if (room.boundary.contains(sides[0].start + s * back.normalized() +
                                 d * out.normalized()))
        return true;
  return false;
}

/** @brief Of recesses one above the other those with the largest mouths: a plan has one
 * floor and one ceiling at a place. */
std::vector<Recess>
largestOf(std::vector<Recess> recesses)
{
  std::stable_sort(
      recesses.begin(), recesses.end(),
      [](const Recess& a, const Recess& b) { return a.mouth() > b.mouth(); });
  std::vector<Recess> kept;
  for (const Recess& recess : recesses)
    if (std::none_of(kept.begin(), kept.end(),
                     [&](const Recess& k) { return k.sharesPlan(recess); }))
      kept.push_back(recess);
  std::sort(kept.begin(), kept.end(),
            [](const Recess& a, const Recess& b) { return a.left < b.left; });
  return kept;
}

/** @brief The niches of a straight wall. */
std::vector<PlanNiche>
nichesIn(const UnrolledWall& wall,
         const PlanRoom& room,
         const NicheParameters& parameters)
{
  const CellGrid grid(parameters.cell_size);
  const auto least =
      static_cast<std::size_t>(cellsFor(parameters.least_size, grid.size()) *
                               cellsFor(parameters.least_size, grid.size()));
  const CellMask open = openCells(wall, grid);
  const MaskRegions regions = labelRegions(open, false);
  std::vector<Recess> recesses;
  for (std::size_t r = 0; r < regions.sizes.size(); ++r) {
    if (regions.sizes[r] < least)
      continue;
    Recess recess;
    if (!findRecess(wall, regionMask(open, regions, static_cast<std::int32_t>(r)), grid,
                    parameters, recess))
      continue;
    const bool is_at_floor = recess.low < 0.15 && !recess.has_bottom;
    if (is_at_floor && (recess.depth < parameters.least_alcove ||
                        recess.high == wall.height)) // a part of the room
      continue;
    if (is_at_floor)
      recess.low = 0;
    recesses.push_back(recess);
  }
  std::vector<PlanNiche> niches;
  for (const Recess& recess : largestOf(std::move(recesses))) {
    PlanNiche niche = nicheOf(room, wall, recess);
    if (!reachesInto(room, niche))
      niches.push_back(std::move(niche));
  }
  return niches;
}

} // namespace

std::vector<PlanNiche>
fitNiches(const PointView& points,
          const std::vector<int>& around,
          const PlanRoom& room,
          const NicheParameters& parameters)
{
  const std::vector<PlanElement>& walls = room.boundary.elements;
  std::vector<std::vector<PlanNiche>> niches_of(walls.size());
  parallelBlocks(walls.size(), 1, parameters.threads, [&](std::size_t k, std::size_t) {
    const PlanElement& element = walls[k];
    if (!element.isArc() && element.length() >= parameters.least_size)
      niches_of[k] = nichesIn(unroll(points, around, room, element,
                                     parameters.greatest_depth + parameters.view),
                              room, parameters);
  });
  std::vector<PlanNiche> niches;
  for (auto& own : niches_of)
    niches.insert(niches.end(), own.begin(), own.end());
  return niches;
}

} // namespace sedr
} // namespace pcl
