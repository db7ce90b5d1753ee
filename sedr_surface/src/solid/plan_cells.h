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

/** @brief A room's plan, divided along segments and triangulated. */
struct TriangulatedPlan {
  const RoomLayers& layers;
  PlanGrid grid;
  std::vector<double> tolerance; ///< of each SolidElement, metres: parts narrower
                                 ///< than that of the elements around are slivers
  std::vector<SegmentSource> sources{}; ///< of each segment
  std::vector<PlanSquare> squares{};    ///< each gets the region that most of it has
  Arrangement arrangement{};            ///< of the segments
  PlanTriangulation triangulation{};    ///< its edges are sides of triangles
};

/** @brief The region of each triangle of a plan, which must outlive it. */
class ClassifiedCells {
public:
  /** @brief Finds the regions by the loops around each triangle. */
  explicit ClassifiedCells(const TriangulatedPlan& plan);

protected:
  static constexpr std::uint32_t none = PlanTriangulation::none;

  /** @brief Returns the region beyond a side of a triangle. */
  PlanRegion across(std::uint32_t t, std::size_t side) const;

  /** @brief Returns the edge on a triangle's side, or null. */
  const Arrangement::Edge* edgeAt(std::uint32_t t, std::size_t side) const;

  std::uint32_t corner(std::uint32_t t, std::size_t i) const
  {
    return plan_.triangulation.triangles[t][i % 3];
  }

  double areaOf(std::uint32_t t) const;

  double heightOf(int slab, std::uint32_t vertex) const;

  /** @brief Returns the minimum distance of ceiling and floor: a millimetre, more only
   * on a coarse grid. */
  double minClearance() const { return 20 * solidSeparation(plan_.grid); }

  const TriangulatedPlan& plan_;
  std::vector<PlanRegion> region_; ///< per triangle

private:
  void classify();
};

/** @brief Divides a triangulated plan into regions, and replaces those that cannot be
 * built, see subdivideRoom().
 * @param[out] subdivision gets vertices, edges and creases
 * @param[out] warnings of larger pieces and of details that are removed */
void findRegions(const TriangulatedPlan& plan,
                 PlanSubdivision& subdivision,
                 std::vector<PlanWarning>& warnings);

} // namespace pcl::sedr
