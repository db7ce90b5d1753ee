// SPDX-License-Identifier: BSD-3-Clause
#include "verdict.h"

#include "sedr_filters/src/base/number_text.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <string>

namespace pcl::sedr {

double
areaOf(const Floorplan& plan)
{
  double area = 0;
  for (const PlanRoom& room : plan.rooms)
    area += room.area();
  return area;
}

namespace {

constexpr double little = 0.02;  // share of walls and floors, after the checks
constexpr double too_much = 0.1; // likewise, of all that a new scan settles

using DoubtIterator = std::vector<PlanDoubt>::const_iterator;

/** @brief Returns the square metres that doubts put at stake, each counted once: a room
 * for what exceeds its walls, openings and parts, the plan for what exceeds its rooms.
 */
double
stakeOf(DoubtIterator doubt, DoubtIterator end)
{
  std::map<std::uint32_t, double> wholes, parts; // by room
  double plan = 0;
  double rooms = 0;
  for (; doubt != end; ++doubt)
    if (doubt->extent == Stake::Plan)
      plan = std::max(plan, doubt->stake);
    else if (doubt->extent == Stake::Room)
      wholes[doubt->room] = std::max(wholes[doubt->room], doubt->stake);
    else
      parts[doubt->room] += doubt->stake;
  for (const auto& [room, stake] : parts)
    wholes[room] = std::max(wholes[room], stake);
  for (const auto& whole : wholes)
    rooms += whole.second;
  return std::max(plan, rooms);
}

/** @brief Checks whether a doubt is settled by an option of the run: --unit, --up. */
bool
isOfFrame(const PlanDoubt& doubt)
{
  return std::any_of(doubt.kinds.begin(), doubt.kinds.end(), [](WarningKind kind) {
    return kind == WarningKind::Unit || kind == WarningKind::Up;
  });
}

} // namespace

void
setVerdict(const Floorplan& plan, PlanReview& review)
{
  double area = 0;
  for (const Certainty& wall : review.walls) {
    area += wall.area;
    for (std::size_t k = 0; k < review.within.size(); ++k)
      review.within[k] += wall.area * wall.within[k];
  }
  for (double& share : review.within)
    share = area > 0 ? share / area : 1;
  const double all = area + areaOf(plan);
  const auto first = review.doubts.cbegin(), end = review.doubts.cend();
  const double at_stake = stakeOf(std::find_if_not(first, end, isOfFrame), end) / all;
  const std::size_t most = std::min(leading_doubts, review.doubts.size());
  double left = stakeOf(first, end) / all;
  const auto isLikelyWrong = [&](const PlanDoubt& doubt) {
    const std::set<std::string> subjects = leadingSubjects({doubt});
    const auto isOf = [&](const Certainty& certainty) {
      return certainty.right() < 0.5 &&
             std::any_of(subjects.begin(), subjects.end(), [&](const auto& subject) {
               return subject.substr(subject.find(' ') + 1) == certainty.element;
             });
    };
    return std::any_of(review.walls.begin(), review.walls.end(), isOf) ||
           std::any_of(review.openings.begin(), review.openings.end(), isOf) ||
           std::count(doubt.kinds.begin(), doubt.kinds.end(), WarningKind::NoDoor) > 0;
  };
  const auto leading = first + static_cast<std::ptrdiff_t>(most);
  for (auto next = first; next != leading; ++next)
    if (left > little || std::any_of(next, leading, isLikelyWrong)) {
      left = stakeOf(next + 1, end) / all;
      ++review.checks;
    }
  if (at_stake > too_much) {
    review.verdict = ReviewVerdict::ScanAgain;
    review.text =
        "scan again, " + percentText(at_stake) + " of walls and floors are at stake";
  }
  else if (review.checks > 0) {
    review.verdict = ReviewVerdict::Check;
    review.text = "check " +
                  (review.checks == 1
                       ? "this place"
                       : "the first " + std::to_string(review.checks) + " places") +
                  " before you hand it over";
    if (left > little)
      review.text += " (" + percentText(left) + " of walls and floors remain at stake)";
  }
  else
    review.text = "hand it over";
  if (area > 0)
    review.text += ": " + percentText(review.within[0]) +
                   " of the walls are expected within 1 cm of the true ones, " +
                   percentText(review.within[1]) + " within 3 cm, " +
                   percentText(review.within[2]) + " within 5 cm";
}

} // namespace pcl::sedr
