// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_subdivision.h"
#include "vertex_levels.h"
#include <pcl/sedr_surface/triangle_mesh.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace pcl::sedr {

/** @brief Builds the surface of a room from the subdivision of its plan: a face per
 * slab and region, and vertical strips on the edges. */
class SolidBuilder {
public:
  SolidBuilder(const RoomLayers& layers, const PlanSubdivision& plan);

  /** @brief Fills `mesh` with triangles that have label and, from 0, element.
   * @return an empty string, or why there is no solid */
  std::string build(TriangleMesh& mesh);

private:
  /** @brief A possible vertex of the solid. */
  using Corner = std::pair<std::uint32_t, std::int64_t>; ///< plan vertex, level

  /** @brief Adds the face of a slab.
   * @return false if it could not be triangulated */
  bool addSlab(int slab);

  /** @brief Returns the level of a slab at a vertex, which may be inside the slab. */
  std::int64_t levelOf(int slab, std::uint32_t vertex) const;

  /** @brief Adds the vertical strips on an edge, where exactly one side is solid. */
  void addVertical(const SubdivisionEdge& edge);

  /** @brief Adds the strip over the line from a to b between two slabs, with the solid
   * on its left. Its ends include all levels there, like the adjacent strips. */
  void addStrip(std::uint32_t a,
                std::uint32_t b,
                int low_slab,
                int high_slab,
                std::size_t element);

  std::vector<std::int64_t>
  levelsBetween(std::uint32_t vertex, int low_slab, int high_slab) const;

  /** @brief Returns the possible roles of a strip that separates solid from empty
   * space.
   * @param above whether it reaches up from the other side's ceiling */
  std::vector<LoopRole>
  rolesOn(const PlanRegion& solid, const PlanRegion& other, bool above) const;

  /** @brief Returns the element on an edge with one of the roles. If there is none,
   * because a sliver was merged, returns the nearest. */
  std::size_t elementOn(const SubdivisionEdge& edge,
                        const std::vector<LoopRole>& roles) const;

  void addTriangle(const std::array<Corner, 3>& corners, std::size_t element);

  const RoomLayers& layers_;
  const PlanSubdivision& plan_;
  std::vector<VertexLevels> levels_;
  std::map<Corner, std::uint32_t> vertex_;
  TriangleMesh mesh_;
};

} // namespace pcl::sedr
