// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_facets.h"
#include "room_layers.h"
#include "slab_creases.h"

#include <cstddef>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief The creases of the curved slabs of a room, cut off where another slab is in
 * their place. */
class VisibleCreases {
public:
  /** @param chains the loops of the layers in facets; both must outlive this */
  VisibleCreases(const RoomLayers& layers, const std::vector<FacetChain>& chains);

  /** @brief Those of one slab, facets within `tolerance` metres of it.
   *
   * O(k n), k creases and n corners of the loops whose boxes they meet. */
  std::vector<Crease> of(std::size_t slab, double tolerance) const;

private:
  /** @brief Where the loops cross a line, as shares of its length, sorted, 0 and 1
   * with them. */
  std::vector<double> crossings(const Crease& crease) const;

  /** @brief The layers over a place. */
  PlanRegion regionAt(const Eigen::Vector2d& p) const;

  const RoomLayers& layers_;
  const std::vector<FacetChain>& chains_;
  std::vector<Eigen::AlignedBox2d> boxes_; ///< of the chains
};

} // namespace sedr
} // namespace pcl
