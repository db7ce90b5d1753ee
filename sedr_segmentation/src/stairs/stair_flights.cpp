// SPDX-License-Identifier: BSD-3-Clause
#include "stair_flights.h"

#include "sedr_filters/src/plan/plan_geometry.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief The cells of a patch along a direction and across it. */
Eigen::AlignedBox2d
boxAlong(const Eigen::Vector2d& way, const LevelPatch& patch)
{
  const auto [front, back] = patch.extent(way);
  const auto [right, left] = patch.extent({-way.y(), way.x()});
  return {Eigen::Vector2d(front, right), Eigen::Vector2d(back, left)};
}

/** @brief Looks for equal steps along a direction. */
class StraightSearch {
public:
  StraightSearch(const std::vector<Tread>& treads,
                 const std::vector<LevelPatch>& patches,
                 const std::vector<std::uint8_t>& is_used,
                 const Eigen::Vector2d& way)
      : way_(way)
  {
    const Eigen::Vector2d reach(stair_priors.max_unseen * stair_priors.max_going,
                                stair_priors.near);
    Eigen::AlignedBox2d around;
    for (const Tread& tread : treads)
      around.extend(boxAlong(way, *tread.patch));
    around = {around.min() - reach, around.max() + reach};
    for (std::size_t p = 0; p < patches.size(); ++p)
      if (const Strip strip{&patches[p], boxAlong(way, patches[p])};
          is_used[p] == 0 && patches[p].is_tread && around.intersects(strip.box))
        strips_.push_back(strip);
  }

  /** @brief The steps that explain most, from each two patches a few steps apart. */
  StraightSteps best() const
  {
    StraightSteps most;
    for (const Strip& a : strips_)
      for (const Strip& b : strips_)
        for (int n = 1; n <= stair_priors.max_missing + 1; ++n) {
          StraightSteps steps =
              explain({way_, a.box.min().x(), (b.box.min() - a.box.min()).x() / n,
                       a.patch->z, (b.patch->z - a.patch->z) / n});
          if (steps.nats > most.nats)
            most = std::move(steps);
        }
    return most;
  }

private:
  struct Strip {
    const LevelPatch* patch = nullptr;
    Eigen::AlignedBox2d box;
  };

  /** @brief Sets what steps explain, and its nats; nothing if one cannot climb them. */
  StraightSteps explain(StraightSteps steps) const
  {
    if (steps.rise < stair_priors.min_rise || steps.rise > stair_priors.max_rise ||
        steps.going < stair_priors.min_going || steps.going > stair_priors.max_going)
      return steps;
    const auto nats = [&](const Strip& strip, int number, double z) {
      const double front = strip.box.min().x() - steps.front - number * steps.going;
      const double back = std::max(0.0, strip.box.max().x() - strip.box.min().x() +
                                            front - steps.going);
      return stair_priors.step_gain - (std::pow(z / stair_priors.level_sigma, 2) +
                                       std::pow(front / stair_priors.edge_sigma, 2) +
                                       std::pow(back / stair_priors.edge_sigma, 2)) /
                                          2;
    };
    std::map<int, double> best;       // of the patches of a tread one counts
    std::map<int, double> undersides; // by their depth below the treads
    for (const Strip& strip : strips_) {
      const double z = strip.patch->z - steps.level;
      const auto number = static_cast<int>(std::lround(z / steps.rise));
      if (const double gain = nats(strip, number, z - number * steps.rise); gain > 0) {
        double& so_far = best[number];
        so_far = std::max(so_far, gain);
        steps.explained.push_back(strip.patch);
        steps.treads.push_back({number, strip.patch});
        continue;
      }
      const auto above = static_cast<int>(
          std::lround((strip.box.min().x() - steps.front) / steps.going));
      const double depth = above * steps.rise - z;
      if (const double gain = nats(strip, above, 0);
          gain > 0 && depth > steps.rise / 2 && depth < stair_priors.near) {
        steps.explained.push_back(strip.patch);
        undersides[static_cast<int>(depth / (4 * stair_priors.level_sigma))] += gain;
      }
    }
    if (best.size() < 2)
      return steps;
    for (const auto& tread : best)
      steps.nats += tread.second;
    double most = stair_priors.step_gain; // for how thick the flight is
    for (const auto& underside : undersides)
      most = std::max(most, underside.second);
    steps.nats += most - stair_priors.step_gain;
    std::stable_sort(
        steps.treads.begin(), steps.treads.end(),
        [](const Tread& a, const Tread& b) { return a.number < b.number; });
    return steps;
  }

  Eigen::Vector2d way_;
  std::vector<Strip> strips_;
};

} // namespace

std::optional<StraightSteps>
straightSteps(const std::vector<Tread>& treads,
              const std::vector<LevelPatch>& patches,
              const std::vector<std::uint8_t>& is_used,
              std::optional<double> wall)
{
  const auto alongAngle = [&](double angle) {
    return StraightSearch(treads, patches, is_used,
                          Eigen::Vector2d(std::cos(angle), std::sin(angle)))
        .best();
  };
  const Eigen::Vector2d climb =
      treads.back().patch->middle - treads.front().patch->middle;
  const double middle = std::atan2(climb.y(), climb.x());
  // Treads that were seen in part need not lie behind each other. Where several
  // directions explain as much, their mean is nearest.
  double weights = 0;
  double angles = 0;
  for (int k = -20; k <= 20; ++k) {
    const double angle = middle + 1.5 * k * M_PI / 180;
    const double weight = std::exp(alongAngle(angle).nats);
    weights += weight;
    angles += weight * angle;
  }
  StraightSteps best = alongAngle(angles / weights);
  best.nats -= stair_priors.oblique;
  for (int k = 0; wall && k < 4; ++k)
    if (const double angle = *wall + k * M_PI / 2; std::cos(angle - middle) > 0.5)
      if (StraightSteps steps = alongAngle(angle); steps.nats > best.nats)
        best = std::move(steps);
  // Treads that turn have a direction each: those that the steps leave out.
  const auto n = static_cast<double>(treads.size());
  const auto left_out = static_cast<double>(
      std::count_if(treads.begin(), treads.end(), [&](const Tread& tread) {
        return std::find(best.explained.begin(), best.explained.end(), tread.patch) ==
               best.explained.end();
      }));
  if (left_out * (stair_priors.step_gain - std::log(n) / 2) > stair_priors.oblique)
    return std::nullopt;
  return best;
}

namespace {

/** @brief Intercept and slope of values of treads over their numbers, least squares. */
Eigen::Vector2d
lineThrough(const std::vector<Tread>& treads, const std::vector<double>& values)
{
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  for (std::size_t k = 0; k < treads.size(); ++k) {
    const Eigen::Vector2d row(1, treads[k].number);
    normal += row * row.transpose();
    right += values[k] * row;
  }
  return normal.inverse() * right;
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
