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

namespace pcl {
namespace sedr {

/** @brief Builds the surface of a room over the subdivision of its plan: a face a slab
 * and region, and upright strips on the edges. */
class SolidBuilder {
public:
  SolidBuilder(const RoomLayers& layers, const PlanSubdivision& plan);

  /** @brief Fills `mesh`: triangles with label and, from 0, element.
   * @return an empty string, or why there is no solid */
  std::string build(TriangleMesh& mesh);

private:
  /** @brief A place where the solid's surface may have a vertex. */
  using Corner = std::pair<std::uint32_t, std::int64_t>; ///< plan vertex, level

  /** @brief Adds the face of a slab.
   * @return false if it could not be triangulated */
  bool addSlab(int slab);

  /** @brief Level of a slab above a vertex, which may lie within the slab. */
  std::int64_t levelOf(int slab, std::uint32_t vertex) const;

  /** @brief Adds what stands on an edge: where one of its sides is solid and the other
   * is not. */
  void addUpright(const SubdivisionEdge& edge);

  /** @brief Adds the strip over the way from a to b, with the solid on its left,
   * between two slabs. Its ends take up all levels there, as the strips beside it do.
   */
  void addStrip(std::uint32_t a,
                std::uint32_t b,
                int low_slab,
                int high_slab,
                std::size_t element);

  std::vector<std::int64_t>
  levelsBetween(std::uint32_t vertex, int low_slab, int high_slab) const;

  /** @brief What stands on an edge where one side is solid and the other is not.
   * @param above whether it reaches up from the other side's ceiling */
  std::vector<LoopRole>
  rolesOn(const PlanRegion& solid, const PlanRegion& other, bool above) const;

  /** @brief The element of one of the roles that lies on an edge; where none does,
   * since a sliver went to what is beside it, the nearest. */
  std::size_t elementOn(const SubdivisionEdge& edge,
                        const std::vector<LoopRole>& roles) const;

  void addTriangle(const std::array<Corner, 3>& corners, std::size_t element);

  const RoomLayers& layers_;
  const PlanSubdivision& plan_;
  std::vector<VertexLevels> levels_;
  std::map<Corner, std::uint32_t> vertex_;
  TriangleMesh mesh_;
};

} // namespace sedr
} // namespace pcl
