// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/priors.h>
#include <pcl/sedr_filters/scan_frame.h>

#include <string>

namespace pcl::sedr {

/** @brief Writes a floor plan as JSON: {"format": "sedr-floorplan", "version": 1,
 * "unit": "m", "origin": [x, y, z], "rooms": [...]}. All coordinates are relative to
 * the origin. A room has id, area, perimeter, floor and ceiling (plane a, b, c, d,
 * inliers, residual), boundary, columns and details. A loop is a list of elements:
 * start and end, for arcs centre, radius and counter_clockwise, inliers and residual.
 * Numbers are written so that they read back exactly.
 * @param levelling the rotation that made the scan level, null if none: written as
 * `levelling` with angle and direction in degrees, `rotation` by rows, and `about`
 * @param origin the place that the plan's coordinates are relative to
 * @param max_wall maximum thickness of a wall, metres; written unless it is the
 * default */
std::string floorplanToJson(const Floorplan& plan,
                            const Levelling* levelling = nullptr,
                            const Origin& origin = {},
                            double max_wall = Priors().max_wall);

/** @brief Reads the origin from a floor plan or a report.json; (0, 0, 0) if there is
 * none.
 * @return false if there is an origin that is not three numbers */
bool originFromJson(const std::string& text, Origin& origin);

/** @brief Reads the maximum thickness of a wall from a floor plan, metres; the default
 * if there is none.
 * @param[out] problem what is wrong, as a sentence: it is no number, or not in the
 * range of the prior; empty if nothing is */
double maxWallFromJson(const std::string& text, std::string& problem);

/** @brief Reads what floorplanToJson() wrote.
 *
 * The following are refused:
 * - coordinates beyond 1e6 m;
 * - arcs with a radius beyond 1e5 m or an end more than 1 mm off their circle;
 * - open loops, and boundaries of rooms or details that are not counter-clockwise or
 *   enclose no area;
 * - floors and ceilings whose normal is tilted by more than 60 degrees or not of unit
 *   length (within 1e-3 it is normalised);
 * - room ids that are 0 or occur twice.
 *
 * An arc whose ends coincide is a whole circle.
 * @param[out] problem what is wrong, as a sentence; empty if nothing is
 * @return an empty plan if there is a problem */
Floorplan floorplanFromJson(const std::string& text, std::string& problem);

} // namespace pcl::sedr
