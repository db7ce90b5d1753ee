// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_unknowns.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace pcl::sedr {

enum class PlanTieKind {
  Direction,  ///< of two lines: parallel or square, whichever is nearer
  OnLine,     ///< the middle of line b is on line a
  Tangent,    ///< of a line or circle a and a circle b
  Level,      ///< a plane
  EqualSlope, ///< of two planes
  EqualHeight ///< of two level planes
};

/** @brief A relation of two unknowns, or of one (a = b). */
struct PlanTie {
  PlanTieKind kind = PlanTieKind::Direction;
  std::size_t a = 0;
  std::size_t b = 0;
  int side = 0; ///< of a tangent: sign of the distance of the circle's centre; of
                ///< circles 1 inside, -1 outside
};

/** @brief A linearised equation of a tie: value + sum of slopes times steps = 0. */
struct PlanTieEquation {
  double value = 0;
  std::vector<std::pair<std::size_t, double>> slopes; ///< by 3 * unknown + parameter
};

/** @brief Returns the equations of a tie for moved unknowns. */
std::vector<PlanTieEquation> equationsOf(const PlanTie& tie,
                                         const std::vector<Unknown>& unknowns);

/** @brief What speaks against a tie and for it, nats. */
struct TieOdds {
  double
      contradiction; ///< half of that of its unknowns in standard deviations, squared
  double sharpness;  ///< -1/2 ln det (2 pi C) of the covariance C of its equations
};

TieOdds oddsOf(const PlanTie& tie, const std::vector<Unknown>& unknowns);

/** @brief Moves the unknowns by the least amount, weighted by their information, that
 * fulfils all ties: Gauss-Newton with one sparse Cholesky factorisation a round, of the
 * augmented Lagrangian. Ties may be redundant.
 * @return false, with unchanged unknowns, if the ties cannot be fulfilled */
bool solveTies(const std::vector<PlanTie>& ties, std::vector<Unknown>& unknowns);

/** @brief Sets the covariance of the values of each unknown, given its information and
 * the ties that hold. O(tied unknowns x all). */
void setCovariances(const std::vector<PlanTie>& ties,
                    unsigned threads,
                    std::vector<Unknown>& unknowns);

/** @brief Chooses the ties that are more probable than chance. */
std::vector<PlanTie> chooseTies(const PlanUnknowns& plan,
                                const AdjustmentParameters& parameters);

} // namespace pcl::sedr
