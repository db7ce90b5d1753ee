// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/certainty.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace pcl::sedr {

constexpr std::size_t leading_doubts = 10; ///< as many head a report

/** @brief A place of a plan to look at, with all that is doubted there. */
struct PlanDoubt {
  std::string subject;    ///< "wall 7.8", "door D3", "room 4"; empty: the whole
  std::uint32_t room = 0; ///< 0: not of one room
  Eigen::Vector2d at =    ///< in plan; NaN if it has no place
      Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
  double stake = 0;                 ///< square metres times odds of being wrong
  Stake extent = Stake::None;       ///< Room, Plan: its parts may be doubted too
  std::vector<WarningKind> kinds{}; ///< of the warnings; none: it is just not sure
  std::string text{};               ///< what to do, and why
};

/** @brief What to make of a plan. */
enum class ReviewVerdict { HandOver, Check, ScanAgain };

/** @brief What of a plan to look at before it is used. */
struct PlanReview {
  std::vector<Certainty> walls;
  std::vector<Certainty> openings;
  std::vector<PlanDoubt> doubts;  ///< one a place; what puts most at stake comes first
  std::array<double, 3> within{}; ///< expected shares of the walls' area; 1: no walls
  ReviewVerdict verdict = ReviewVerdict::HandOver;
  std::size_t checks = 0; ///< as many doubts to look at, the first ones
  std::string text;       ///< the verdict, a sentence
};

/** @brief Returns the review of a plan.
 *
 * Warnings of one wall, opening or room at one place are one doubt, and so are walls
 * and openings that are less than 90 % sure. So many of the first ten are to be checked
 * that the rest puts 2 % of walls and floors at stake; if all but unit and up put more
 * than a tenth at stake, scanning again is better. A room and its walls count once.
 * Odds of walls and openings are fitted, see Certainty, and those of common warnings.
 * @param plan its openings have numbers, see numberOpenings()
 * @param warnings of the stages; what is unlikely in a building is added here */
PlanReview reviewOf(const Floorplan& plan, const std::vector<PlanWarning>& warnings);

/** @brief Returns the texts of the first `most` doubts, and how many more there are.
 */
std::vector<std::string> firstOf(const std::vector<PlanDoubt>& doubts,
                                 std::size_t most = 3);

} // namespace pcl::sedr
