// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../sheets/sheet_fit.h"
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_view.h>

#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief The ceiling, or the floor, of a room that is more than a plane. */
struct RoomSheet {
  std::uint32_t room = 0; ///< PlanRoom::id
  std::vector<Eigen::Vector3d> points;
  FacetSheet sheet{}; ///< fitted to them
  bool is_floor = false;
};

/** @brief Sets the facets of ceilings and floors.
 * @param scan the points that the facets are fitted to, the raw ones if known
 * @param indices those to use; empty: all */
void giveCeilings(std::vector<RoomSheet> sheets,
                  const PointView& scan,
                  const std::vector<int>& indices,
                  unsigned threads,
                  Floorplan& plan);

} // namespace pcl::sedr
