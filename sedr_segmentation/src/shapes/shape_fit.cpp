// SPDX-License-Identifier: BSD-3-Clause
#include "shape_fit.h"

#include "shape_distance.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pcl::sedr {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/** @brief The numbers of a shape, seven at most. */
using Parameters = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 7, 1>;
using Normal = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 7, 7>;

/** @brief Changes the numbers of a slab by a step, see ShapeDistance.
 * @return whether it is one then */
bool
takeStep(ShapeKind kind,
         const Parameters& step,
         const Eigen::Vector3d& about,
         PlanSlab& slab)
{
  if (!step.allFinite())
    return false;
  std::array<double, 7> by{};
  for (std::size_t k = 0; k < by.size(); ++k)
    if (const int number = numbersOf(kind)[k]; number >= 0)
      by[k] = step[number];
  if (isFlat(kind)) {
    const Eigen::Vector3d n = slab.plane.head<3>();
    const Eigen::Vector2d slope = Eigen::Vector2d(by[0], by[1]) - n.head<2>() / n.z();
    const double height = slab.heightAt(about.head<2>()) + by[2];
    slab.plane = planeThrough({about.x(), about.y(), height}, slope).plane;
    return true;
  }
  SlabCurve c = *slab.curve;
  c.centre += by[0] * c.axis + by[1] * Eigen::Vector2d(-c.axis.y(), c.axis.x());
  const double crown = c.base + c.up + by[2];
  c.setDirection(c.direction() + by[3]);
  c.along /= 1 + by[4] * c.along;
  c.across /= 1 + by[5] * c.across;
  c.up /= 1 + by[6] * c.up;
  c.base = crown - c.up;
  slab.curve = std::make_shared<const SlabCurve>(c);
  return c.isFinite();
}

/** @brief Returns Tukey's cost of all distances. Summing stops when `most` is reached;
 * the sum so far is returned then. */
double
costOf(const std::vector<PointRow>& points,
       const ShapeDistance& shape,
       double band,
       double most)
{
  double cost = 0;
  ShapeValues distance;
  ShapeValues share;
  for (const PointRow& row : points) {
    shape.of(row, distance);
    share = distance / band;
    const ShapeValues rest = 1 - share * share;
    distance = 1 - rest * rest * rest;
    for (Eigen::Index i = 0; i < row.size(); ++i)
      cost += std::abs(share[i]) < 1 ? distance[i] : 1;
    if (cost >= most) // what follows costs 0 or more
      break;
  }
  return cost;
}

/** @brief The normal equations of a step towards less. */
struct StepSums {
  Normal normal; ///< symmetric
  Parameters right;
};

/** @brief Returns them for a shape of `Count` numbers. */
template <int Count>
StepSums
sumsOf(const std::vector<PointRow>& points, const ShapeDistance& shape, double band)
{
  // Even rows, as numbers are added two at once.
  using Numbers = Eigen::Matrix<double, Count + Count % 2, 1>;
  using Columns = Eigen::Matrix<double, Count + Count % 2, Count>;
  Columns normal = Columns::Zero();
  Numbers right = Numbers::Zero();
  Numbers own = Numbers::Zero();
  ShapeValues distance;
  ShapeValues share;
  ShapeValues weights;
  std::array<ShapeValues, 7> growth;
  for (const PointRow& row : points) {
    shape.of(row, distance, growth);
    share = distance / band;
    weights = (1 - share * share).square();
    for (Eigen::Index i = 0; i < row.size(); ++i) {
      const double weight = weights[i];
      if (!(std::abs(share[i]) < 1) || weight <= 0)
        continue;
      for (int k = 0; k < Count; ++k)
        own[k] = growth[static_cast<std::size_t>(k)][i];
      const Numbers weighted = weight * own;
      for (int column = 0; column < Count; ++column)
        normal.col(column) += own[column] * weighted;
      right -= weight * distance[i] * own;
    }
  }
  return {normal.template topRows<Count>(), right.template head<Count>()};
}

StepSums
sumsOf(const std::vector<PointRow>& points,
       const ShapeDistance& shape,
       double band,
       int count)
{
  switch (count) {
  case 1:
    return sumsOf<1>(points, shape, band);
  case 3:
    return sumsOf<3>(points, shape, band);
  case 4:
    return sumsOf<4>(points, shape, band);
  case 5:
    return sumsOf<5>(points, shape, band);
  default:
    return sumsOf<7>(points, shape, band);
  }
}

} // namespace

int
parametersOf(ShapeKind kind)
{
  const std::array<int, 7>& numbers = numbersOf(kind);
  return *std::max_element(numbers.begin(), numbers.end()) + 1;
}

double
distanceOf(const PlanSlab& slab, const Eigen::Vector3d& p)
{
  return slab.curve ? slab.curve->distanceAbove(p)
                    : slab.plane.head<3>().dot(p) + slab.plane[3];
}

void
refineShape(ShapeKind kind,
            const std::vector<Eigen::Vector3d>& points,
            double deviation,
            PlanSlab& slab,
            double settled)
{
  constexpr int max_steps = 30;
  constexpr double cut = 4.7; // of Tukey's biweight, standard deviations
  const double band = cut * deviation;
  if (points.empty() || (!isFlat(kind) && !slab.curve))
    return;
  const Eigen::Vector3d about = meanOf(points);
  if (slab.curve && slab.curve->kind == CurveKind::Cylinder) {
    SlabCurve c = *slab.curve; // has its centre anywhere along its axis
    c.centre += c.axis * c.axis.dot(about.head<2>() - c.centre);
    slab.curve = std::make_shared<const SlabCurve>(c);
  }
  const std::vector<PointRow> rows = rowsOf(points);
  double cost = costOf(rows, {kind, slab, about}, band, infinity);
  double damping = 1e-6;
  for (int step = 0; step < max_steps; ++step) {
    const StepSums sums = sumsOf(rows, {kind, slab, about}, band, parametersOf(kind));
    bool is_better = false;
    double gain = 0;
    for (int tries = 0; tries < 8 && !is_better; ++tries) {
      Normal damped = sums.normal;
      damped.diagonal() *= 1 + damping;
      damped.diagonal().array() += 1e-12 * sums.normal.diagonal().maxCoeff();
      PlanSlab there = slab;
      is_better = takeStep(kind, damped.ldlt().solve(sums.right), about, there);
      const double cost_there =
          is_better ? costOf(rows, {kind, there, about}, band, cost) : infinity;
      is_better = cost_there < cost;
      damping = is_better ? damping / 10 : damping * 20 + 1e-9;
      if (!is_better)
        continue;
      gain = cost - cost_there;
      cost = cost_there;
      slab = there;
    }
    if (!is_better || gain < settled * cost)
      break;
  }
}

} // namespace pcl::sedr
