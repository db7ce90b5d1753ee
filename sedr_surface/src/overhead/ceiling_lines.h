// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief A line of a ceiling in plan. */
struct CeilingLine {
  PlanElement element;
  bool is_crease = false; ///< two surfaces meet in it; otherwise it is a step
  std::string text{};     ///< "ridge 4.35" or "valley 2.90"; usually empty
};

/** @brief The lines of a ceiling, and the parts between them. */
struct CeilingLines {
  std::vector<CeilingLine> lines;
  /** Of the main ceiling, then of each detail: a number that those without a line
   * between them have in common. */
  std::vector<std::size_t> part;
};

/** @brief Returns the lines of a room's ceiling: what lies beside them, the main
 * ceiling or details, differs by a step of 3 cm or an angle of 6 degrees.
 *
 * A line is where the upper one of both details in PlanRoom::details has its edge.
 * Segments are straightened; where two planes meet, the line is that of their
 * intersection. Arcs stay arcs.
 * @param finest metres that a millimetre of paper stands for: lines are straightened by
 * that much, and those below five of them are left out */
CeilingLines ceilingLines(const PlanRoom& room, double finest);

} // namespace pcl::sedr
