// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <string>

namespace pcl {
namespace sedr {

/** @brief What two facets of a ceiling make where they meet. */
struct RoofLine {
  bool is_crease = false; ///< they meet; else one is higher than the other
  bool is_ridge = false;  ///< both fall away from it: a ridge or a hip
  double height = 0;      ///< over the room's floor at its middle, metres
  bool is_level = false;

  /** @brief "ridge 4.35", "valley 2.90"; nothing where it is neither or not level. */
  std::string text() const;
};

/** @param line within the room, a border of one of its facets */
RoofLine roofLineAt(const PlanRoom& room, const PlanElement& line);

/** @brief "eaves 1.05" at a wall where a sloping ceiling begins, level along the wall;
 * nothing at others. The height is over the floor beside the wall. */
std::string eavesText(const PlanRoom& room, const PlanElement& wall);

} // namespace sedr
} // namespace pcl
