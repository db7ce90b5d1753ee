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

/** @brief A tread that was seen. */
struct Tread {
  double number = 0; ///< in its flight, from 0
  const LevelPatch* patch = nullptr;
  Eigen::Vector2d way; ///< of the step to it, of the first: from it
};

/** @brief Three quarters of the values are no larger. */
double
upperQuartile(std::vector<double> values)
{
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(3 * values.size() / 4);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/** @brief Least squares: the value at 0 and the slope of values of treads, those that
 * were seen from above weigh more than the edges of risers. */
std::array<double, 2>
lineThrough(const std::vector<Tread>& treads, const std::vector<double>& values)
{
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  for (std::size_t k = 0; k < treads.size(); ++k) {
    const LevelPatch& patch = *treads[k].patch;
    const auto weight = static_cast<double>(patch.cells.size() - patch.edge_cells + 1);
    const Eigen::Vector2d row(1, treads[k].number);
    normal += weight * row * row.transpose();
    right += weight * values[k] * row;
  }
  const Eigen::Vector2d line = normal.inverse() * right;
  return {line[0], line[1]};
}

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

/** @brief The flight of treads that follow each other. Risers are where the fronts of
 * the treads lie: of a straight flight in the mean, at equal distances. */
PlanFlight
flightOf(std::vector<Tread> treads, double cell)
{
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  std::array<std::vector<double>, 3> middles;
  for (const Tread& tread : treads) {
    scatter += tread.patch->scatter;
    middles[0].push_back(tread.patch->middle.x());
    middles[1].push_back(tread.patch->middle.y());
    middles[2].push_back(tread.patch->z);
  }
  const Eigen::Vector2d step(lineThrough(treads, middles[0])[1],
                             lineThrough(treads, middles[1])[1]);
  // The direction that parts treads best, Fisher's discriminant: those seen in part
  // need not lie behind each other.
  const Eigen::Vector2d mean = (scatter.inverse() * step).normalized();
  const auto angleTo = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  };
  const bool is_straight =
      std::all_of(treads.begin(), treads.end(), [&](const Tread& tread) {
        return tread.patch->depth(mean) < mean.dot(step) + stair_priors.turned;
      });
  // Treads that turn do so from riser to riser; the first one has no riser before it.
  double turn = 0;
  for (std::size_t k = 2; k < treads.size() && !is_straight; ++k)
    turn += angleTo(treads[k - 1].way, treads[k].way);
  turn /= std::max(1.0, treads.back().number -
                            treads[std::min<std::size_t>(1, treads.size() - 1)].number);
  treads.front().way = Eigen::Rotation2Dd(-turn) * treads.front().way;
  std::vector<double> fronts;
  std::vector<double> left;
  std::vector<double> right;
  for (Tread& tread : treads) {
    if (is_straight)
      tread.way = mean;
    const Eigen::Vector2d across = leftOf(tread.way);
    fronts.push_back(tread.patch->front(tread.way));
    const double origin = is_straight ? 0 : across.dot(tread.patch->middle);
    double most = -std::numeric_limits<double>::infinity();
    double least = -most;
    for (const Eigen::Vector2d& c : tread.patch->cells) {
      most = std::max(most, across.dot(c) - origin);
      least = std::min(least, across.dot(c) - origin);
    }
    left.push_back(most + cell / 2);
    right.push_back(cell / 2 - least);
  }
  PlanFlight flight;
  const auto [z, rise] = lineThrough(treads, middles[2]);
  flight.bottom = z - rise;
  flight.rise = rise;
  const auto [first, going] = lineThrough(treads, fronts);
  const auto add = [&](const Eigen::Vector2d& at, const Eigen::Vector2d& way) {
    flight.risers.push_back({at + upperQuartile(left) * leftOf(way),
                             at - upperQuartile(right) * leftOf(way)});
  };
  const auto last = static_cast<std::size_t>(treads.back().number) + 1;
  if (is_straight) {
    for (std::size_t k = 0; k <= last; ++k)
      add((first + static_cast<double>(k) * going) * mean, mean);
    return flight;
  }
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
    const double steps = k == 0 ? 1 : treads[k].number - treads[k - 1].number;
    for (int n = 1; n < steps; ++n) { // those between that nobody saw
      const PlanFlight::Riser before = riserOf(k - 1);
      flight.risers.push_back({before[0] + n / steps * (riser[0] - before[0]),
                               before[1] + n / steps * (riser[1] - before[1])});
    }
    flight.risers.push_back(riser);
  }
  flight.risers.push_back(nextRiser(flight, false));
  return flight;
}

} // namespace

std::vector<PlanFlight>
flightsOf(const std::vector<StairStep>& chain,
          const std::vector<LevelPatch>& patches,
          double cell)
{
  std::vector<PlanFlight> flights;
  std::vector<Tread> treads;
  const auto close = [&] {
    if (treads.size() > 1)
      flights.push_back(flightOf(std::move(treads), cell));
    treads.clear();
  };
  if (patches[chain.front().from].is_tread)
    treads.push_back({0, &patches[chain.front().from], chain.front().way});
  for (const StairStep& step : chain) {
    const LevelPatch& to = patches[step.to];
    if (!to.is_tread)
      close();
    else if (treads.empty())
      treads.push_back({0, &to, step.way});
    else {
      if (treads.size() == 1)
        treads.front().way = step.way;
      treads.push_back({treads.back().number + step.steps, &to, step.way});
    }
  }
  close();
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
                    (missing == 0 ? 1 : 0.6) * stair_priors.same_floor);
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

void
fitBetween(double bottom, double top, PlanFlight& flight)
{
  const auto steps =
      static_cast<std::size_t>(std::max(2L, std::lround((top - bottom) / flight.rise)));
  const Eigen::Vector2d first = flight.risers.front()[0] - flight.risers.front()[1];
  const Eigen::Vector2d last = flight.risers.back()[0] - flight.risers.back()[1];
  const bool is_straight = last.isApprox(first, 1e-6);
  if (is_straight && steps != flight.steps()) {
    const std::vector<PlanFlight::Riser> old = flight.risers;
    flight.risers.resize(steps);
    for (std::size_t k = 0; k < steps; ++k)
      for (std::size_t side = 0; side < 2; ++side)
        flight.risers[k][side] =
            old.front()[side] + static_cast<double>(k) /
                                    static_cast<double>(steps - 1) *
                                    (old.back()[side] - old.front()[side]);
  }
  flight.bottom = bottom;
  flight.rise = (top - bottom) / static_cast<double>(flight.steps());
}

} // namespace pcl::sedr
