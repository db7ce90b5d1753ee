// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/pcl_exports.h>
#include <pcl/sedr_filters/impl/stage_thresholds.h>

#include <cmath>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief Prior assumptions about buildings, furniture and scanners, made before a scan
 * is read: those of all stages from the planes of a scan to the plan of its rooms.
 * Parting of rooms, sheets, walls of the IFC and rays have their own parameters.
 *
 * Lengths are in metres, areas in square metres. priorTable() and
 * doc/priors.md list unit, range, source and use of each. Values that depend on a prior
 * are computed from it where they are used.
 *
 * @code
 * pcl::sedr::Priors priors;
 * priors.max_wall = 0.9; // a castle
 * reconstruction.setPriors(priors);
 * @endcode */
struct Priors : StageThresholds {
  // Heights and sizes of rooms and buildings.
  double min_headroom = 1.8;          ///< minimum height of a room or doorway
  double max_building_height = 200;   ///< scans above it are not in metres
  double max_building_extent = 20000; ///< likewise for the extent in plan
  double min_home_height = 2.1336;    ///< of rooms in homes and offices, seven feet
  double max_home_height = 3.6576;    ///< likewise, twelve feet
  double max_home_area = 50.16764;    ///< median area of those rooms, 540 square feet
  double max_door_height = 2.5908;    ///< of interior doors, eight and a half feet

  // Walls and what is in them.
  double min_wall = 0.04;       ///< minimum thickness of a partition: a pane of glass
  double max_wall = 0.75;        ///< maximum thickness of a wall, with its niches
  double max_niche_depth = 1;   ///< deeper recesses are parts of the room
  double max_door_width = 1.6;  ///< maximum width of a door or window with a head
  double assumed_partition = 0.01; ///< thickness of a partition that was not measured

  // Ceilings and floors.
  double max_slab_tilt = 3;         ///< maximum tilt of a level plane
  double min_ceiling_step = 0.03;   ///< smaller steps are unevenness
  double max_platform_height = 0.6; ///< above a room's floor; also of steps below it
  double max_step_height = 0.35;    ///< higher steps lead onto a bench or a bed
  double min_platform_area = 1.2;   ///< minimum area of a platform
  double max_soffit_reach = 5;   ///< maximum distance of a soffit from the main ceiling
  double min_floor_step = 0.045; ///< smaller steps are a rug or a ceiling panel
  double min_slab_area = 1; ///< minimum area of a floor part or a shallow ceiling step

  // Furniture.
  double max_furniture_depth = 0.9; ///< its maximum depth, a wardrobe before a wall
  double max_furniture_area = 4.5;  ///< larger platforms are part of the building

  // Scanners: noise and unevenness.
  double unevenness = 0.001; ///< the position of no wall is known better
  double slab_noise = 0.015; ///< noise of a thinned ceiling or floor; steps are higher
  double min_tilt = 0.3;     ///< minimum tilt of a scan that is not level, degrees
};

/** @brief Name, range and source of one member of Priors. */
struct Prior {
  const char* name;
  double Priors::*member;
  const char* group;
  const char* unit;
  double low; ///< smaller values are refused
  double high;
  const char* source;
};

/** @brief Returns the descriptions of all members of Priors, in order. */
PCL_EXPORTS const std::vector<Prior>& priorTable();

/** @brief Sets a member by name.
 * @return why it was refused, as a sentence; empty if it was set */
PCL_EXPORTS std::string setPrior(const std::string& name, double value, Priors& priors);

/** @brief Returns a sentence about the first member out of range, else empty. */
PCL_EXPORTS std::string problemOf(const Priors& priors);

/** @brief Converts degrees to radians. */
constexpr double
radians(double degrees)
{
  return degrees * (M_PI / 180);
}

} // namespace pcl::sedr
