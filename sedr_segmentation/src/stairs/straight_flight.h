// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "level_patches.h"

#include <optional>

namespace pcl::sedr {

/** @brief A tread of a flight that was seen, fully or in part. */
struct Tread {
  int number = 0; ///< in its flight, from 0
  const LevelPatch* patch = nullptr;
};

/** @brief Equal steps: tread k reaches `going` metres along `way` from `front + k
 * going`, at the height `level + k rise`. */
struct StraightSteps {
  Eigen::Vector2d way = Eigen::Vector2d::UnitX();
  double front = 0;
  double going = 0;
  double level = 0;
  double rise = 0;
  double nats = 0;                            ///< log-odds of what they explain
  std::vector<Tread> treads{};                ///< by number
  std::vector<const LevelPatch*> explained{}; ///< treads and undersides
};

/** @brief Intercept and slope of values of treads over their numbers, least squares. */
Eigen::Vector2d lineThrough(const std::vector<Tread>& treads,
                            const std::vector<double>& values);

/** @brief Fits equal steps to the patches around treads that follow each other: those
 * that explain most. Each tread is worth what a step is, less how far its height, its
 * front and its back are off; so is each patch of the underside of these steps, at one
 * depth. Steps along the walls around cost nothing for their direction, others do.
 * O(p^3) for p patches around.
 * @param is_used of the patches: 1 for those that others explain
 * @param wall direction of the walls around, modulo a quarter turn; none: not known
 * @return none: treads that turn explain more */
std::optional<StraightSteps> straightSteps(const std::vector<Tread>& treads,
                                           const std::vector<LevelPatch>& patches,
                                           const std::vector<std::uint8_t>& is_used,
                                           const RoomFloors& floors,
                                           std::optional<double> wall);

} // namespace pcl::sedr
