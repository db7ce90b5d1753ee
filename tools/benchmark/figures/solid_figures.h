// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room_match.h"

#include <pcl/sedr_surface/triangle_mesh.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace pcl {
namespace sedr {
namespace benchmark {

/// How densely surfaces are sampled to be compared, in metres, and the seed of it.
constexpr double sample_spacing = 0.02;
constexpr std::uint64_t sample_seed = 1;

/** @brief How good the solids of a plan are. Lengths are metres, errors shares of the
 * truth, of all paired rooms the largest; what was not measured is empty or NaN. */
struct SolidFigures {
  std::optional<std::size_t> components;
  std::optional<bool> closed_manifold; ///< closed, manifold, consistently oriented
  std::optional<std::size_t> self_intersections; ///< pairs of triangles
  std::optional<std::size_t> triangles;

  /// Over samples of the truth every 2 cm; its corners count for the maximum too.
  double truth_to_solid_mean = not_known;
  double truth_to_solid_max = not_known;
  double solid_to_truth_mean = not_known; ///< likewise, of the solid
  double solid_to_truth_max = not_known;

  double volume_error = not_known;
  double wall_area_error = not_known; ///< of walls and columns

  bool isMeasured() const { return components.has_value(); }
};

/** @brief Measures solids against the truth.
 *
 * @param solid with label and room of every triangle; empty: nothing is measured
 * @param truth likewise, with facets so fine that they count for nothing
 * @param plan,rooms tell which rooms of both are the same: matchRooms() */
SolidFigures measureSolid(const TriangleMesh& solid,
                          const TriangleMesh& truth,
                          const Floorplan& plan,
                          const std::vector<sim::RoomTruth>& rooms,
                          unsigned threads = 0);

} // namespace benchmark
} // namespace sedr
} // namespace pcl
