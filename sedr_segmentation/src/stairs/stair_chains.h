// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "level_patches.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief A step from one patch up to another, also over treads that nobody saw. */
struct StairStep {
  std::size_t from = 0;
  std::size_t to = 0;
  int steps = 1;
  double rise = 0;                                ///< of each, metres
  Eigen::Vector2d way = Eigen::Vector2d::UnitX(); ///< its direction in plan
  double going = 0;                               ///< of each, metres
  bool is_on_treads = false;                      ///< both ends are treads
  double odds = 0;            ///< of the best chain up to here, nats
  std::ptrdiff_t before = -1; ///< the step before it there
};

/** @brief Chains of patches, each a step above the one before. O(p^2) for p patches. */
class StairChains {
public:
  StairChains(const std::vector<LevelPatch>& patches, const RoomFloors& floors);

  /** @brief Returns the best chain of patches that no other has, by dynamic
   * programming from below, its odds with its last step; empty if none is more likely
   * than not. */
  std::vector<StairStep> next();

  /** @brief Takes a tread, and what may be its underside, out of further chains. */
  void use(const LevelPatch& tread);

  /** @brief Returns 1 for each patch that was taken out. */
  const std::vector<std::uint8_t>& used() const { return is_used_; }

private:
  void addSteps(std::size_t a, std::size_t b, int steps);
  double floorGain(const StairStep& step, bool is_foot) const;

  const std::vector<LevelPatch>& patches_;
  const RoomFloors& floors_;
  std::vector<std::uint8_t> is_used_;
  std::vector<StairStep> steps_; ///< by where they lead to
};

} // namespace pcl::sedr
