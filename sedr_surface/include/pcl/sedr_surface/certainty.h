// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/plan_warning.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief Distances from the truth for which a Certainty has probabilities, metres. */
constexpr std::array<double, 3> certainty_steps{0.01, 0.03, 0.05};

/** @brief How sure it is that a wall is where the building has one, or that an opening
 * is there, of its kind, with its edges where they are. */
struct Certainty {
  std::string element;         ///< "7.8": wall 8 of room 7; "D3", see markOf()
  std::uint32_t room = 0;      ///< of an opening one of its rooms
  std::size_t index = 0;       ///< of the wall in the room, of the opening in the plan
  double area = 0;             ///< of the wall with its openings, of the opening; m2
  std::vector<double> signs{}; ///< what tells it, see wallSigns(), openingSigns()
  std::array<double, 3> within{}; ///< probabilities, see certainty_steps

  /** @brief Returns the probability that it is right: within 5 cm. */
  double right() const { return within.back(); }
};

/** @brief Returns what the signs of walls and openings are: "log_length". */
std::vector<std::string> wallSigns();
std::vector<std::string> openingSigns();

/** @brief Returns the certainty of all walls of which something is known, in the order
 * of the plan. Probabilities are logistic functions of the signs, fitted on buildings
 * whose truth is known: see doc/reliability.md. O(walls times openings). */
std::vector<Certainty> certaintyOfWalls(const Floorplan& plan,
                                        const std::vector<PlanWarning>& warnings);

/** @brief Likewise of openings; nothing is known of those whose edges were not measured
 * or were set by hand. */
std::vector<Certainty> certaintyOfOpenings(const Floorplan& plan);

} // namespace pcl::sedr
