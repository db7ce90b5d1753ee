// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <cstddef>

namespace pcl::sedr {

/** @brief How much of walls was measured, as shares of their surface without the doors,
 * windows and passages of the plan; the shares add up to 1.
 *
 * A wall of 2.5 m height of which a scan shows the lower half, a cupboard hides a
 * quarter, and nobody saw a quarter: measured 0.5, inferred 0.25, unseen 0.25. */
struct WallShares {
  double area = 0;     ///< square metres; 0: nothing is known of these walls
  double measured = 1; ///< points lie on it
  double inferred = 0; ///< behind something: the wall goes on there
  double unseen = 0;   ///< nothing was seen there, neither a wall nor what hides it

  /** @brief Checks whether so little was measured that the wall is a guess: less than a
   * fifth. */
  bool isGuess() const { return area > 0 && measured < 0.2; }

  WallShares& operator+=(const WallShares& other);
};

/** @brief Returns the shares of a wall: an element of a room's boundary. */
WallShares wallShares(const Floorplan& plan, const PlanRoom& room, std::size_t element);

/** @brief Returns the shares of all walls of a room. */
WallShares wallShares(const Floorplan& plan, const PlanRoom& room);

/** @brief Returns the shares of all walls of a plan. O(elements times openings). */
WallShares wallShares(const Floorplan& plan);

} // namespace pcl::sedr
