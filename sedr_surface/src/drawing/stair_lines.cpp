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
  std::size_t first = 0; ///< number of those that a higher flight hides

  /** @brief Returns the outline of its treads below the cut. */
  PlanLoop outline() const
  {
    PlanFlight part = *flight;
    part.risers.resize(std::min(below + 1, flight->steps()));
    return loopOf(part.outline());
  }

  /** @brief Hides the treads up to the last one below another flight. */
  void hideBelow(const PlanLoop& above)
  {
    for (std::size_t k = first; k + 1 < below; ++k)
      if (above.contains((flight->middle(k) + flight->middle(k + 1)) / 2))
        first = k + 1;
  }
};

/** @brief Adds the lines of a flight: its treads, and the line on which one walks, from
 * a dot at its foot to an arrow. It ends in two break lines where the plan cuts it. */
void
addFlight(const ShownFlight& shown, std::vector<PlanLine>& lines)
{
  constexpr double head = 0.15; // of the arrow, metres
  constexpr double dot = 0.04;  // its radius, metres
  const PlanFlight& flight = *shown.flight;
  const auto addElement = [&](const PlanElement& element) {
    lines.push_back({element, PlanLayer::Stair, shown.room});
  };
  const auto add = [&](const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    addElement(segment(from, to));
  };
  const auto& risers = flight.risers;
  const std::size_t last = shown.below - 1;
  for (std::size_t k = shown.first; k <= last; ++k)
    add(risers[k][0], risers[k][1]);
  for (std::size_t k = shown.first; k < last; ++k) {
    add(risers[k][0], risers[k + 1][0]);
    add(risers[k][1], risers[k + 1][1]);
    add(flight.middle(k), flight.middle(k + 1));
  }
  if (shown.first == 0) {
    PlanElement foot = segment(flight.middle(0) + Eigen::Vector2d(dot, 0),
                               flight.middle(0) + Eigen::Vector2d(dot, 0));
    foot.centre = flight.middle(0);
    foot.radius = dot;
    addElement(foot);
  }
  if (last > shown.first) {
    const Eigen::Vector2d way =
        head * (flight.middle(last) - flight.middle(last - 1)).normalized();
    const Eigen::Vector2d left(-way.y() / 2, way.x() / 2);
    add(flight.middle(last) - way + left, flight.middle(last));
    add(flight.middle(last), flight.middle(last) - way - left);
  }
  if (shown.below == flight.steps())
    return;
  const Eigen::Vector2d across = (risers[last][1] - risers[last][0]).normalized();
  const Eigen::Vector2d onwards =
      flight.going() * Eigen::Vector2d(-across.y(), across.x());
  const auto along = [&](std::size_t side, double up) -> Eigen::Vector2d {
    return risers[last][side] + up * onwards;
  };
  for (const double up : {0.15, 0.4})
    add(along(0, up), along(1, up + 0.45));
  add(risers[last][0], along(0, 0.4));
  add(risers[last][1], along(1, 0.85));
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
  for (ShownFlight& flight : shown) {
    for (const PlanLoop& above : drawn)
      flight.hideBelow(above);
    drawn.push_back(flight.outline());
    if (flight.first + 1 < flight.below)
      addFlight(flight, lines);
  }
}

} // namespace pcl::sedr
