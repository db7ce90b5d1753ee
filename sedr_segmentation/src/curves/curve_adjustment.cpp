// SPDX-License-Identifier: BSD-3-Clause
#include "tie_equations.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

namespace {

/** @brief Returns the parameters: angle and offset at the pivot, or centre and radius.
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

/** @brief Returns the covariance of a curve's parameters; 0 for the third of a line. */
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

/** @brief Returns a root r of a curve's covariance, i.e. r times its transpose. */
Eigen::Matrix3d
spreadOf(const MeasuredCurve& m)
{
  const Eigen::LDLT<Eigen::Matrix3d> parts(covarianceOf(m));
  const Eigen::Matrix3d lower = parts.matrixL();
  const Eigen::Vector3d deviations = parts.vectorD().cwiseMax(0).cwiseSqrt();
  return parts.transpositionsP().transpose() *
         Eigen::Matrix3d(lower * deviations.asDiagonal());
}

/** @brief A linearised equation of a tie, with respect to the parameters of its two
 * curves in standard deviations. */
struct TieRow {
  double value = 0;
  std::size_t a = 0;
  std::size_t b = 0;
  Eigen::Vector3d by_a = Eigen::Vector3d::Zero();
  Eigen::Vector3d by_b = Eigen::Vector3d::Zero();

  double squaredNorm() const
  {
    return a == b ? (by_a + by_b).squaredNorm()
                  : by_a.squaredNorm() + by_b.squaredNorm();
  }
};

/** @brief Iteratively solves the equations of ties for the minimum step. */
class TieSolver {
public:
  TieSolver(const std::vector<MeasuredCurve>& curves, const std::vector<CurveTie>& ties)
      : curves_(curves)
      , ties_(ties)
      , step_(Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(curves.size())))
  {
    for (const auto& curve : curves) {
      spreads_.push_back(spreadOf(curve));
      starts_.push_back(stateOf(curve));
    }
    for (const auto& tie : ties)
      sides_.push_back(tieSideOf(curves[tie.a], curves[tie.b], tie.kind));
    findRows();
    force_ = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(rows_.size()));
  }

  /** @brief Returns the current parameters of a curve. */
  Eigen::Vector3d state(std::size_t c) const
  {
    return starts_[c] +
           spreads_[c] * step_.segment<3>(3 * static_cast<Eigen::Index>(c));
  }

  /** @brief Returns the largest residual of the equations. */
  double worst() const
  {
    double most = 0;
    for (const TieRow& row : rows_)
      most = std::max(most, std::isnan(row.value) ? HUGE_VAL : std::abs(row.value));
    return most;
  }

  /** @brief Moves to the minimum step from the start that solves the linearised
   * equations; returns false if there is none. */
  bool solve()
  {
    // Each equation involves two curves, so the matrix of steps and multipliers is
    // sparse, however many curves are tied to one. Redundant ties would make it
    // singular. The damping of the multipliers, whose effect the turns remove, prevents
    // this.
    constexpr double damping = 1e-8;
    constexpr int turns = 4;
    const Eigen::Index steps = step_.size();
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd right(force_.size());
    Eigen::VectorXd scale(force_.size());
    for (Eigen::Index i = 0; i < steps; ++i)
      entries.emplace_back(i, i, 1);
    for (Eigen::Index r = 0; r < right.size(); ++r) {
      const TieRow& row = rows_[static_cast<std::size_t>(r)];
      scale[r] = 1 / std::max(1e-150, std::sqrt(row.squaredNorm()));
      double at_start = row.value;
      for (const bool of_b : {false, true}) {
        const Eigen::Index at = 3 * static_cast<Eigen::Index>(of_b ? row.b : row.a);
        const Eigen::Vector3d& slope = of_b ? row.by_b : row.by_a;
        at_start -= slope.dot(step_.segment<3>(at));
        for (Eigen::Index k = 0; k < 3; ++k)
          if (slope[k] != 0)
            entries.emplace_back(steps + r, at + k, scale[r] * slope[k]);
      }
      right[r] = -scale[r] * at_start;
      entries.emplace_back(steps + r, steps + r, -damping);
    }
    Eigen::SparseMatrix<double> matrix(steps + right.size(), steps + right.size());
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
    if (solver.info() != Eigen::Success)
      return false;
    for (int turn = 0; turn < turns; ++turn) {
      Eigen::VectorXd sides = Eigen::VectorXd::Zero(matrix.rows());
      sides.tail(right.size()) = right - damping * force_;
      const Eigen::VectorXd solution = solver.solve(sides);
      step_ = solution.head(steps);
      force_ = solution.tail(right.size());
    }
    if (!step_.allFinite())
      return false;
    findRows();
    return true;
  }

private:
  void findRows()
  {
    rows_.clear();
    for (std::size_t t = 0; t < ties_.size(); ++t) {
      const CurveTie& tie = ties_[t];
      for (const auto& equation :
           equationsOf(tie.kind, sides_[t], curves_[tie.a], curves_[tie.b],
                       state(tie.a), state(tie.b)))
        rows_.push_back({equation.value, tie.a, tie.b,
                         spreads_[tie.a].transpose() * equation.by_a,
                         spreads_[tie.b].transpose() * equation.by_b});
    }
  }

  const std::vector<MeasuredCurve>& curves_;
  const std::vector<CurveTie>& ties_;
  std::vector<Eigen::Matrix3d> spreads_;
  std::vector<Eigen::Vector3d> starts_;
  std::vector<TieSide> sides_;
  std::vector<TieRow> rows_;
  Eigen::VectorXd step_;  ///< from the start, three per curve, in standard deviations
  Eigen::VectorXd force_; ///< multiplier of each row
};

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
  constexpr double exactness = 1e-12;
  TieSolver solver(curves, ties);
  for (int round = 0; round < rounds; ++round) {
    if (solver.worst() < exactness && round > 0)
      break;
    if (!solver.solve())
      return false;
  }
  if (!(solver.worst() < 1e-9))
    return false;
  for (std::size_t c = 0; c < curves.size(); ++c)
    if (curves[c].curve.isCircle() && !(solver.state(c)[2] > 0))
      return false;
  std::vector<MeasuredCurve> moved = curves;
  for (std::size_t c = 0; c < curves.size(); ++c)
    setState(solver.state(c), moved[c]);
  curves = std::move(moved);
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
  // Seen from the larger circle's centre, the point lies in the direction of the
  // smaller one's centre, beyond it if inside.
  const bool is_inside = apart < std::max(a.radius, b.radius);
  if (is_inside && a.radius < b.radius)
    return b.project(a.point);
  return a.project(b.point);
}

} // namespace pcl::sedr
