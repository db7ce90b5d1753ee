// SPDX-License-Identifier: BSD-3-Clause
#include "stair_flights.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl::sedr {

namespace {

Eigen::Vector2d
leftOf(const Eigen::Vector2d& way)
{
  return {-way.y(), way.x()};
}

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
turningFlight(std::vector<Tread> treads, double cell)
{
  const auto angleTo = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  };
  double turn = 0; // the first tread has no riser before it
  for (std::size_t k = 2; k < treads.size(); ++k)
    turn += angleTo(treads[k - 1].way, treads[k].way);
  turn /= std::max(1, treads.back().number - treads[1].number);
  treads.front().way = Eigen::Rotation2Dd(-turn) * treads.front().way;
  std::vector<double> fronts;
  std::vector<double> heights;
  for (const Tread& tread : treads) {
    fronts.push_back(tread.patch->extent(tread.way)[0]);
    heights.push_back(tread.patch->z);
  }
  PlanFlight flight;
  const Eigen::Vector2d line = lineThrough(treads, heights);
  flight.bottom = line[0] - line[1];
  flight.rise = line[1];
  // Each riser is as wide as the treads beside it are there.
  constexpr double beside = 0.12; // metres
  const auto riserOf = [&](std::size_t k) -> PlanFlight::Riser {
    const Eigen::Vector2d& way = treads[k].way;
    const Eigen::Vector2d& middle = treads[k].patch->middle;
    const Eigen::Vector2d at = middle + (fronts[k] - way.dot(middle)) * way;
    double most = 0;
    double least = 0;
    for (std::size_t tread = k == 0 ? 0 : k - 1; tread <= k; ++tread)
      for (const Eigen::Vector2d& c : treads[tread].patch->cells)
        if (std::abs(way.dot(c - at)) < beside) {
          most = std::max(most, leftOf(way).dot(c - at) + cell / 2);
          least = std::min(least, leftOf(way).dot(c - at) - cell / 2);
        }
    return {at + most * leftOf(way), at + least * leftOf(way)};
  };
  for (std::size_t k = 0; k < treads.size(); ++k) {
    const PlanFlight::Riser riser = riserOf(k);
    const int steps = k == 0 ? 1 : treads[k].number - treads[k - 1].number;
    for (int n = 1; n < steps; ++n) { // those between that nobody saw
      const PlanFlight::Riser before = riserOf(k - 1);
      flight.risers.push_back({before[0] + (riser[0] - before[0]) * n / steps,
                               before[1] + (riser[1] - before[1]) * n / steps});
    }
    flight.risers.push_back(riser);
  }
  flight.risers.push_back(nextRiser(flight, false));
  return flight;
}

std::vector<std::vector<Tread>>
treadsOf(const std::vector<StairStep>& chain, const std::vector<LevelPatch>& patches)
{
  std::vector<std::vector<Tread>> flights(1);
  if (patches[chain.front().from].is_tread)
    flights.back().push_back({0, &patches[chain.front().from], chain.front().way});
  for (const StairStep& step : chain) {
    std::vector<Tread>& treads = flights.back();
    const LevelPatch& to = patches[step.to];
    if (!to.is_tread)
      flights.emplace_back();
    else if (treads.empty())
      treads.push_back({0, &to, step.way});
    else {
      if (treads.size() == 1)
        treads.front().way = step.way;
      treads.push_back({treads.back().number + step.steps, &to, step.way});
    }
  }
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
