// SPDX-License-Identifier: BSD-3-Clause
#include "column_fit.h"

#include "column_rectangle.h"

#include "sedr_filters/src/base/exactness.h"
#include "sedr_filters/src/base/middle_value.h"
#include "sedr_filters/src/grids/place_table.h"
#include "sedr_filters/src/plan/room_lookup.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

namespace pcl::sedr {

namespace {

/** @brief Cost of a shape parameter, as a share of the points. */
constexpr double per_parameter = 0.01;

/** @brief A shape that a column may have. */
struct Shape {
  PlanLoop loop;
  double parameters = 0;              ///< number of parameters of the shape
  std::vector<double> distances = {}; ///< of the points from the shape
};

PlanLoop
polygonOf(const Contour& contour)
{
  PlanLoop loop;
  for (std::size_t i = 0; i < contour.size(); ++i) {
    PlanElement e;
    e.start = contour[i];
    e.end = contour[(i + 1) % contour.size()];
    loop.elements.push_back(e);
  }
  return loop;
}

/** @brief Returns the points in a hole and those within `beside` of it. */
std::vector<Eigen::Vector2d>
pointsOfColumn(const Contour& hole,
               const PlanLoop& outline,
               const PlanPoints& evidence,
               double beside)
{
  Eigen::AlignedBox2d box;
  for (const auto& p : hole)
    box.extend(p);
  const LoopLookup inside(outline);
  PlaceTable edges(2 * beside);
  for (std::size_t i = 0; i < outline.elements.size(); ++i)
    edges.addAlong(outline.elements[i], beside, static_cast<std::uint32_t>(i));
  edges.finish();
  const auto isBeside = [&](const Eigen::Vector2d& p) {
    const CellTable::Numbers near = edges.at(p);
    return std::any_of(near.begin(), near.end(), [&](std::uint32_t i) {
      return outline.elements[i].distance(p) < beside;
    });
  };
  std::vector<Eigen::Vector2d> points;
  evidence.forEachWithin(box.center(), box.sizes().norm() / 2 + beside,
                         [&](const auto& p) {
                           if (inside.contains(p) || isBeside(p))
                             points.push_back(p);
                         });
  return points;
}

/** @brief Returns the distances of points from a loop. */
std::vector<double>
distancesFrom(const PlanLoop& loop, const std::vector<Eigen::Vector2d>& points)
{
  std::vector<double> distances;
  distances.reserve(points.size());
  for (const auto& p : points)
    distances.push_back(loop.distance(p));
  return distances;
}

/** @brief Returns whether a shape lies within the hole and fills it. */
bool
fitsIn(const PlanLoop& shape, const PlanLoop& hole, const LoopParameters& parameters)
{
  // A hole is up to a cell wider on each side.
  if (std::abs(shape.area()) < parameters.priors.share_half / 2 * std::abs(hole.area()))
    return false;
  // Ceiling cells and their noise reach over the edge of a column.
  const double farthest = 2 * parameters.priors.min_wall;
  const auto isNear = [&](const Eigen::Vector2d& p, double reach) {
    return hole.contains(p) || hole.distance(p) < reach;
  };
  // Where cells cover two sides, the corner is farther from the hole than the sides.
  return std::all_of(
      shape.elements.begin(), shape.elements.end(), [&](const PlanElement& e) {
        if (!e.isArc())
          return isNear(e.pointAt(e.length() / 2), farthest) &&
                 isNear(e.start, std::sqrt(2.0) * farthest);
        const std::vector<Eigen::Vector2d> way = PlanLoop{{e}}.polygon(2 * chord);
        return std::all_of(way.begin(), way.end(), [&](const Eigen::Vector2d& p) {
          return isNear(p, farthest);
        });
      });
}

Shape
circleShape(const PlanCurve& circle)
{
  PlanElement e;
  e.start = circle.point + circle.radius * Eigen::Vector2d::UnitX();
  e.end = e.start;
  e.centre = circle.point;
  e.radius = circle.radius;
  e.counter_clockwise = false;
  e.inliers = circle.inliers;
  e.residual = circle.residual;
  return {{{e}}, 3};
}

/** @brief Finds a circle through most points by seeded RANSAC and robust least squares.
 * @return radius 0 if there is none */
PlanCurve
findCircle(const std::vector<Eigen::Vector2d>& points,
           double largest_radius,
           const LoopParameters& parameters)
{
  constexpr int trials = 300;
  const double smallest_radius = parameters.priors.min_column_radius;
  std::mt19937_64 random(parameters.seed);
  PlanCurve best;
  double best_score = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const PlanCurve circle = circleThrough(points[random() % points.size()],
                                           points[random() % points.size()],
                                           points[random() % points.size()]);
    if (circle.radius < smallest_radius || circle.radius > largest_radius)
      continue;
    double score = 0;
    auto left = static_cast<double>(points.size());
    for (auto p = points.begin();
         p != points.end() && score + left + same_place > best_score; ++p, --left)
      score +=
          std::max(0.0, 1 - std::pow(circle.distance(*p) / parameters.tolerance, 2));
    if (score <= best_score)
      continue;
    best_score = score;
    best = circle;
  }
  if (!best.isCircle())
    return best;
  std::vector<WeightedPoint> weighted;
  for (const auto& p : points)
    weighted.push_back({p, 1});
  return fitRobustly(weighted, best, parameters.tolerance, smallest_radius,
                     largest_radius);
}

/** @param any the loop that was fitted without a shape in mind */
std::vector<Shape>
shapesOf(const Contour& hole,
         const std::vector<Eigen::Vector2d>& points,
         const PlanLoop& any,
         const std::vector<Eigen::Vector2d>& directions,
         const LoopParameters& parameters)
{
  std::vector<Shape> shapes;
  double perimeter = 0;
  for (std::size_t i = 0; i < hole.size(); ++i)
    perimeter += (hole[(i + 1) % hole.size()] - hole[i]).norm();
  const PlanCurve circle = findCircle(points, perimeter / 4, parameters);
  if (circle.isCircle())
    shapes.push_back(circleShape(circle));
  for (const auto& direction : directions) {
    const Rectangle along = findRectangle(points, direction, parameters);
    if (along.isSound(parameters.priors))
      shapes.push_back({along.loop(), 4});
  }
  for (const auto& direction : directionsOf(points, parameters)) {
    const Rectangle turned = fitTurnedRectangle(
        points, findRectangle(points, direction, parameters), parameters);
    if (turned.isSound(parameters.priors))
      shapes.push_back({turned.loop(), 5});
  }
  double numbers = 0;
  for (const auto& e : any.elements)
    numbers += e.isArc() ? 3 : 2;
  if (!any.elements.empty() && any.area() < 0)
    shapes.push_back({any, numbers});
  for (Shape& shape : shapes)
    shape.distances = distancesFrom(shape.loop, points);
  return shapes;
}

} // namespace

PlanLoop
fitColumn(const Contour& hole,
          const PlanPoints& evidence,
          const std::vector<Eigen::Vector2d>& directions,
          const LoopParameters& parameters,
          std::vector<ContourSample>* places)
{
  const Priors& priors = parameters.priors;
  if (hole.size() < 4)
    return {};
  const PlanLoop outline = polygonOf(hole);
  const std::vector<Eigen::Vector2d> points =
      pointsOfColumn(hole, outline, evidence, priors.min_ceiling_step);
  const PlanLoop any = fitLoop(hole, evidence, {}, parameters, places);
  if (static_cast<double>(points.size()) < 2 * priors.min_points)
    return any;
  std::vector<Shape> shapes = shapesOf(hole, points, any, directions, parameters);

  // The noise is the residual of the best shape.
  double noise = parameters.tolerance / 3;
  for (const auto& shape : shapes)
    noise = std::min(noise, 1.4826 * middleValue(shape.distances));
  const double reach = std::clamp(3 * noise, 0.01, parameters.tolerance);
  PlanLoop best;
  double least = 2;
  for (auto& shape : shapes) {
    if (!fitsIn(shape.loop, outline, parameters))
      continue;
    double missed = 0;
    for (const double d : shape.distances)
      missed += std::min(1.0, std::pow(d / reach, 2));
    const double cost =
        missed / static_cast<double>(points.size()) + per_parameter * shape.parameters;
    if (cost >= least)
      continue;
    least = cost;
    best = std::move(shape.loop);
  }
  return best.elements.empty() ? any : best;
}

} // namespace pcl::sedr
