// SPDX-License-Identifier: BSD-3-Clause
#include "stair_chains.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

namespace {

/** @brief Nats that a change of rise, going and direction costs. */
double
change(const StairStep& a, const StairStep& b)
{
  double squares = std::pow((b.rise - a.rise) / stair_priors.rise_sigma, 2);
  if (a.is_on_treads && b.is_on_treads) {
    const double turn =
        std::atan2(a.way.x() * b.way.y() - a.way.y() * b.way.x(), a.way.dot(b.way));
    squares += std::pow((b.going - a.going) / stair_priors.going_sigma, 2) +
               std::pow(turn / stair_priors.turn_sigma, 2) / std::max(a.steps, b.steps);
  }
  return squares / 2;
}

} // namespace

StairChains::StairChains(const std::vector<LevelPatch>& patches,
                         const RoomFloors& floors)
    : patches_(patches)
    , floors_(floors)
    , is_used_(patches.size(), 0)
{
  for (std::size_t a = 0; a < patches.size(); ++a)
    for (std::size_t b = a + 1;
         b < patches.size() &&
         patches[b].z - patches[a].z <=
             (stair_priors.max_missing + 1) * stair_priors.max_rise;
         ++b)
      for (int steps = 1; steps <= stair_priors.max_missing + 1; ++steps)
        addSteps(a, b, steps);
  // Patches are by height: of the steps up to a place all before it are known.
  std::stable_sort(steps_.begin(), steps_.end(),
                   [](const StairStep& a, const StairStep& b) { return a.to < b.to; });
}

std::vector<StairStep>
StairChains::next()
{
  std::vector<std::vector<std::size_t>> arriving(patches_.size());
  double most = 0;
  std::ptrdiff_t last = -1;
  for (std::size_t k = 0; k < steps_.size(); ++k) {
    StairStep& step = steps_[k];
    if (is_used_[step.from] != 0 || is_used_[step.to] != 0)
      continue;
    const double own = stair_priors.step_gain - stair_priors.missing * (step.steps - 1);
    step.odds = own - stair_priors.chain_cost + floorGain(step, true);
    step.before = -1;
    for (const std::size_t o : arriving[step.from])
      if (const double odds = own + steps_[o].odds - change(steps_[o], step);
          odds > step.odds) {
        step.odds = odds;
        step.before = static_cast<std::ptrdiff_t>(o);
      }
    arriving[step.to].push_back(k);
    if (const double odds = step.odds + floorGain(step, false); odds > most) {
      most = odds;
      last = static_cast<std::ptrdiff_t>(k);
    }
  }
  std::vector<StairStep> chain;
  for (; last >= 0; last = steps_[static_cast<std::size_t>(last)].before)
    chain.push_back(steps_[static_cast<std::size_t>(last)]);
  if (!chain.empty())
    chain.front().odds = most;
  std::reverse(chain.begin(), chain.end());
  return chain;
}

void
StairChains::use(const LevelPatch& tread)
{
  for (std::size_t p = 0; p < patches_.size(); ++p)
    if (const LevelPatch& patch = patches_[p];
        &patch == &tread ||
        (patch.is_tread && std::abs(patch.z - tread.z) < stair_priors.near &&
         (patch.middle - tread.middle).norm() < stair_priors.near))
      is_used_[p] = 1;
}

void
StairChains::addSteps(std::size_t a, std::size_t b, int steps)
{
  const LevelPatch& from = patches_[a];
  const LevelPatch& to = patches_[b];
  StairStep step{a, b, steps, (to.z - from.z) / steps};
  if (step.rise < stair_priors.min_rise || step.rise > stair_priors.max_rise ||
      from.box.exteriorDistance(to.box) > steps * stair_priors.max_going ||
      (steps > 1 && !(from.is_tread && to.is_tread)) ||
      floors_.part(from.middle, from.z, to.middle, to.z, steps))
    return;
  step.is_on_treads = from.is_tread && to.is_tread;
  step.way = (to.middle - from.middle).normalized();
  step.going = (to.middle - from.middle).norm() / steps;
  if (!step.is_on_treads ||
      (step.going >= stair_priors.min_going && step.going <= stair_priors.max_going))
    steps_.push_back(step);
}

double
StairChains::floorGain(const StairStep& step, bool is_foot) const
{
  const LevelPatch& patch = patches_[is_foot ? step.from : step.to];
  const double sign = is_foot ? -1 : 1;
  for (const int away : {1, 2})
    if (!patch.is_tread ||
        floors_.near(patch.middle + sign * away * stair_priors.max_going * step.way,
                     patch.z + sign * away * step.rise)
                .room != 0)
      return stair_priors.floor_gain;
  return 0;
}

} // namespace pcl::sedr
