// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "display_cloud.h"

#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <cstdint>
#include <map>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Decides what belongs to a storey: parts with a room by that room, others,
 * such as the scan, by height with 15 cm more at both ends. */
class StoreyRule {
public:
  StoreyRule() = default;

  /** @param plan may have no rooms and thus no storeys */
  explicit StoreyRule(const Floorplan& plan);

  /** @brief Returns the storeys, from the lowest up. */
  const std::vector<PlanStorey>& storeys() const { return storeys_; }

  /** @brief Returns the storey with a number; null for unknown numbers and for 0. */
  const PlanStorey* find(std::uint32_t number) const;

  /** @brief Returns whether a part of a room (0: unknown) at a height belongs to a
   * storey; always true for number 0, all storeys. */
  bool holds(std::uint32_t number, std::uint32_t room, double z) const;

private:
  std::vector<PlanStorey> storeys_;
  std::map<std::uint32_t, std::uint32_t> storey_of_room_; ///< storey numbers
};

} // namespace pcl::sedr::tools
