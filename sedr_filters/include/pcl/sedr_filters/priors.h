// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/pcl_exports.h>

#include <cmath>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief What is believed of buildings, of furniture, of scanners and of samples
 * before a scan is looked at: the only place for such numbers.
 *
 * Lengths are in metres, areas in square metres, shares from 0 to 1; priorTable() tells
 * the units of the others.
 * priorTable() and doc/priors.md tell the range and the source of each and where it
 * acts. What depends on one of these is written as a function of it where it is used.
 *
 * @code
 * pcl::sedr::Priors priors;
 * priors.max_wall = 0.9; // a castle
 * reconstruction.setPriors(priors);
 * @endcode */
struct Priors {
  // Heights and sizes of rooms and buildings.
  double min_headroom = 1.8;          ///< height of a room or doorway, at least
  double usual_room_height = 4.5;     ///< higher ones are halls
  double max_room_height = 100;       ///< what is higher is no room
  double max_building_height = 200;   ///< a higher scan is not in metres
  double max_building_extent = 20000; ///< likewise, in plan
  double min_home_height = 2.1336;    ///< of the rooms of homes and offices, seven feet
  double max_home_height = 3.6576;    ///< likewise, twelve feet
  double max_home_area = 27.87091;    ///< of half of those rooms, 300 square feet
  double max_door_height = 2.5908;    ///< of doors of rooms, eight and a half feet
  double max_unseen_area = 4;         ///< of a room's ceiling hidden in one place
  double small_area = 0.1; ///< of a plan, which may be cut off without a word

  // Walls and what is in them.
  double min_wall = 0.04;        ///< thickness of a partition: a plate of glass
  double max_wall = 0.6;         ///< thickness of a wall, with its niches
  double min_wall_length = 0.5;  ///< that shows a direction or a board on it
  double short_wall = 1;         ///< too short to have an exact direction of its own
  double max_pilaster = 0.4;     ///< depth of a pilaster, width of the narrowest recess
  double low_wall = 0.4;         ///< height of the lowest parapet
  double door_width = 0.9;       ///< of a usual door
  double min_niche_depth = 0.09; ///< of those built 0.1 deep, as they are measured
  double max_niche_depth = 1;    ///< deeper ones are parts of the room
  double max_door_recess = 0.2;  ///< of a closed door in its wall
  double max_door_width = 1.6;   ///< of a door or a window with a head
  double min_column_area = 0.03; ///< of a column: 17 cm by 17 cm
  double min_column_radius = 0.05; ///< of a round one, or of a pipe
  double assumed_partition = 0.01; ///< of which nothing is known

  // Ceilings and floors.
  double max_slab_tilt = 3;         ///< of a plane that is called level
  double min_ceiling_step = 0.03;   ///< less is unevenness
  double max_platform_height = 0.6; ///< above a room's floor, and of steps below it
  double max_step_height = 0.35;    ///< higher ones are those onto a bench or a bed
  double min_platform_area = 1.2;   ///< of a platform
  double min_platform_width = 0.7;  ///< of its narrowest part that counts
  double min_tread = 0.2;           ///< of a step up to another platform
  double max_soffit_reach = 5;      ///< beyond the main ceiling
  double min_floor_step = 0.06;     ///< less is a rug on a floor, a panel on a ceiling
  double min_slab_area = 1;     ///< of a part of a floor or a shallow step of a ceiling
  double min_recess = 0.3;      ///< width of a recess of a ceiling; less is ribs
  double min_drop = 0.1;        ///< of a soffit above furniture
  double max_head_depth = 0.55; ///< of a head of a door or window taken for a soffit

  // Furniture.
  double min_furniture_depth = 0.1; ///< of what may hide a wall
  double max_furniture_depth = 0.9; ///< likewise, a wardrobe before a wall
  double max_furniture_length = 5;  ///< along a wall
  double max_corner_depth = 1.2;    ///< of a corner that a wardrobe across it hides
  double max_furniture_area = 4.5;  ///< a larger platform is part of the building
  double max_shaft_area = 1;        ///< of furniture that closes around seen ceiling
  double min_board_depth = 0.02;    ///< of a board on a wall
  double board_clearance = 0.4;     ///< from a ceiling down to the highest board
  double lamp_clearance = 0.15;     ///< from walls to the nearest lamp

  // Scanners: noise and unevenness.
  double min_slit = 0.045;        ///< above furniture below a ceiling, and its noise
  double chance = 1e-4;           ///< at which strays explain what was seen
  double unevenness = 0.001;      ///< no wall is known better
  double slab_noise = 0.015;      ///< of a thinned ceiling or floor; a step is higher
  double wall_noise = 0.012;      ///< of parts of a straight wall
  double surface_band = 0.1;      ///< a surface with all its noise
  double wall_band = 0.05;        ///< points of a wall are no farther off
  double place_accuracy = 0.0003; ///< of a curve, however many points there are
  double min_tilt = 0.3;          ///< of a scan that is not level
  double sigmas = 3;              ///< of what noise explains
  double correlated_sigmas = 4;   ///< likewise, of points that are not independent

  // Sampling: cells and gaps in which evidence is counted.
  double run_gap = 0.15;         ///< no surface has a larger one, thrice a usual voxel
  double evidence_cell = 0.1;    ///< of wall, of length and height
  double patch = 0.5;            ///< of a surface that is fitted for its direction
  double riser_cells = 3;        ///< of a plan's grid, over which noise spreads a riser
  double cell_fill = 0.97;       ///< of the cells of a ceiling, in a scan dense enough
  double max_enlargement = 2.5;  ///< of cells in a sparse scan
  double min_scan_points = 1000; ///< of a room
  double coarse_cell = 0.2;      ///< in which what furniture hides is bridged
  double min_evidence = 3;       ///< points that show a wall
  double min_points = 10;        ///< that a curve is fitted to
  double blur = 4;               ///< samples of a contour that a corner is blurred over

  // How much of a thing that was seen says what.
  double share_unseen = 0.05; ///< less is nothing
  double share_few = 0.15;    ///< of what is seen through an opening
  double share_little = 0.2;  ///< less may be strays
  double share_some = 0.3;    ///< of what stands before or around something
  double share_part = 0.4;    ///< of what one side of a thing shows
  double share_half = 0.5;    ///< of a wall that is there
  double share_clear = 0.6;   ///< of a wall that stands for sure
  double share_closed = 0.7;  ///< of the back of a niche
  double share_most = 0.8;    ///< of what is there for sure
  double upright_ratio = 1.5; ///< of areas that say which axis is up
  double corridor_ratio = 4;  ///< of a corridor's walls to its floor
  double clearly = 1.2;       ///< times better, so that the simpler one gives way

  // Directions: small angles, in radians or as sines.
  double same_axis = 0.026;      ///< of a scan, or square to it: 1.5 degrees
  double same_direction = 0.03;  ///< of one wall: 1.7 degrees
  double smooth_joint = 0.25;    ///< of curves that run alike: 14.5 degrees
  double other_direction = 0.35; ///< of a wall of its own: 20 degrees

  // Costs of a loop, in metres of wall that is not explained.
  double element_cost = 0.06; ///< of a segment; twice that in no common direction
  double change_cost = 6;     ///< of a change of curve, in squared half tolerances
  double far_cost = 10;       ///< of a sample that is far away, the same a metre
  double max_detour = 2.5;    ///< length of what is led along other lines
};

/** @brief What is known of one number of Priors. */
struct Prior {
  const char* name;
  double Priors::*member;
  const char* group;
  const char* unit;
  double low; ///< values below are refused
  double high;
  const char* source;
  const char* where; ///< it acts: folders of the sources
};

/** @brief All numbers of Priors in the order of the structure. */
PCL_EXPORTS const std::vector<Prior>& priorTable();

/** @brief Sets a number by its name.
 * @return why not, a sentence; empty if it is set */
PCL_EXPORTS std::string setPrior(const std::string& name, double value, Priors& priors);

/** @brief What is wrong with the numbers, a sentence with the first that is out of its
 * range; empty if none is. */
PCL_EXPORTS std::string problemOf(const Priors& priors);

/** @brief Radians of an angle in degrees. */
constexpr double
radians(double degrees)
{
  return degrees * (M_PI / 180);
}

} // namespace sedr
} // namespace pcl
