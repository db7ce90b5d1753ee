// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <string>

namespace pcl::sedr {

/** @brief Distance from a border at which the ceiling beside it is asked for: loops of
 * facets meet within tolerance only; metres. */
constexpr double beside_border = 0.05;

/** @brief The line in which two facets of a ceiling meet. */
struct RoofLine {
  bool is_seen = false;   ///< there is a step or a bend; otherwise the ceiling goes on
  bool is_crease = false; ///< they meet at one height; otherwise there is a step
  bool is_ridge = false;  ///< both fall away from it: a ridge or a hip
  double height = 0;      ///< at its middle, above the room's floor, metres
  bool is_level = false;

  /** @brief Returns "ridge 4.35" or "valley 2.90"; empty for other or sloping lines. */
  std::string text() const;
};

/** @param line border of a facet, within the room */
RoofLine roofLineAt(const PlanRoom& room, const PlanElement& line);

/** @brief Returns "eaves 1.05" for a wall from which a sloping ceiling rises, if level
 * along the wall; empty for others. The height is above the floor beside the wall. */
std::string eavesText(const PlanRoom& room, const PlanElement& wall);

} // namespace pcl::sedr
