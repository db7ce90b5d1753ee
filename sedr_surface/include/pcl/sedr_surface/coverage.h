// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/plan_warning.h>
#include <pcl/sedr_segmentation/building.h>

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief A part of the building that the scan shows but the plan does not contain. */
struct CoverageGap {
  std::string reason; ///< reason for users, e.g. "room 3: no plan could be fitted"
  double area = 0;    ///< area, square metres
  double floor = 0;   ///< height of the floor, metres
  double ceiling = 0; ///< height of the ceiling, metres
  Eigen::Vector2d at = Eigen::Vector2d::Zero(); ///< a point inside the part
  /** Whether the part is usable floor inside the building. False for places without
   * headroom, outdoors, or seen only through glass. */
  bool counts = true;
};

/** @brief How much of the scanned floor the plan contains. Both areas count only usable
 * floor inside the building, without voids within slabs and below furniture. */
struct Coverage {
  double seen = 0;     ///< square metres: modelled, plus left out inside the building
  double modelled = 0; ///< square metres: the rooms of the plan
  double not_counted = 0;            ///< square metres left out that do not count
  std::vector<CoverageGap> left_out; ///< counting parts first, then by area

  /** @brief Returns the modelled share, 0 to 1; 1 if nothing was seen. */
  double share() const { return seen > 0 ? modelled / seen : 1; }

  /** @brief Returns the largest part left out that counts; null if there is none. */
  const CoverageGap* largest() const;
};

/** @brief Compares a plan with the building it was made from. Rooms of both have the
 * same ids.
 *
 * Reported as left out: rooms without a plan, parts of rooms outside their plan, and
 * Building::left_out. A room of which an opening shows a part counts as inside, and so
 * does a place without walls that is larger than every room of the plan. Others count
 * as glimpses through an opening. O(columns times elements of their room's loop). */
Coverage coverageOf(const Building& building, const Floorplan& plan);

/** @brief Returns a warning if the coverage is below nine tenths. It names the largest
 * part left out, with area, place and reason. */
std::optional<PlanWarning> coverageWarning(const Coverage& coverage);

} // namespace pcl::sedr
