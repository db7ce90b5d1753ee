// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/priors.h>
#include <pcl/sedr_segmentation/building.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl::sedr {

constexpr double foot = 0.3048; ///< metres
constexpr const char* if_in_feet =
    "if the foot is the unit of the scan, scale it by 0.3048 (--unit 0.3048 in "
    "pcl_sedr), else --unit 1 says that it is the metre";

/** @brief Returns a sentence if the unit of a scan seems to be the inch, else an empty
 * one. The scan must be 60 to 200 high, like one or two storeys in inches, and more
 * than 30 per storey found, unlike any tower. The outermost tenth of the points at each
 * end is ignored. Above 200, the check of the scan detects the unit. O(points).
 * @param storeys number of storeys found */
std::string inchProblem(const PointView& points, std::size_t storeys);

/** @brief Returns how unlikely a clear height is, nats: of a usual one 0; some are far
 * above it, but one hits one's head (see footProblem).
 * @param height metres */
double costOfHeight(double height, const Priors& priors);

/** @brief Evidence that the unit of a plan is the foot. */
struct UnitDoubt {
  double nats = 0;    ///< log-likelihood of the foot less that of the metre
  std::string reason; ///< a sentence; empty if there is no doubt
};

/** @brief Returns whether the unit of a plan may be the foot:
 * if its heights and areas of rooms, doors, walls and heights at which a scanner stood
 * are by 2 nats more likely in feet. Of each kind the logarithm lies about the middle
 * of the range that the priors give, which is two deviations wide; some are far above
 * it, but below deviations are half as wide: one hits one's head. O(rooms times
 * places).
 * @param links of the rooms, as high as their doors
 * @param places where the scanner stood, in the frame of the plan; may be empty */
UnitDoubt footProblem(const Floorplan& plan,
                      const std::vector<RoomLink>& links = {},
                      const std::vector<Eigen::Vector3f>& places = {},
                      const Priors& priors = {});

} // namespace pcl::sedr
