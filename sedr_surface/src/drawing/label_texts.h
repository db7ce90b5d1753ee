// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../overhead/ceiling_faces.h"
#include "opening_gaps.h"

#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief Returns a level with its sign: "+2.80", "±0.00". */
std::string levelText(double level);

/** @brief Returns "Room 3", or its number and its name. */
std::string titleOf(const PlanRoom& room);

/** @brief Returns the text lines of a room: its title, then of a plan of the floor its
 * area, the height if its ceiling lies above its floor, and the level of the floor; of
 * its ceiling the area, and the heights if it is not level.
 * @param zero height of level 0 */
std::vector<std::string>
roomTexts(const CeilingFaces& ceiling, DrawingView view, double zero);

/** @brief Returns the size of a column: "Ø 0.40", "0.30 x 0.50"; empty for other
 * shapes. */
std::string columnText(const PlanLoop& column);

/** @brief Returns number and size of an opening: "W2 1.20 x 1.40 sill 0.90". */
std::string textOf(const OpeningGap& opening);

} // namespace pcl::sedr
