// SPDX-License-Identifier: BSD-3-Clause
#include "plan_lines.h"

#include "sedr_filters/src/plan/plan_segment.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace pcl::sedr {
namespace {

/** @brief A flight as a plan shows it, which looks down from where it cuts. */
struct ShownFlight {
  const PlanFlight* flight = nullptr;
  std::uint32_t room = 0;
  std::size_t below = 0; ///< number of its risers below the cut

  /** @brief Returns the outline of its treads below the cut. */
  PlanLoop outline() const
  {
    PlanFlight part = *flight;
    part.risers.resize(std::min(below + 1, flight->steps()));
    return loopOf(part.outline());
  }
};

/** @brief Adds the lines of a flight: its treads, and an arrow up. It ends in a break
 * line where the plan cuts it. */
void
addFlight(const ShownFlight& shown, std::vector<PlanLine>& lines)
{
  constexpr double head = 0.15; // of the arrow, metres
  const PlanFlight& flight = *shown.flight;
  const auto add = [&](const std::vector<Eigen::Vector2d>& places) {
    for (std::size_t p = 0; p + 1 < places.size(); ++p)
      lines.push_back(
          {segment(places[p], places[p + 1]), PlanLayer::Stair, shown.room});
  };
  const auto& risers = flight.risers;
  const std::size_t below = shown.below;
  const bool is_cut = below < flight.steps();
  const std::size_t last = below - 1;
  for (std::size_t k = 0; k <= last; ++k)
    add({risers[k][0], risers[k][1]});
  for (std::size_t k = 0; k < last; ++k) {
    add({risers[k][0], risers[k + 1][0]});
    add({risers[k][1], risers[k + 1][1]});
    add({flight.middle(k), flight.middle(k + 1)});
  }
  if (last > 0) {
    const Eigen::Vector2d way =
        head * (flight.middle(last) - flight.middle(last - 1)).normalized();
    const Eigen::Vector2d left(-way.y() / 2, way.x() / 2);
    add({flight.middle(last) - way + left, flight.middle(last),
         flight.middle(last) - way - left});
  }
  if (!is_cut)
    return;
  // Across the tread at the cut: straight, up, down, straight.
  const auto across = [&](double share, double up) -> Eigen::Vector2d {
    const auto on = [&](const PlanFlight::Riser& riser) -> Eigen::Vector2d {
      return riser[0] + share * (riser[1] - riser[0]);
    };
    return on(risers[below - 1]) + up * (on(risers[below]) - on(risers[below - 1]));
  };
  add({across(0, 0.3), across(0.4, 0.5), across(0.45, 1), across(0.55, 0),
       across(0.6, 0.5), across(1, 0.7)});
}

} // namespace

void
addStairs(const Floorplan& plan, std::vector<PlanLine>& lines)
{
  constexpr double cut = 1.2; // metres above its floor
  std::vector<ShownFlight> shown;
  for (const PlanStair& stair : plan.stairs) {
    const std::array<bool, 2> has{findRoom(plan, stair.rooms[0]) != nullptr,
                                  findRoom(plan, stair.rooms[1]) != nullptr};
    for (const PlanFlight& flight : stair.flights) {
      std::size_t below = 0;
      while (below < flight.steps() &&
             (!has[0] || flight.bottom + flight.rise * static_cast<double>(below) <
                             stair.bottom + cut))
        ++below;
      if ((has[0] || has[1]) && below > 0 && flight.steps() > 1)
        shown.push_back({&flight, stair.rooms[has[0] ? 0 : 1], below});
    }
  }
  std::stable_sort(shown.begin(), shown.end(),
                   [](const ShownFlight& a, const ShownFlight& b) {
                     return a.flight->bottom > b.flight->bottom;
                   });
  std::vector<PlanLoop> drawn;
  for (const ShownFlight& flight : shown) {
    const auto covers = [&](const PlanLoop& above) {
      for (std::size_t k = 0; k + 1 < flight.below; ++k)
        if (above.contains((flight.flight->middle(k) + flight.flight->middle(k + 1)) /
                           2))
          return true;
      return false;
    };
    if (std::any_of(drawn.begin(), drawn.end(), covers))
      continue;
    drawn.push_back(flight.outline());
    addFlight(flight, lines);
  }
}

} // namespace pcl::sedr
