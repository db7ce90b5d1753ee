// SPDX-License-Identifier: BSD-3-Clause
#include "stair_flights.h"

#include "sedr_filters/src/plan/plan_geometry.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl::sedr {

namespace {

/** @brief The riser before the first of a flight or after its last, as it runs and
 * turns there. */
PlanFlight::Riser
nextRiser(const PlanFlight& flight, bool is_foot)
{
  const std::size_t last = flight.steps() - 1;
  const std::size_t end = is_foot ? 0 : last;
  const std::size_t inner = is_foot ? 1 : last - 1;
  const Eigen::Vector2d middle = flight.middle(end);
  const Eigen::Vector2d a = flight.risers[inner][0] - flight.risers[inner][1];
  const Eigen::Vector2d b = flight.risers[end][0] - flight.risers[end][1];
  const Eigen::Rotation2Dd turn(std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)));
  PlanFlight::Riser next = flight.risers[end];
  for (Eigen::Vector2d& corner : next)
    corner = middle + turn * (corner - flight.middle(inner));
  return next;
}

} // namespace

PlanFlight
flightOf(const StraightSteps& steps)
{
  PlanFlight flight;
  const int first = steps.treads.front().number;
  std::array<double, 2> reach = steps.treads.front().patch->extent(leftOf(steps.way));
  for (const Tread& tread : steps.treads) {
    const auto [right, left] = tread.patch->extent(leftOf(steps.way));
    reach = {std::min(reach[0], right), std::max(reach[1], left)};
  }
  for (int k = first; k <= steps.treads.back().number + 1; ++k) {
    const Eigen::Vector2d at = (steps.front + k * steps.going) * steps.way;
    flight.risers.push_back(
        {at + reach[1] * leftOf(steps.way), at + reach[0] * leftOf(steps.way)});
  }
  flight.bottom = steps.level + (first - 1) * steps.rise;
  flight.rise = steps.rise;
  return flight;
}

PlanFlight
turningFlight(const std::vector<Tread>& treads)
{
  PlanFlight flight;
  std::vector<double> heights{treads.front().patch->z};
  for (std::size_t k = 1; k < treads.size(); ++k) {
    const Tread& a = treads[k - 1];
    const Tread& b = treads[k];
    heights.push_back(b.patch->z);
    const Eigen::Vector2d step = b.patch->middle - a.patch->middle;
    const Eigen::Vector2d across = leftOf(step.normalized());
    const auto [a_right, a_left] = a.patch->extent(across);
    const auto [b_right, b_left] = b.patch->extent(across);
    const double right = (a_right + b_right) / 2 - across.dot(a.patch->middle);
    const double left = (a_left + b_left) / 2 - across.dot(a.patch->middle);
    for (int n = 0; n < b.number - a.number; ++n) { // over those that nobody saw
      const Eigen::Vector2d at =
          a.patch->middle + (n + 0.5) / (b.number - a.number) * step;
      flight.risers.push_back({at + left * across, at + right * across});
    }
  }
  const Eigen::Vector2d line = lineThrough(treads, heights);
  flight.bottom = line[0] - line[1];
  flight.rise = line[1];
  flight.risers.insert(flight.risers.begin(), nextRiser(flight, true));
  flight.risers.push_back(nextRiser(flight, false));
  return flight;
}

std::vector<std::vector<Tread>>
treadsOf(const std::vector<StairStep>& chain, const std::vector<LevelPatch>& patches)
{
  std::vector<std::vector<Tread>> flights(1);
  const auto add = [&](std::size_t patch, int steps) {
    std::vector<Tread>& treads = flights.back();
    if (!patches[patch].is_tread)
      flights.emplace_back();
    else
      treads.push_back(
          {treads.empty() ? 0 : treads.back().number + steps, &patches[patch]});
  };
  add(chain.front().from, 0);
  for (const StairStep& step : chain)
    add(step.to, step.steps);
  flights.erase(std::remove_if(flights.begin(), flights.end(),
                               [](const auto& treads) { return treads.size() < 2; }),
                flights.end());
  return flights;
}

RoomFloors::Floor
leadToFloor(PlanFlight& flight, const RoomFloors& floors, bool is_foot)
{
  PlanFlight longer = flight;
  for (int missing = 0; missing <= stair_priors.max_unseen; ++missing) {
    const PlanFlight::Riser next = nextRiser(longer, is_foot);
    const RoomFloors::Floor floor =
        floors.near((next[0] + next[1]) / 2, is_foot ? longer.bottom : longer.top(),
                    longer.rise / 2);
    if (floor.room != 0) {
      flight = longer;
      return floor;
    }
    auto& risers = longer.risers;
    risers.insert(is_foot ? risers.begin() : risers.end(), next);
    longer.bottom -= is_foot ? longer.rise : 0;
  }
  return {};
}

} // namespace pcl::sedr
