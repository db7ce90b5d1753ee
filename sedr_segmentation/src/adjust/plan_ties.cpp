// SPDX-License-Identifier: BSD-3-Clause
#include "plan_ties.h"

#include "sedr_filters/src/base/parallel.h"

#include <Eigen/Cholesky>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

namespace {

double
angleOf(const Unknown& line)
{
  return std::atan2(line.direction.y(), line.direction.x());
}

PlanTieEquation
onLine(const PlanTie& tie, const Unknown& a, const Unknown& b)
{
  const Eigen::Vector2d left = leftOf(a.direction);
  const Eigen::Vector2d way = b.point - a.point;
  return {left.dot(way),
          {{3 * tie.a, -1},
           {3 * tie.a + 1, -a.direction.dot(way)},
           {3 * tie.b, left.dot(leftOf(b.direction))}}};
}

PlanTieEquation
tangent(const PlanTie& tie, const Unknown& a, const Unknown& b)
{
  const Eigen::Vector2d way = b.point - a.point;
  if (a.kind == UnknownKind::Line) {
    const Eigen::Vector2d left = leftOf(a.direction);
    return {left.dot(way) - tie.side * b.radius,
            {{3 * tie.a, -1},
             {3 * tie.a + 1, -a.direction.dot(way)},
             {3 * tie.b, left.x()},
             {3 * tie.b + 1, left.y()},
             {3 * tie.b + 2, -tie.side}}};
  }
  const double apart = std::max(1e-12, way.norm());
  const Eigen::Vector2d u = way / apart;
  const double of_a = tie.side < 0 || a.radius > b.radius ? -1 : 1;
  const double of_b = tie.side < 0 ? -1 : -of_a;
  return {apart + of_a * a.radius + of_b * b.radius,
          {{3 * tie.a, -u.x()},
           {3 * tie.a + 1, -u.y()},
           {3 * tie.a + 2, of_a},
           {3 * tie.b, u.x()},
           {3 * tie.b + 1, u.y()},
           {3 * tie.b + 2, of_b}}};
}

} // namespace

std::vector<PlanTieEquation>
equationsOf(const PlanTie& tie, const std::vector<Unknown>& unknowns)
{
  const Unknown& a = unknowns[tie.a];
  const Unknown& b = unknowns[tie.b];
  switch (tie.kind) {
  case PlanTieKind::Direction:
    return {{std::remainder(angleOf(a) - angleOf(b), M_PI / 2),
             {{3 * tie.a + 1, 1}, {3 * tie.b + 1, -1}}}};
  case PlanTieKind::OnLine:
    return {onLine(tie, a, b)};
  case PlanTieKind::Tangent:
    return {tangent(tie, a, b)};
  case PlanTieKind::Level:
    return {{a.slope.x(), {{3 * tie.a + 1, 1}}}, {a.slope.y(), {{3 * tie.a + 2, 1}}}};
  case PlanTieKind::EqualSlope:
    return {{a.slope.x() - b.slope.x(), {{3 * tie.a + 1, 1}, {3 * tie.b + 1, -1}}},
            {a.slope.y() - b.slope.y(), {{3 * tie.a + 2, 1}, {3 * tie.b + 2, -1}}}};
  case PlanTieKind::EqualHeight:
    return {{a.height - b.height, {{3 * tie.a, 1}, {3 * tie.b, -1}}}};
  }
  return {};
}

TieOdds
oddsOf(const PlanTie& tie, const std::vector<Unknown>& unknowns)
{
  const std::vector<PlanTieEquation> equations = equationsOf(tie, unknowns);
  const auto size = static_cast<Eigen::Index>(equations.size());
  Eigen::VectorXd value(size);
  Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero(size, 6);
  for (Eigen::Index r = 0; r < size; ++r) {
    const PlanTieEquation& equation = equations[static_cast<std::size_t>(r)];
    value[r] = equation.value;
    for (const auto& [column, slope] : equation.slopes)
      slopes(r, static_cast<Eigen::Index>(column % 3 + (column / 3 == tie.a ? 0 : 3))) =
          slope;
  }
  Eigen::MatrixXd both = Eigen::MatrixXd::Zero(6, 6);
  both.topLeftCorner<3, 3>() = unknowns[tie.a].information.inverse();
  both.bottomRightCorner<3, 3>() = unknowns[tie.b].information.inverse();
  const Eigen::MatrixXd covariance = slopes * both * slopes.transpose();
  return {value.dot(covariance.ldlt().solve(value)) / 2,
          -std::log((2 * M_PI * covariance).determinant()) / 2};
}

namespace {

using Sparse = Eigen::SparseMatrix<double>;

/** @brief The ties about some values of the unknowns: value + slopes times steps = 0.
 * An equation counts in its standard deviations over the root of the stiffness. */
struct LinearTies {
  Eigen::VectorXd value;
  Sparse slopes;
  double worst = 0; ///< of the values, unscaled
};

Sparse
informationOf(const std::vector<Unknown>& unknowns)
{
  const auto size = static_cast<Eigen::Index>(3 * unknowns.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t u = 0; u < unknowns.size(); ++u)
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k)
        entries.emplace_back(static_cast<int>(3 * u) + i, static_cast<int>(3 * u) + k,
                             unknowns[u].information(i, k));
  Sparse information(size, size);
  information.setFromTriplets(entries.begin(), entries.end());
  return information;
}

LinearTies
linearTies(const std::vector<PlanTie>& ties,
           const std::vector<Unknown>& unknowns,
           const Eigen::VectorXd& precision)
{
  constexpr double stiffness = 1e6; // of an equation, relative to its own information
  std::vector<PlanTieEquation> equations;
  for (const PlanTie& tie : ties)
    for (PlanTieEquation& equation : equationsOf(tie, unknowns))
      equations.push_back(std::move(equation));
  const auto count = static_cast<Eigen::Index>(equations.size());
  LinearTies linear{Eigen::VectorXd(count), Sparse(count, precision.size())};
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index e = 0; e < count; ++e) {
    const PlanTieEquation& equation = equations[static_cast<std::size_t>(e)];
    double variance = 0;
    for (const auto& [i, slope] : equation.slopes)
      variance += slope * slope / precision[static_cast<Eigen::Index>(i)];
    const double scale = std::sqrt(stiffness / variance);
    linear.value[e] = scale * equation.value;
    for (const auto& [i, slope] : equation.slopes)
      entries.emplace_back(static_cast<int>(e), static_cast<int>(i), scale * slope);
    linear.worst = std::max(linear.worst, std::abs(equation.value));
  }
  linear.slopes.setFromTriplets(entries.begin(), entries.end());
  return linear;
}

} // namespace

bool
solveTies(const std::vector<PlanTie>& ties, std::vector<Unknown>& unknowns)
{
  constexpr int max_rounds = 20;
  constexpr int turns = 8;
  constexpr double exact = 1e-12;
  constexpr double good = 1e-9;
  const std::vector<Unknown> start = unknowns;
  std::vector<Unknown> moved = unknowns;
  const Sparse information = informationOf(start);
  const Eigen::VectorXd precision = information.diagonal();
  Eigen::VectorXd step = Eigen::VectorXd::Zero(information.rows());
  Eigen::VectorXd forces; // that hold the equations
  double worst = 0;
  for (int round = 0; round < max_rounds; ++round) {
    const LinearTies linear = linearTies(ties, moved, precision);
    worst = linear.worst;
    if (round > 0 && worst < exact)
      break;
    const Sparse turned = linear.slopes.transpose();
    const Eigen::SimplicialLDLT<Sparse> solver(information +
                                               Sparse(turned * linear.slopes));
    if (solver.info() != Eigen::Success)
      return false;
    // Minimises step' information step where value + slopes (step - before) = 0.
    const Eigen::VectorXd wanted = linear.slopes * step - linear.value;
    if (round == 0)
      forces = Eigen::VectorXd::Zero(wanted.size());
    for (int turn = 0; turn < turns; ++turn) {
      step = solver.solve(turned * (wanted - forces));
      forces += linear.slopes * step - wanted;
    }
    if (!step.allFinite())
      return false;
    moved = start;
    for (std::size_t u = 0; u < moved.size(); ++u)
      moved[u].move(step.segment<3>(static_cast<Eigen::Index>(3 * u)));
  }
  if (!(worst < good))
    return false;
  for (const Unknown& u : moved)
    if (u.kind == UnknownKind::Circle && !(u.radius > 0))
      return false;
  unknowns = std::move(moved);
  return true;
}

void
setCovariances(const std::vector<PlanTie>& ties,
               unsigned threads,
               std::vector<Unknown>& unknowns)
{
  const Sparse information = informationOf(unknowns);
  const LinearTies linear = linearTies(ties, unknowns, information.diagonal());
  const Eigen::SimplicialLDLT<Sparse> solver(
      information + Sparse(Sparse(linear.slopes.transpose()) * linear.slopes));
  if (solver.info() != Eigen::Success)
    return;
  std::vector<bool> is_tied(unknowns.size(), false);
  for (const PlanTie& tie : ties)
    is_tied[tie.a] = is_tied[tie.b] = true;
  parallelBlocks(unknowns.size(), 1, threads, [&](std::size_t u, std::size_t) {
    Unknown& unknown = unknowns[u];
    unknown.covariance = unknown.information.inverse();
    if (!is_tied[u])
      return;
    Eigen::MatrixXd units = Eigen::MatrixXd::Zero(information.rows(), 3);
    units.middleRows<3>(static_cast<Eigen::Index>(3 * u)).setIdentity();
    unknown.covariance = Eigen::MatrixXd(solver.solve(units))
                             .middleRows<3>(static_cast<Eigen::Index>(3 * u));
  });
}

} // namespace pcl::sedr
