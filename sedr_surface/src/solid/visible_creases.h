// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_facets.h"
#include "room_layers.h"
#include "slab_creases.h"

#include <cstddef>
#include <vector>

namespace pcl::sedr {

/** @brief The creases of a room's curved slabs, clipped where another slab replaces
 * them. */
class VisibleCreases {
public:
  /** @param chains facets of the layers' loops; both must outlive this object */
  VisibleCreases(const RoomLayers& layers, const std::vector<FacetChain>& chains);

  /** @brief Returns the creases of one slab, for facets within `tolerance` metres.
   *
   * O(k n) for k creases and n corners of the loops whose boxes they meet. */
  std::vector<Crease> of(std::size_t slab, double tolerance) const;

private:
  /** @brief Returns where the loops cross a line, as shares of its length, sorted, with
   * 0 and 1. */
  std::vector<double> crossings(const Crease& crease) const;

  /** @brief Returns the region at a place. */
  PlanRegion regionAt(const Eigen::Vector2d& p) const;

  const RoomLayers& layers_;
  const std::vector<FacetChain>& chains_;
  std::vector<Eigen::AlignedBox2d> boxes_; ///< of the chains
};

} // namespace pcl::sedr
