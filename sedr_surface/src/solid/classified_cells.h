// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_cells.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief A triangulated room plan with the region of each triangle. What it is made of
 * must outlive it. */
class ClassifiedCells {
public:
  /** @brief Finds the regions by the loops around each triangle. */
  ClassifiedCells(const RoomLayers& layers,
                  const PlanGrid& grid,
                  const Arrangement& arrangement,
                  const PlanTriangulation& triangulation,
                  const std::vector<SegmentSource>& sources);

protected:
  static constexpr std::uint32_t none = PlanTriangulation::none;

  /** @brief Returns the region beyond a side of a triangle. */
  PlanRegion across(std::uint32_t t, std::size_t side) const;

  /** @brief Returns the edge on a triangle's side, or null. */
  const Arrangement::Edge* edgeAt(std::uint32_t t, std::size_t side) const;

  std::uint32_t corner(std::uint32_t t, std::size_t i) const
  {
    return triangulation_.triangles[t][i % 3];
  }

  double areaOf(std::uint32_t t) const;

  double heightOf(int slab, std::uint32_t vertex) const;

  /** @brief Returns the minimum distance of ceiling and floor: a millimetre, more only
   * on a coarse grid. */
  double minClearance() const { return 20 * solidSeparation(grid_); }

  const RoomLayers& layers_;
  const PlanGrid& grid_;
  const Arrangement& arrangement_;
  const PlanTriangulation& triangulation_;
  const std::vector<SegmentSource>& sources_;
  std::vector<PlanRegion> region_; ///< per triangle

private:
  void classify();
};

} // namespace pcl::sedr
