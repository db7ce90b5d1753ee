// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "opening_search.h"

namespace pcl::sedr {

/** @brief Stores in PlanElement::evidence which shares of every wall and side of a
 * column the maps show: seen, with points on the plan's surface; hidden, by what stands
 * before it or in its shade; open, as all of its openings. A surface that was hardly
 * seen is hidden but where rays went through. Mouths of niches, corners and the edges
 * to floor and ceiling do not count. O(cells). */
void measureEvidence(const OpeningSearch& search, Floorplan& plan);

} // namespace pcl::sedr
