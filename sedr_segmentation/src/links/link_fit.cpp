// SPDX-License-Identifier: BSD-3-Clause
#include "link_fit.h"

#include "../curves/main_directions.h"
#include "../walls/wall_cells.h"

#include "sedr_filters/src/base/exactness.h"
#include "sedr_filters/src/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

namespace {

/** @brief Recomputes the corners of a chain near their old positions.
 * @return false if two links do not meet */
bool
moveCorners(LoopChain& chain, const LoopParameters& parameters)
{
  std::vector<Eigen::Vector2d> corners(chain.size());
  for (std::size_t i = 0; i < chain.size(); ++i)
    if (!findCorner(chain.links[chain.before(i)].curve, chain.links[i].curve,
                    chain.corners[i], parameters, corners[i]))
      return false;
  chain.corners = std::move(corners);
  return true;
}

/** @brief Places each bridge between the projections of its midpoint on the
 * neighbouring curves. */
void
layBridges(LoopChain& chain)
{
  for (std::size_t i = 0; i < chain.size(); ++i) {
    LoopLink& link = chain.links[i];
    if (!link.is_bridge)
      continue;
    const Eigen::Vector2d middle =
        (chain.corners[i] + chain.corners[chain.after(i)]) / 2;
    const Eigen::Vector2d from = chain.links[chain.before(i)].curve.project(middle);
    const Eigen::Vector2d to = chain.links[chain.after(i)].curve.project(middle);
    if ((to - from).norm() > same_place)
      link.curve = lineThrough(from, to);
  }
}

/** @brief Returns the sine of the angle between a line and the closest main direction
 * of the other lines of a chain. */
double
askew(const LoopChain& chain,
      std::size_t link,
      const PlanCurve& line,
      const Priors& priors)
{
  std::vector<DirectedLine> others;
  for (std::size_t i = 0; i < chain.size(); ++i)
    if (i != link && !chain.links[i].curve.isCircle() && !chain.links[i].is_bridge)
      others.push_back({chain.element(i).length(), chain.links[i].curve.direction});
  double least = 1;
  for (const auto& direction : mainDirections(std::move(others), priors))
    least = std::min(least, std::abs(leftOf(direction).dot(line.direction)));
  return least;
}

/** @brief Returns whether a fit with points on a small share of a line rotates it away
 * from its old direction and all other walls. Such points hardly determine a direction.
 */
bool
turnsAway(const LoopChain& chain,
          std::size_t link,
          const PlanCurve& line,
          const std::vector<WeightedPoint>& points,
          const LoopParameters& parameters)
{
  const double tolerance = parameters.tolerance;
  const Priors& priors = parameters.priors;
  const PlanElement was = chain.element(link);
  if (was.isArc() || line.isCircle() ||
      std::max(line.distance(was.start), line.distance(was.end)) <= tolerance)
    return false;
  WallCells cells(0, was.length(), priors.evidence_cell / 2);
  for (const WeightedPoint& p : points)
    if (line.distance(p.position) <= tolerance)
      cells.add(was.project(p.position));
  return cells.shareSeen() < priors.share_part &&
         askew(chain, link, line, priors) >
             askew(chain, link, chain.links[link].curve, priors);
}

} // namespace

std::vector<WeightedPoint>
pointsAlong(const LoopChain& chain,
            std::size_t i,
            const PlanPoints& evidence,
            const LoopParameters& parameters)
{
  const double tolerance = parameters.tolerance;
  const double cell = parameters.priors.evidence_cell;
  const double step = cell / 2;
  const double corner_zone = 2 * parameters.priors.run_gap;
  const PlanElement e = chain.element(i);
  const PlanCurve& curve = chain.links[i].curve;
  struct Neighbour {
    PlanCurve curve;
    Eigen::Vector2d corner;
    bool leaves_smoothly;
  };
  std::vector<Neighbour> neighbours;
  for (const bool is_next : {false, true}) {
    const LoopLink& link = chain.links[is_next ? chain.after(i) : chain.before(i)];
    const Eigen::Vector2d& corner = is_next ? e.end : e.start;
    neighbours.push_back(
        {link.curve, corner, sineBetween(curve, link.curve, corner) < 0.4});
  }
  const double smooth_zone = std::min(cell, e.length() / 4);
  const auto isAtCorner = [&](const Eigen::Vector2d& p) {
    return std::any_of(neighbours.begin(), neighbours.end(), [&](const Neighbour& n) {
      const double from_corner = (p - n.corner).norm();
      return n.leaves_smoothly
                 ? from_corner < smooth_zone
                 : from_corner < corner_zone && n.curve.distance(p) < tolerance / 2;
    });
  };
  std::vector<WeightedPoint> points;
  const double length = e.length();
  const auto parts = static_cast<std::size_t>(std::ceil(length / step));
  const double half = length / static_cast<double>(parts) / 2;
  for (std::size_t k = 0; k < parts; ++k) {
    const Eigen::Vector2d middle = e.pointAt((2 * static_cast<double>(k) + 1) * half);
    const Eigen::Vector2d along = curve.tangentAt(middle);
    evidence.forEachWithin(middle, std::hypot(tolerance, half), [&](const auto& p) {
      if (std::abs((p - middle).dot(along)) <= half && !isAtCorner(p))
        points.push_back({p, 1});
    });
  }
  return points;
}

void
refitLinks(LoopChain& chain,
           const PlanPoints& evidence,
           const LoopParameters& parameters)
{
  LoopChain fitted = chain;
  parallelBlocks(chain.size(), 1, parameters.threads, [&](std::size_t i, std::size_t) {
    const LoopLink& link = chain.links[i];
    if (link.is_known)
      return;
    const std::vector<WeightedPoint> points =
        pointsAlong(chain, i, evidence, parameters);
    if (points.size() < (link.is_bridge ? 10 : 5))
      return;
    fitted.links[i].is_bridge = false;
    PlanCurve& curve = fitted.links[i].curve;
    curve = link.keeps_direction
                ? fitParallel(points, link.curve, parameters.tolerance)
                : fitRobustly(points, link.curve, parameters.tolerance,
                              parameters.minimum_radius, parameters.maximum_radius);
    if (turnsAway(chain, i, curve, points, parameters))
      curve = fitParallel(points, link.curve, parameters.tolerance);
    if (curve.direction.dot(link.curve.direction) < 0)
      curve.direction = -curve.direction;
  });
  layBridges(fitted);
  if (moveCorners(fitted, parameters))
    chain = fitted;
}

} // namespace pcl::sedr
