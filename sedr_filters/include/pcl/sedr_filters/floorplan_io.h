// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/scan_frame.h>

#include <string>

namespace pcl {
namespace sedr {

/** @brief A floor plan as JSON: {"format": "sedr-floorplan", "version": 1, "unit": "m",
 * "origin": [x, y, z], "rooms": [...]}: all places are counted from the origin. A room
 * has id, area, perimeter, floor and ceiling (plane a, b, c, d, inliers,
 * residual), boundary, columns and details. A loop is a list of elements: start and
 * end, for arcs centre, radius and counter_clockwise, inliers and residual. Numbers are
 * written so that they read back exactly.
 * @param levelling how the scan was made level for the plan, if it was: `levelling`
 * with angle and direction in degrees, `rotation` by rows, and `about`
 * @param origin what the places of the plan are counted from */
std::string floorplanToJson(const Floorplan& plan,
                            const Levelling* levelling = nullptr,
                            const Origin& origin = {});

/** @brief The origin that floorplanToJson() wrote, or that of report.json; 0, 0, 0
 * where there is none.
 * @return false if it is there, but no three numbers */
bool originFromJson(const std::string& text, Origin& origin);

/** @brief Reads what floorplanToJson() wrote.
 *
 * Refused are: coordinates beyond 1e6 m; arcs of a radius beyond 1e5 m or with an end
 * more than 1 mm off their circle; loops that are open; boundaries of rooms and details
 * that do not run counter-clockwise around some area; floors and ceilings whose normal
 * is not of unit length (within 1e-3: then it is brought to it) or leans by more than
 * 45 degrees; ids of rooms that are 0 or occur twice. An arc whose ends coincide is a
 * whole circle.
 * @param[out] problem what is wrong, a sentence; empty if nothing is
 * @return an empty plan if there is a problem */
Floorplan floorplanFromJson(const std::string& text, std::string& problem);

} // namespace sedr
} // namespace pcl
