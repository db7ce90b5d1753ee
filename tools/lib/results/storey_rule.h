// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "display_cloud.h"

#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <cstdint>
#include <map>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief What of a result is of one storey: what has a room of it, and of the rest,
 * such as the scan, what lies at its heights, 15 cm more at both ends. */
class StoreyRule {
public:
  StoreyRule() = default;

  /** @param plan may be without rooms: then there are no storeys */
  explicit StoreyRule(const Floorplan& plan);

  /** @brief From the lowest up. */
  const std::vector<PlanStorey>& storeys() const { return storeys_; }

  /** @brief The storey of this number; null for another number, and for 0. */
  const PlanStorey* find(std::uint32_t number) const;

  /** @brief Whether something of a room (0: of none that is known), at a height, is of
   * a storey; of number 0, which stands for all, it is. */
  bool holds(std::uint32_t number, std::uint32_t room, double z) const;

private:
  std::vector<PlanStorey> storeys_;
  std::map<std::uint32_t, std::uint32_t> storey_of_room_; ///< numbers
};

} // namespace tools
} // namespace sedr
} // namespace pcl
