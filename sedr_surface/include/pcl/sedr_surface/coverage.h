// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_segmentation/building.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief A part of a building that was seen and is not in the plan. */
struct CoverageGap {
  std::string reason; ///< for people: "room 3: no plan could be fitted"
  double area = 0;    ///< square metres
  double floor = 0;   ///< metres
  double ceiling = 0; ///< metres
  Eigen::Vector2d at = Eigen::Vector2d::Zero(); ///< a place in it
  /** Whether it is floor to stand on inside the building. Not so are places without
   * headroom, and what lies outdoors or was seen through an opening. */
  bool counts = true;
};

/** @brief How much of the floor that a scan shows is in the plan. Like is compared with
 * like: floor to stand on inside the building. Voids within slabs and below furniture
 * are no part of it. */
struct Coverage {
  double seen = 0; ///< square metres: what was modelled, and what was left out inside
  double modelled = 0; ///< square metres: the rooms of the plan
  double not_counted = 0; ///< square metres: of what was left out and does not count
  std::vector<CoverageGap> left_out; ///< what counts first, then largest first

  /** @brief 0 to 1; 1 where nothing was seen. */
  double share() const { return seen > 0 ? modelled / seen : 1; }

  /** @brief The largest thing left out that counts; null where there is none. */
  const CoverageGap* largest() const;
};

/** @brief Compares a plan with the building it was made from: its rooms have the ids of
 * the building's.
 *
 * Left out are rooms without a plan, the parts of rooms that their plan does not hold,
 * and what is no room (Building::left_out). A place without walls around it that is
 * larger than every room of the plan counts as inside: what one sees through an opening
 * is a glimpse. O(columns times elements of their room's loop). */
Coverage coverageOf(const Building& building, const Floorplan& plan);

/** @brief What a user should know of a coverage below nine tenths, a sentence that
 * names the largest thing left out with its area, place and reason; empty above. */
std::string coverageWarning(const Coverage& coverage);

} // namespace sedr
} // namespace pcl
