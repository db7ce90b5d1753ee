// SPDX-License-Identifier: BSD-3-Clause
#include "tie_equations.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace sedr {

namespace {

/** @brief Parameters of a curve: angle and offset at the pivot, or centre and radius.
 */
Eigen::Vector3d
stateOf(const MeasuredCurve& m)
{
  const PlanCurve& c = m.curve;
  if (c.isCircle())
    return {c.point.x(), c.point.y(), c.radius};
  return {std::atan2(c.direction.y(), c.direction.x()),
          leftOf(c.direction).dot(c.point - m.pivot), 0};
}

void
setState(const Eigen::Vector3d& state, MeasuredCurve& m)
{
  PlanCurve& c = m.curve;
  if (c.isCircle()) {
    c.point = state.head<2>();
    c.radius = state[2];
    return;
  }
  c.direction = directionOf(state);
  c.point = m.pivot + state[1] * leftOf(c.direction);
}

/** @brief Covariance of a curve's parameters; 0 for those that a line has not. */
Eigen::Matrix3d
covarianceOf(const MeasuredCurve& m)
{
  const int size = m.parameters();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  covariance.topLeftCorner(size, size) =
      m.information.topLeftCorner(size, size)
          .ldlt()
          .solve(Eigen::MatrixXd::Identity(size, size));
  return covariance;
}

/** @brief All equations of all ties at given states. */
struct EquationSystem {
  Eigen::VectorXd value;
  Eigen::MatrixXd slope; ///< a row an equation, three columns a curve
};

EquationSystem
systemOf(const std::vector<MeasuredCurve>& curves,
         const std::vector<CurveTie>& ties,
         const std::vector<TieSide>& sides,
         const Eigen::VectorXd& state)
{
  struct Row {
    TieEquation equation;
    CurveTie tie;
  };
  std::vector<Row> rows;
  for (std::size_t t = 0; t < ties.size(); ++t) {
    const CurveTie& tie = ties[t];
    for (const auto& equation :
         equationsOf(tie.kind, sides[t], curves[tie.a], curves[tie.b],
                     state.segment<3>(3 * static_cast<Eigen::Index>(tie.a)),
                     state.segment<3>(3 * static_cast<Eigen::Index>(tie.b))))
      rows.push_back({equation, tie});
  }
  EquationSystem system;
  const auto count = static_cast<Eigen::Index>(rows.size());
  system.value.resize(count);
  system.slope = Eigen::MatrixXd::Zero(count, state.size());
  for (Eigen::Index r = 0; r < count; ++r) {
    const Row& row = rows[static_cast<std::size_t>(r)];
    system.value[r] = row.equation.value;
    system.slope.block<1, 3>(r, 3 * static_cast<Eigen::Index>(row.tie.a)) +=
        row.equation.by_a.transpose();
    system.slope.block<1, 3>(r, 3 * static_cast<Eigen::Index>(row.tie.b)) +=
        row.equation.by_b.transpose();
  }
  return system;
}

} // namespace

Eigen::Matrix3d
lineInformation(double count, double deviation, double length)
{
  const double weight = count / (deviation * deviation);
  return Eigen::Vector3d(weight * length * length / 12, weight, 0).asDiagonal();
}

Eigen::Matrix3d
circleInformation(double count, double deviation, double from, double sweep)
{
  constexpr int parts = 64;
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  for (int k = 0; k < parts; ++k) {
    const double angle = from + sweep * (k + 0.5) / parts;
    const Eigen::Vector3d row(-std::cos(angle), -std::sin(angle), -1);
    information.noalias() += row * row.transpose();
  }
  return information * (count / (deviation * deviation) / parts);
}

double
contradiction(const MeasuredCurve& a, const MeasuredCurve& b, TieKind kind)
{
  const std::vector<TieEquation> equations =
      equationsOf(kind, tieSideOf(a, b, kind), a, b, stateOf(a), stateOf(b));
  const Eigen::Matrix3d covariance_a = covarianceOf(a);
  const Eigen::Matrix3d covariance_b = covarianceOf(b);
  const auto count = static_cast<Eigen::Index>(equations.size());
  Eigen::VectorXd value(count);
  Eigen::MatrixXd slope_a(count, 3);
  Eigen::MatrixXd slope_b(count, 3);
  for (Eigen::Index r = 0; r < count; ++r) {
    const TieEquation& e = equations[static_cast<std::size_t>(r)];
    value[r] = e.value;
    slope_a.row(r) = e.by_a.transpose();
    slope_b.row(r) = e.by_b.transpose();
  }
  const Eigen::MatrixXd covariance = slope_a * covariance_a * slope_a.transpose() +
                                     slope_b * covariance_b * slope_b.transpose();
  return value.dot(covariance.completeOrthogonalDecomposition().solve(value));
}

bool
adjustCurves(std::vector<MeasuredCurve>& curves, const std::vector<CurveTie>& ties)
{
  if (ties.empty())
    return true;
  constexpr int rounds = 30;
  const auto size = 3 * static_cast<Eigen::Index>(curves.size());
  Eigen::VectorXd start(size);
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(size, 3);
  std::vector<TieSide> sides;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const auto at = 3 * static_cast<Eigen::Index>(c);
    start.segment<3>(at) = stateOf(curves[c]);
    covariance.block<3, 3>(at, 0) = covarianceOf(curves[c]);
  }
  for (const auto& tie : ties)
    sides.push_back(tieSideOf(curves[tie.a], curves[tie.b], tie.kind));

  Eigen::VectorXd state = start;
  for (int round = 0; round < rounds; ++round) {
    const EquationSystem system = systemOf(curves, ties, sides, state);
    if (system.value.cwiseAbs().maxCoeff() < 1e-12 && round > 0)
      break;
    Eigen::MatrixXd spread(size, system.value.size()); // covariance times slope
    for (Eigen::Index at = 0; at < size; at += 3)
      spread.middleRows<3>(at) =
          covariance.block<3, 3>(at, 0) * system.slope.middleCols<3>(at).transpose();
    const Eigen::MatrixXd normal = system.slope * spread;
    const Eigen::VectorXd scale =
        normal.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
    const Eigen::MatrixXd scaled = scale.asDiagonal() * normal * scale.asDiagonal();
    const Eigen::VectorXd right =
        scale.cwiseProduct(system.value + system.slope * (start - state));
    // Ties that repeat each other make this singular: the least solution is meant.
    const Eigen::VectorXd force =
        scale.cwiseProduct(scaled.completeOrthogonalDecomposition().solve(right));
    state = start - spread * force;
    if (!state.allFinite())
      return false;
  }
  const EquationSystem system = systemOf(curves, ties, sides, state);
  if (!(system.value.cwiseAbs().maxCoeff() < 1e-9))
    return false;
  for (std::size_t c = 0; c < curves.size(); ++c)
    if (curves[c].curve.isCircle() &&
        !(state[3 * static_cast<Eigen::Index>(c) + 2] > 0))
      return false;
  for (std::size_t c = 0; c < curves.size(); ++c)
    setState(state.segment<3>(3 * static_cast<Eigen::Index>(c)), curves[c]);
  return true;
}

Eigen::Vector2d
touchingPoint(const PlanCurve& a, const PlanCurve& b)
{
  if (!a.isCircle())
    return a.project(b.point);
  const Eigen::Vector2d way = b.point - a.point;
  const double apart = way.norm();
  if (apart < 1e-12)
    return a.point + a.radius * Eigen::Vector2d::UnitX();
  // From the larger circle's centre the point lies towards the smaller one's, from
  // inside beyond it.
  const bool is_inside = apart < std::max(a.radius, b.radius);
  if (is_inside && a.radius < b.radius)
    return b.project(a.point);
  return a.project(b.point);
}

} // namespace sedr
} // namespace pcl
