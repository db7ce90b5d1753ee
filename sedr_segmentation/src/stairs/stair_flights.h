// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../air/voxel_columns.h"
#include "level_patches.h"

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_segmentation/building.h>

#include <optional>
#include <vector>

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
                                           std::optional<double> wall);

/** @brief Returns the flight of equal steps, as wide as their patches. */
PlanFlight flightOf(const StraightSteps& steps);

/** @brief Returns the flight of three treads or more that turn: risers half way between
 * their middles, as wide as they are. */
PlanFlight turningFlight(const std::vector<Tread>& treads);

/** @brief Leads a flight on, as it runs and turns, to the floor at its foot or its
 * head, over treads that nobody saw.
 * @return the floor; none: the flight stays as it is */
RoomFloors::Floor
leadToFloor(PlanFlight& flight, const RoomFloors& floors, bool is_foot);

/** @brief Finds the flights of a building: chains of level patches of the scan with air
 * above, each a step higher than the one before and next to it, from a floor or landing
 * up. Of all chains the one of the greatest log-odds against patches of furniture is
 * taken, by dynamic programming from below, then the best of what is left. Flights are
 * added to the stairs that lead to where they lead, and others as stairs of their own.
 * O(columns + points) and O(p^2) for p patches that are no floor.
 * @param fine columns of the points, of at most 0.1 m; else nothing is found
 * @param[in,out] building its rooms and storeys, and links between them as stairs */
void addFlights(const PointView& points,
                const std::vector<int>& indices,
                const VoxelColumns& fine,
                Building& building);

} // namespace pcl::sedr
