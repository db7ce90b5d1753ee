// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../triangulation/constrained_triangulation.h"
#include "../triangulation/segment_arrangement.h"
#include "plan_subdivision.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Where the segments of an arrangement come from. */
struct SegmentSource {
  static constexpr std::size_t no_loop = static_cast<std::size_t>(-1);

  std::size_t loop = 0;    ///< index of RoomLayers::loops; no_loop: of a crease
  std::size_t element = 0; ///< of RoomLayers::elements; of a crease that of its slab
};

/** @brief A room's plan in triangles, each with its region: how what the loops say is
 * told, and mended where it cannot be built. */
class PlanCells {
public:
  /** @param tolerance of each SolidElement, metres: parts narrower than those of the
   * elements around them are none */
  PlanCells(const RoomLayers& layers,
            const PlanGrid& grid,
            const Arrangement& arrangement,
            const PlanTriangulation& triangulation,
            const std::vector<SegmentSource>& sources,
            const std::vector<double>& tolerance);

  /** @brief Gives parts that are too narrow to what is beside them. */
  void mergeSlivers();

  /** @brief Takes out details and niches, and then what else, that leave no height
   * between floor and ceiling, or that could not be told from what is beside them. */
  void dropUnbuildable(std::vector<std::string>& warnings);

  /** @brief Takes out crumbs that columns or crossing walls cut off, and tells of
   * larger pieces. */
  void checkPieces(std::vector<std::string>& warnings);

  /** @brief The edges between different regions. */
  std::vector<SubdivisionEdge> edges() const;

  /** @brief The creases of curved slabs, where these are. */
  std::vector<SubdivisionCrease> creases() const;

private:
  static constexpr std::uint32_t none = PlanTriangulation::none;

  /** @brief Triangles of one region that hang together. */
  struct Part {
    PlanRegion region;
    std::vector<std::uint32_t> triangles;
    double area = 0;         ///< square metres
    double perimeter = 0;    ///< metres
    double tolerance = 0;    ///< the largest of the elements around it, metres
    bool is_outside = false; ///< beside the hull, in no room
    std::map<PlanRegion, double> beside; ///< length of edge to other regions
  };

  void classify();

  /** @brief Parts of triangles for which `alike(t, u)` holds across their sides. */
  template <typename Alike>
  std::vector<Part> partsOf(Alike alike) const;

  std::vector<Part> regions() const;

  /** @brief What of the room hangs together, whatever its regions. */
  std::vector<Part> roomPieces() const;

  void measure(Part& part, std::uint32_t t, std::size_t side) const;

  /** @brief The region that a narrow part goes to: of those in the room, or else of
   * all, the one with the longest edge beside it. */
  static PlanRegion heirOf(const Part& part);

  void assign(const Part& part, const PlanRegion& region);

  double heightOf(int slab, std::uint32_t vertex) const;

  /** @brief A ceiling nearer to its floor than this leaves no room: a millimetre, more
   * only where the grid is coarse. */
  double leastClearance() const { return 20 * solidSeparation(grid_); }

  /** @brief Least height of a part's ceiling over its floor, metres. */
  double clearance(const Part& part) const;

  /** @brief Whether a part's floor meets the ceiling of what is beside it along an
   * edge, or the other way round. */
  bool touchesBeside(const Part& part) const;

  /** @brief Whether a part is open to a part of the room beside it. */
  bool isOpen(const Part& part) const;

  /** @brief Why a part cannot be built, or empty. */
  std::string problemOf(const Part& part) const;

  PlanRegion across(std::uint32_t t, std::size_t side) const;

  /** @brief The edge that is a triangle's side, or null. */
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
  std::vector<PlanRegion> region_; ///< of each triangle
};

} // namespace sedr
} // namespace pcl
