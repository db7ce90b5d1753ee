// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/plan_warning.h>

#include "../triangulation/constrained_triangulation.h"
#include "../triangulation/segment_arrangement.h"
#include "plan_subdivision.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief Origin of a segment of an arrangement. */
struct SegmentSource {
  static constexpr std::size_t no_loop = static_cast<std::size_t>(-1);

  std::size_t loop = 0;    ///< index of RoomLayers::loops; no_loop for a crease
  std::size_t element = 0; ///< of RoomLayers::elements; for a crease, its slab's
};

/** @brief A triangulated room plan with a region per triangle. Regions that cannot be
 * built are replaced. */
class PlanCells {
public:
  /** @param tolerance of each SolidElement, metres: parts narrower than that of the
   * elements around them are slivers */
  PlanCells(const RoomLayers& layers,
            const PlanGrid& grid,
            const Arrangement& arrangement,
            const PlanTriangulation& triangulation,
            const std::vector<SegmentSource>& sources,
            const std::vector<double>& tolerance);

  /** @brief Merges slivers into neighbouring parts. */
  void mergeSlivers();

  /** @brief Removes details and niches, then other regions, that leave no height
   * between floor and ceiling or would touch a neighbour. */
  void dropUnbuildable(std::vector<PlanWarning>& warnings);

  /** @brief Removes small pieces cut off by columns or crossing walls, and warns of
   * larger ones. */
  void checkPieces(std::vector<PlanWarning>& warnings);

  /** @brief Returns the edges between different regions. */
  std::vector<SubdivisionEdge> edges() const;

  /** @brief Returns the visible creases of curved slabs. */
  std::vector<SubdivisionCrease> creases() const;

private:
  static constexpr std::uint32_t none = PlanTriangulation::none;

  /** @brief Connected triangles of one region. */
  struct Part {
    PlanRegion region;
    std::vector<std::uint32_t> triangles;
    double area = 0;                     ///< square metres
    double perimeter = 0;                ///< metres
    double tolerance = 0;                ///< maximum of the elements around it, metres
    bool is_outside = false;             ///< adjacent to the hull, in no room
    std::map<PlanRegion, double> beside; ///< shared length with other regions
  };

  void classify();

  /** @brief Returns sets of triangles connected by sides with `alike(t, u)`. */
  template <typename Alike>
  std::vector<Part> partsOf(Alike alike) const;

  std::vector<Part> regions() const;

  /** @brief Returns the connected pieces of the room, regardless of regions. */
  std::vector<Part> roomPieces() const;

  void measure(Part& part, std::uint32_t t, std::size_t side) const;

  /** @brief Returns the region that absorbs a sliver: the room region with the longest
   * common edge; `nothing` if there is none. */
  static PlanRegion heirOf(const Part& part);

  static double widthOf(const Part& part);

  void assign(const Part& part, const PlanRegion& region);

  double heightOf(int slab, std::uint32_t vertex) const;

  /** @brief Returns the minimum distance of ceiling and floor: a millimetre, more only
   * on a coarse grid. */
  double minClearance() const { return 20 * solidSeparation(grid_); }

  /** @brief Returns the minimum height of a part's ceiling above its floor, metres. */
  double clearance(const Part& part) const;

  /** @brief Returns whether a part's floor meets a neighbour's ceiling along an edge,
   * or vice versa. */
  bool touchesBeside(const Part& part) const;

  /** @brief Returns whether a part is open to a neighbouring part of the room. */
  bool isOpen(const Part& part) const;

  /** @brief Returns why a part cannot be built, or empty. */
  std::string problemOf(const Part& part) const;

  PlanRegion across(std::uint32_t t, std::size_t side) const;

  /** @brief Returns the edge on a triangle's side, or null. */
  const Arrangement::Edge* edgeAt(std::uint32_t t, std::size_t side) const;

  std::uint32_t corner(std::uint32_t t, std::size_t i) const
  {
    return triangulation_.triangles[t][i % 3];
  }

  double areaOf(std::uint32_t t) const;

  const RoomLayers& layers_;
  const PlanGrid& grid_;
  const Arrangement& arrangement_;
  const PlanTriangulation& triangulation_;
  const std::vector<SegmentSource>& sources_;
  const std::vector<double>& tolerance_;
  std::vector<PlanRegion> region_; ///< per triangle
};

} // namespace pcl::sedr
