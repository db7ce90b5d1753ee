// SPDX-License-Identifier: BSD-3-Clause
// Which straight walls are tilted.
#include "surface_fit.h"

#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/base/quantiles.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl::sedr {

namespace {

/** @brief Sums of values for the cost of what differs from their mean. */
struct ValueSums {
  double weight = 0;
  double sum = 0;
  double squares = 0;

  void add(double value, double w)
  {
    weight += w;
    sum += w * value;
    squares += w * value * value;
  }
  double cost() const { return weight > 0 ? (squares - sum * sum / weight) / 2 : 0; }
};

} // namespace

/** @brief Fits each straight wall also with a tilt if it was given none, or without,
 * and keeps what is more probable. */
void
SurfaceFit::chooseTilts()
{
  constexpr double min_seen = 0.95; // share of the points that the vertical wall has
  constexpr double third = 0.4307;  // of the normal distribution, from its middle
  const std::vector<Unknown> first = unknowns_.all;
  const std::vector<std::vector<PatchMean>> first_patches = patches_;
  parallelBlocks(first.size(), 1, parameters_.threads, [&](std::size_t k, std::size_t) {
    Unknown& u = unknowns_.all[k];
    if (!u.may_tilt)
      return;
    u = given_[k];
    u.is_tilted = !u.is_tilted;
    u.run = 0;
    start(k);
    u.noise = std::min(u.noise, errors_.noise);
    for (int round = 0; round < rounds; ++round)
      refine(k);
  });
  const std::vector<Unknown> second = unknowns_.all;
  const std::vector<std::vector<PatchMean>> second_patches = patches_;
  const auto take = [&](std::size_t k, bool is_tilted) {
    const bool is_first = first[k].is_tilted == is_tilted;
    unknowns_.all[k] = is_first ? first[k] : second[k];
    patches_[k] = is_first ? first_patches[k] : second_patches[k];
  };
  std::vector<Weighted> runs;
  for (std::size_t k = 0; k < first.size(); ++k)
    if (first[k].may_tilt) {
      take(k, true);
      const Unknown& u = unknowns_.all[k];
      runs.emplace_back(std::abs(u.run), std::sqrt(u.count));
    }
  // Of the walls a third at least is vertical.
  const double drift = weightedQuantile(std::move(runs), 1.0 / 3) / third;
  for (std::size_t k = 0; k < first.size(); ++k)
    if (first[k].may_tilt) {
      const double seen = (first[k].is_tilted ? second : first)[k].count;
      if (unknowns_.all[k].count >= min_seen * seen && isTilted(k, drift))
        continue;
      take(k, false);
      unknowns_.all[k].run = 0;
    }
  estimateErrors();
}

/** @brief Checks whether the tilted plane of a wall is more probable than a vertical
 * one and than two above each other. */
bool
SurfaceFit::isTilted(std::size_t number, double drift) const
{
  const Unknown& u = unknowns_.all[number];
  const double angle = std::abs(std::atan(u.run));
  if (!u.isSeen() || angle < parameters_.min_tilt || angle > parameters_.max_tilt)
    return false;
  const double variance =
      u.information.inverse()(2, 2) + std::pow(parameters_.accuracy, 2) + drift * drift;
  const double gain = u.run * u.run / (2 * variance) +
                      std::log(2 * M_PI * variance) / 2 -
                      std::log(parameters_.free_tilt);
  std::vector<std::array<double, 3>> rows; // height, distance if vertical, weight
  ValueSums above;
  double tilted = 0;
  for (const PatchMean& patch : patches_[number]) {
    const double up = patch.at.z() - u.height;
    rows.push_back({up, patch.distance + u.run * up, patch.precision});
    above.add(rows.back()[1], patch.precision);
    tilted += patch.precision * patch.distance * patch.distance / 2;
  }
  std::sort(rows.begin(), rows.end());
  ValueSums below;
  double stepped = above.cost();
  double low = HUGE_VAL;
  double high = -HUGE_VAL;
  for (const auto& [up, distance, weight] : rows) {
    above.add(distance, -weight);
    below.add(distance, weight);
    stepped = std::min(stepped, above.cost() + below.cost());
    if (weight > 0) {
      low = std::min(low, up);
      high = std::max(high, up);
    }
  }
  return gain > parameters_.rare_tilt && stepped - tilted > parameters_.rare_tilt &&
         high - low + parameters_.patch > parameters_.min_tilted_height;
}

} // namespace pcl::sedr
