// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::sedr {

/** @brief How two parts of a ceiling meet at a place. */
struct Meeting {
  bool is_seen = false;
  bool is_step = false;   ///< they are at one height nowhere within 0.1 m
  bool is_crease = false; ///< they meet in a ridge or a valley
  bool is_ridge = false;  ///< both fall away
};

/** @param left,right heights of both at the place, and `beside` metres from it
 * @param roughness of both, metres */
Meeting meetingOf(const Eigen::Vector2d& left,
                  const Eigen::Vector2d& right,
                  double beside,
                  double roughness);

/** @brief What a line in plan asks of the places on it. */
struct Limit {
  Eigen::Vector2d normal;          ///< of the line
  const PlanSlab* left = nullptr;  ///< null: a place stays on the line
  const PlanSlab* right = nullptr; ///< otherwise both are at one height there
};

/** @brief Returns the place nearest to a given one that is within all limits, those of
 * heights by least squares; the given one if that is not within 0.2 m. */
Eigen::Vector2d placeOfMeeting(const std::vector<Limit>& limits,
                               const Eigen::Vector2d& start);

} // namespace pcl::sedr
