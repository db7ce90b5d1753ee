// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_subdivision.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Heights at which the floors and ceilings about a vertex of a subdivision meet
 * it, in grid units: those that are nearer than solidSeparation(), or cross there, are
 * one. */
class VertexLevels {
public:
  VertexLevels() = default;

  /** @param spokes of the vertex */
  VertexLevels(const RoomLayers& layers,
               const PlanSubdivision& subdivision,
               std::uint32_t vertex,
               const std::vector<Spoke>& spokes);

  /** @brief Whether one of the regions about the vertex has the slab. */
  bool has(int slab) const;

  /** @brief Level of a slab that one of the regions about the vertex has. */
  std::int64_t levelOf(int slab) const;

  /** @brief The levels of slabs that end here, from low to high, each once. */
  const std::vector<std::int64_t>& levels() const { return levels_; }

private:
  /** @brief Gives two slabs, and what is between them, one level. */
  void join(int slab, int other);

  std::vector<std::pair<int, std::int64_t>> of_slab_;
  std::vector<std::int64_t> levels_;
};

/** @brief Heights between which the solid stands above a sector of a vertex. */
struct SolidSpan {
  std::int64_t low = 0;
  std::int64_t high = 0; ///< equal to low outside of the room
};

/** @brief Whether the solid above sectors around a vertical line, counter-clockwise,
 * touches itself there: whether its surface is no manifold at the line. */
bool touchesItself(const std::vector<SolidSpan>& sectors);

} // namespace sedr
} // namespace pcl
