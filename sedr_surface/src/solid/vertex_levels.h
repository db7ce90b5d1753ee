// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_subdivision.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace pcl::sedr {

/** @brief Heights of the floors and ceilings that meet at a vertex of a subdivision,
 * grid units. Heights that cross there or differ by less than solidSeparation() are
 * merged. */
class VertexLevels {
public:
  /** @param spokes of the vertex */
  VertexLevels(const RoomLayers& layers,
               const PlanSubdivision& subdivision,
               std::uint32_t vertex,
               const std::vector<Spoke>& spokes);

  /** @brief Returns the level of a slab at the vertex; `otherwise` if no region there
   * has the slab. */
  std::int64_t levelOf(int slab, std::int64_t otherwise = 0) const;

  /** @brief Returns the distinct levels of slabs that end here, increasing. */
  const std::vector<std::int64_t>& levels() const { return levels_; }

private:
  /** @brief Merges the levels of two slabs and all between them. */
  void join(int slab, int other);

  std::vector<std::pair<int, std::int64_t>> of_slab_;
  std::vector<std::int64_t> levels_;
};

/** @brief Returns the levels at every vertex. */
std::vector<VertexLevels> levelsOf(const RoomLayers& layers,
                                   const PlanSubdivision& subdivision);

/** @brief Returns the vertices at which the solid touches itself along a vertical line:
 * its surface is not manifold there. */
std::vector<GridPoint> touchingVertices(const RoomLayers& layers,
                                        const PlanSubdivision& subdivision);

} // namespace pcl::sedr
