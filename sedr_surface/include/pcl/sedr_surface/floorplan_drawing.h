// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/origin.h>

#include <string>

namespace pcl {
namespace sedr {

/** @brief A floor plan as a drawing to scale, an SVG in millimetres of paper.
 *
 * Arcs are arcs. Walls are thick, columns filled, edges of the ceiling's details
 * dashed, steps of the floor and niches thin. Rooms have their number, area and height,
 * walls their length and arcs their radius where there is space, details their height
 * over the floor, steps theirs with a sign; about all are the overall size and a scale
 * bar. Doorways are gaps in the walls, in a group of the class `doorways`. A group a
 * room, with the id room_1.
 *
 * @param plan as fitted; without rooms the page is empty
 * @param scale metres in the world for one of paper: 50 for 1:50. 0: the largest usual
 * scale at which the plan fits an A4 page
 * @param storey one of storeysOf(), and only that is drawn, with its name; the page
 * and all coordinates are those of the whole plan, so that the sheets of a building lie
 * over each other. Null: all rooms
 * @param origin what places are counted from: told below the plan unless it is 0 */
std::string floorplanToSvg(const Floorplan& plan,
                           double scale = 0,
                           const PlanStorey* storey = nullptr,
                           const Origin& origin = {});

/** @brief The scale that floorplanToSvg() takes by itself. */
double drawingScale(const Floorplan& plan);

/** @brief A floor plan as DXF of AutoCAD's release 12, one unit a metre: LINE, ARC and
 * CIRCLE on the layers WALL, COLUMN, DETAIL (of the ceiling), FLOOR_DETAIL and NICHE,
 * as they are in the plan to a tenth of a micrometre; the outline of each room as one
 * closed polyline with bulges on ROOM; numbers, areas and heights of rooms on TEXT,
 * lengths of walls as dimensions, and radii, on DIMENSION, gaps of doorways on DOORWAY.
 * Units are set to metres.
 * @param storey, origin as for floorplanToSvg() */
std::string floorplanToDxf(const Floorplan& plan,
                           const PlanStorey* storey = nullptr,
                           const Origin& origin = {});

} // namespace sedr
} // namespace pcl
