// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/pcl_exports.h>

#include <cmath>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief Prior assumptions about buildings, furniture, scanners and sampling, made
 * before a scan is read: those of all stages from the planes of a scan to the plan of
 * its rooms. Parting of rooms, sheets, walls of the IFC and rays have their own
 * parameters.
 *
 * Lengths are in metres, areas in square metres, shares from 0 to 1. priorTable() and
 * doc/priors.md list unit, range, source and use of each. Values that depend on a prior
 * are computed from it where they are used.
 *
 * @code
 * pcl::sedr::Priors priors;
 * priors.max_wall = 0.9; // a castle
 * reconstruction.setPriors(priors);
 * @endcode */
struct Priors {
  // Heights and sizes of rooms and buildings.
  double min_headroom = 1.8;          ///< minimum height of a room or doorway
  double usual_room_height = 4.5;     ///< rooms above it are halls
  double max_room_height = 100;       ///< higher spaces are not rooms
  double max_building_height = 200;   ///< scans above it are not in metres
  double max_building_extent = 20000; ///< likewise for the extent in plan
  double min_home_height = 2.1336;    ///< of rooms in homes and offices, seven feet
  double max_home_height = 3.6576;    ///< likewise, twelve feet
  double max_home_area = 50.16764;    ///< median area of those rooms, 540 square feet
  double max_door_height = 2.5908;    ///< of interior doors, eight and a half feet
  double max_unseen_area = 4;         ///< maximum area of a ceiling hidden in one place
  double small_area = 0.1; ///< plan area that may be dropped without a message

  // Walls and what is in them.
  double min_wall = 0.04;       ///< minimum thickness of a partition: a pane of glass
  double max_wall = 0.6;        ///< maximum thickness of a wall, with its niches
  double min_wall_length = 0.5; ///< minimum length to show a direction or a board on it
  double short_wall = 1;        ///< shorter walls have no exact direction of their own
  double max_pilaster = 0.4;    ///< depth of a pilaster, width of the narrowest recess
  double low_wall = 0.4;        ///< height of the lowest parapet
  double door_width = 0.9;      ///< width of a usual door
  double min_niche_depth = 0.09;   ///< measured depth of niches built 0.1 deep
  double max_niche_depth = 1;      ///< deeper recesses are parts of the room
  double max_door_recess = 0.2;    ///< maximum depth of a closed door in its wall
  double max_door_width = 1.6;     ///< maximum width of a door or window with a head
  double min_column_area = 0.03;   ///< minimum area of a column: 17 cm by 17 cm
  double min_column_radius = 0.05; ///< minimum radius of a round column or a pipe
  double assumed_partition = 0.01; ///< thickness of a partition that was not measured

  // Ceilings and floors.
  double max_slab_tilt = 3;         ///< maximum tilt of a level plane
  double min_ceiling_step = 0.03;   ///< smaller steps are unevenness
  double max_platform_height = 0.6; ///< above a room's floor; also of steps below it
  double max_step_height = 0.35;    ///< higher steps lead onto a bench or a bed
  double min_platform_area = 1.2;   ///< minimum area of a platform
  double min_platform_width = 0.7;  ///< minimum width of the parts of a platform
  double min_tread = 0.2;           ///< minimum depth of a step up to another platform
  double max_soffit_reach = 5;  ///< maximum distance of a soffit from the main ceiling
  double min_floor_step = 0.06; ///< smaller steps are a rug or a ceiling panel
  double min_slab_area = 1; ///< minimum area of a floor part or a shallow ceiling step
  double min_recess = 0.3;  ///< minimum width of a ceiling recess; narrower: ribs
  double min_drop = 0.1;    ///< minimum drop of a soffit above furniture
  double max_head_depth = 0.55; ///< of a door or window head taken for a soffit

  // Furniture.
  double min_furniture_depth = 0.1; ///< minimum depth of furniture that may hide a wall
  double max_furniture_depth = 0.9; ///< its maximum depth, a wardrobe before a wall
  double max_furniture_length = 5;  ///< maximum length of furniture along a wall
  double max_corner_depth = 1.2;   ///< depth of a corner hidden by a wardrobe across it
  double max_furniture_area = 4.5; ///< larger platforms are part of the building
  double max_shaft_area = 1; ///< maximum area of furniture that encloses seen ceiling
  double min_board_depth = 0.02; ///< minimum depth of a board on a wall
  double board_clearance = 0.4;  ///< from a ceiling down to the highest board
  double lamp_clearance = 0.15;  ///< from walls to the nearest lamp

  // Scanners: noise and unevenness.
  double min_slit = 0.045;   ///< minimum gap between furniture and ceiling, with noise
  double chance = 1e-4;      ///< probability at which strays explain an observation
  double unevenness = 0.001; ///< the position of no wall is known better
  double slab_noise = 0.015; ///< noise of a thinned ceiling or floor; steps are higher
  double wall_noise = 0.012; ///< noise of the parts of a straight wall
  double surface_band = 0.1; ///< width of the band of a surface with its noise
  double wall_band = 0.05;   ///< points of a wall are within this distance
  double place_accuracy = 0.0003; ///< of a curve, for any number of points
  double min_tilt = 0.3;          ///< minimum tilt of a scan that is not level, degrees
  double sigmas = 3; ///< deviation that noise explains, in standard deviations
  double correlated_sigmas = 4; ///< likewise for points that are not independent

  // Sampling: cells and gaps in which evidence is counted.
  double run_gap = 0.15;      ///< maximum gap in a surface, three usual voxels
  double evidence_cell = 0.1; ///< edge of a wall cell, in length and height
  double patch = 0.5;         ///< edge of a surface patch whose direction is fitted
  double riser_cells = 3;     ///< grid cells over which noise spreads a riser
  double cell_fill = 0.97;    ///< share of ceiling cells filled in a dense enough scan
  double max_enlargement = 2.5;  ///< maximum factor of the cell size in a sparse scan
  double min_scan_points = 1000; ///< minimum number of points of a room
  double coarse_cell = 0.2;      ///< cell size that bridges parts hidden by furniture
  double min_evidence = 3;       ///< minimum number of points that show a wall
  double min_points = 10;        ///< minimum number of points to fit a curve
  double blur = 4;               ///< samples of a loop over which a corner is blurred

  // Thresholds of the share of an object that was seen.
  double share_unseen = 0.05;  ///< smaller shares count as nothing
  double share_few = 0.15;     ///< seen through an opening
  double share_little = 0.2;   ///< smaller shares may be strays
  double share_some = 0.3;     ///< of an object before or around another, of a jamb
  double share_part = 0.4;     ///< shown by one side of an object
  double share_half = 0.5;     ///< seen of an existing wall
  double share_clear = 0.6;    ///< seen of a wall that certainly exists
  double share_closed = 0.7;   ///< seen of the back of a niche
  double share_most = 0.8;     ///< seen of what certainly exists
  double vertical_ratio = 1.5; ///< ratio of areas that decides which axis is up
  double corridor_ratio = 4;   ///< ratio of a corridor's wall area to its floor area
  double clearly = 1.2; ///< factor by which a complex model must beat a simple one

  // Directions: small angles, in radians or as sines.
  double same_axis = 0.026;      ///< parallel or square to the scan's axes: 1.5 degrees
  double same_direction = 0.03;  ///< directions within one wall: 1.7 degrees
  double smooth_joint = 0.25;    ///< curves that join smoothly: 14.5 degrees
  double other_direction = 0.35; ///< a separate wall: 20 degrees

  // Costs of a loop, in metres of wall that is not explained.
  double element_cost = 0.06; ///< of a segment; twice that without a common direction
  double change_cost = 6;     ///< of a change of curve, in squared half tolerances
  double far_cost = 10;       ///< of a distant sample, in the same unit per metre
  double max_detour = 2.5;    ///< maximum length of a detour along other lines
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
  const char* where; ///< folders of the sources that use it
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
