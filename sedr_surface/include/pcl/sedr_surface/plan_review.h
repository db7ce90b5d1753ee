// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/plan_warning.h>
#include <pcl/sedr_segmentation/building.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief Distances from the truth for which a Certainty has probabilities, metres. */
constexpr std::array<double, 3> certainty_steps{0.01, 0.03, 0.05};

/** @brief How sure it is that a wall is where the building has one, or that an opening
 * is there, of its kind, with its edges where they are. */
struct Certainty {
  std::string element;         ///< "7.8": wall 8 of room 7; "D3", see markOf()
  std::uint32_t room = 0;      ///< of an opening one of its rooms
  std::size_t index = 0;       ///< of the wall in the room, of the opening in the plan
  double area = 0;             ///< of the wall with its openings, of the opening; m2
  std::vector<double> signs{}; ///< what tells it, see wallSigns(), openingSigns()
  std::array<double, 3> within{}; ///< probabilities, see certainty_steps

  /** @brief Returns the probability that it is right: within 5 cm. */
  double right() const { return within.back(); }
};

/** @brief Returns what the signs of walls and openings are: "log_length". */
std::vector<std::string> wallSigns();
std::vector<std::string> openingSigns();

/** @brief Returns the certainty of all walls but those that are an opening from end to
 * end, in the order of the plan; none of a plan that tells of no wall what was seen of
 * it. In others a wall of which nothing is known was not seen. Probabilities are
 * logistic functions of the signs, fitted on buildings whose truth is known: see
 * doc/reliability.md. O(walls times openings). */
std::vector<Certainty> certaintyOfWalls(const Floorplan& plan,
                                        const std::vector<PlanWarning>& warnings);

/** @brief Likewise of openings; nothing is known of those whose edges were not measured
 * or were set by hand. */
std::vector<Certainty> certaintyOfOpenings(const Floorplan& plan);

/** @brief A part of the building that the scan shows but the plan does not contain. */
struct CoverageGap {
  std::string reason; ///< reason for users, e.g. "room 3: no plan could be fitted"
  double area = 0;    ///< area, square metres
  double floor = 0;   ///< height of the floor, metres
  double ceiling = 0; ///< height of the ceiling, metres
  Eigen::Vector2d at = Eigen::Vector2d::Zero(); ///< a point inside the part
  /** Whether the part is usable floor inside the building. False for places without
   * headroom, outdoors, or seen only through glass. */
  bool counts = true;
};

/** @brief How much of the scanned floor the plan contains. Both areas count only usable
 * floor inside the building, without voids within slabs and below furniture. */
struct Coverage {
  double seen = 0;     ///< square metres: modelled, plus left out inside the building
  double modelled = 0; ///< square metres: the rooms of the plan
  double not_counted = 0;            ///< square metres left out that do not count
  std::vector<CoverageGap> left_out; ///< counting parts first, then by area

  /** @brief Returns the modelled share, 0 to 1; 1 if nothing was seen. */
  double share() const { return seen > 0 ? modelled / seen : 1; }

  /** @brief Returns the largest part left out that counts; null if there is none. */
  const CoverageGap* largest() const;
};

/** @brief Compares a plan with the building it was made from. Rooms of both have the
 * same ids.
 *
 * Reported as left out: rooms without a plan, parts of rooms outside their plan, and
 * Building::left_out. A room of which an opening shows a part counts as inside, and so
 * does a place without walls that is larger than every room of the plan. Others count
 * as glimpses through an opening. O(columns times elements of their room's loop). */
Coverage coverageOf(const Building& building, const Floorplan& plan);

/** @brief Returns a warning if the coverage is below nine tenths. It names the largest
 * part left out, with area, place and reason. */
std::optional<PlanWarning> coverageWarning(const Coverage& coverage);

constexpr std::size_t leading_doubts = 10; ///< as many head a report

/** @brief A place of a plan to look at, with all that is doubted there. */
struct PlanDoubt {
  std::string subject; ///< "wall 7.8", "door D3", "room 4"; empty: the whole
  std::vector<std::string> beside{}; ///< others within a metre, told with it
  std::uint32_t room = 0;            ///< 0: not of one room
  Eigen::Vector2d at =               ///< in plan; NaN if it has no place
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
  std::vector<PlanDoubt> doubts; ///< one a place; what puts most at stake comes first
  std::vector<std::string> remarks; ///< on the whole, with no place to look at
  std::array<double, 3> within{};   ///< expected shares of the walls' area; 1: no walls
  ReviewVerdict verdict = ReviewVerdict::HandOver;
  std::size_t checks = 0; ///< as many doubts to look at, the first ones
  std::string text;       ///< the verdict, a sentence
};

/** @brief Returns the review of a plan.
 *
 * Warnings of one wall, opening or room at one place are one doubt, and so are walls
 * and openings that are less than 90 % sure; within a metre on one storey all are one,
 * but for those of whole rooms. So many of the first ten are to be checked that the
 * rest puts 2 % of walls and floors at stake and has no wall or opening among
 * these ten that is rather wrong than right, nor a room without a way in; if all but
 * unit and up put more than a tenth at stake, scanning again is better. A room and its
 * walls count once. Odds of walls and openings are fitted, see Certainty, and those of
 * common warnings.
 * @param plan its openings have numbers, see numberOpenings()
 * @param warnings of the stages; what is unlikely in a building is added here */
PlanReview reviewOf(const Floorplan& plan, const std::vector<PlanWarning>& warnings);

/** @brief Returns the subjects of the doubts that head a report. */
std::set<std::string> leadingSubjects(const std::vector<PlanDoubt>& doubts,
                                      std::size_t most = leading_doubts);

/** @brief Returns which walls are among subjects of doubts, for drawings: see
 * DrawingSettings::is_numbered. */
std::function<bool(std::uint32_t, std::size_t)>
wallsAmong(std::set<std::string> subjects);

/** @brief Returns the texts of the first `most` doubts, and how many more there are.
 */
std::vector<std::string> firstOf(const std::vector<PlanDoubt>& doubts,
                                 std::size_t most = 3);

} // namespace pcl::sedr
