// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/priors.h>
#include <pcl/sedr_filters/scan_frame.h>

#include <optional>
#include <string>

namespace pcl::sedr {

/** @brief A floor plan, and what else its file tells. */
struct PlanDocument {
  Floorplan plan;
  Origin origin{};                      ///< that the plan's coordinates are relative to
  std::optional<Levelling> levelling{}; ///< the rotation that made the scan level
  double max_wall = Priors().max_wall;  ///< maximum thickness of a wall, metres
  std::string scan{}; ///< what tells the scan from others: a hash; edits keep it
};

/** @brief Writes a floor plan as JSON: {"format": "sedr-floorplan", "version": 3,
 * "unit": "m", "origin": [x, y, z], "rooms": [...]}. All coordinates are relative to
 * the origin. A room has id, area, perimeter, floor and ceiling (plane a, b, c, d,
 * inliers, residual), boundary, columns and details. A loop is a list of elements:
 * start and end, for arcs centre, radius and counter_clockwise, inliers and residual,
 * for tilted walls tilt in degrees. `levelling` has angle and direction in degrees,
 * `rotation` by rows, and `about`; `names` those of rooms; max_wall is written unless
 * it is the default. Numbers are written so that they read back exactly. */
std::string documentToJson(const PlanDocument& document);
std::string floorplanToJson(const Floorplan& plan);

/** @brief Reads what documentToJson() wrote, now or earlier: doorways of versions 1 and
 * 2 that are none of the openings become openings of unknown kind.
 *
 * The following are refused:
 * - coordinates beyond 1e6 m;
 * - arcs with a radius beyond 1e5 m or an end more than 1 mm off their circle;
 * - open loops, and boundaries of rooms or details that are not counter-clockwise or
 *   enclose no area;
 * - floors and ceilings whose normal is tilted by more than 60 degrees or not of unit
 *   length (within 1e-3 it is normalised), walls tilted by more than 45 degrees;
 * - ceilings that are above the floor neither along walls nor along details, tilted
 *   walls that meet below the ceiling over them;
 * - room ids that are 0 or occur twice, openings of one kind and number, or numbers
 *   above 1e6;
 * - names that are not printable UTF-8 or have more than 255 characters;
 * - a max_wall out of the range of the prior.
 *
 * An arc whose ends coincide is a whole circle.
 * @param[out] problem what is wrong, as a sentence; empty if nothing is
 * @return an empty plan if there is a problem */
PlanDocument documentFromJson(const std::string& text, std::string& problem);
Floorplan floorplanFromJson(const std::string& text, std::string& problem);

} // namespace pcl::sedr
