// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/plan_warning.h>

#include "../triangulation/constrained_triangulation.h"
#include "../triangulation/segment_arrangement.h"
#include "plan_subdivision.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief Origin of a segment of an arrangement. */
struct SegmentSource {
  static constexpr std::size_t no_loop = static_cast<std::size_t>(-1);

  std::size_t loop = 0;    ///< index of RoomLayers::loops; no_loop for others
  std::size_t element = 0; ///< of RoomLayers::elements; for a crease, its slab's
};

/** @brief A square in plan, grid units, whose sides are segments of the arrangement. */
struct PlanSquare {
  GridPoint middle;
  std::int32_t half = 0; ///< of a side
};

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

/** @brief Divides a triangulated room plan into regions, and replaces those that cannot
 * be built: slivers go to neighbours; details and niches, then other regions, that
 * leave no height between floor and ceiling or would touch a neighbour are removed, and
 * so are small pieces cut off by columns or crossing walls.
 * @param squares each gets the region that most of it has
 * @param tolerance of each SolidElement, metres: parts narrower than that of the
 * elements around them are slivers
 * @param[in,out] subdivision its grid is known; gets vertices, edges and creases
 * @param[out] warnings of larger pieces and of details that are removed */
void findRegions(const RoomLayers& layers,
                 const Arrangement& arrangement,
                 const PlanTriangulation& triangulation,
                 const std::vector<SegmentSource>& sources,
                 const std::vector<double>& tolerance,
                 const std::vector<PlanSquare>& squares,
                 PlanSubdivision& subdivision,
                 std::vector<PlanWarning>& warnings);

} // namespace pcl::sedr
