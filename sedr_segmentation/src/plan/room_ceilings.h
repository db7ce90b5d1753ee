// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../sheets/sheet_fit.h"
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/priors.h>
#include <pcl/sedr_filters/straightening.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace pcl::sedr {

/** @brief The ceiling, or the floor, of a room that is not level. */
struct RoomSheet {
  std::uint32_t room = 0; ///< PlanRoom::id
  std::vector<Eigen::Vector3d> points;
  FacetSheet sheet{}; ///< fitted to them; without facets: not yet
  bool is_floor = false;
};

/** @brief Returns the ceiling of a room before its outline is known, a relief of its
 * facets; null if none of them slopes or they explain too little of it. */
std::shared_ptr<const PlanSlab> seenSheet(const std::vector<Eigen::Vector3d>& points,
                                          const Priors& priors,
                                          unsigned threads);

/** @brief Sets the facets of ceilings and floors. A room without slopes is not changed.
 * @param scan the raw scan, if known, for the fit of the facets
 * @param indices the points of the scan to use; empty: all
 * @param tilts of the walls of `plan`; points are where they were scanned */
void giveCeilings(std::vector<RoomSheet> sheets,
                  const PointView* scan,
                  const std::vector<int>& indices,
                  unsigned threads,
                  Floorplan& plan,
                  const WallTilts& tilts = {});

} // namespace pcl::sedr
