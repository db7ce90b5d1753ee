// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room_match.h"

#include <pcl/sedr_surface/triangle_mesh.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace pcl::sedr::benchmark {

/// Spacing of the samples on surfaces in metres, and their random seed.
constexpr double sample_spacing = 0.02;
constexpr std::uint64_t sample_seed = 1;

/** @brief Quality figures of a plan's solids; empty or NaN if not measured. Lengths are
 * metres; errors are relative, the maximum of all paired rooms. */
struct SolidFigures {
  std::optional<std::size_t> components;
  std::optional<bool> closed_manifold; ///< closed, manifold, consistently oriented
  std::optional<std::size_t> self_intersections; ///< pairs of triangles
  std::optional<std::size_t> triangles;

  /// From samples of the truth every 2 cm; the maximum includes its corners.
  double truth_to_solid_mean = not_known;
  double truth_to_solid_max = not_known;
  double solid_to_truth_mean = not_known; ///< likewise, from samples of the solid
  double solid_to_truth_max = not_known;

  double volume_error = not_known;
  double wall_area_error = not_known; ///< of walls and columns

  bool isMeasured() const { return components.has_value(); }
};

/** @brief Measures solids against the truth.
 *
 * @param solid with label and room of every triangle; if empty, nothing is measured
 * @param truth likewise, with negligible chord errors
 * @param plan,rooms define the pairs of rooms: see matchRooms() */
SolidFigures measureSolid(const TriangleMesh& solid,
                          const TriangleMesh& truth,
                          const Floorplan& plan,
                          const std::vector<sim::RoomTruth>& rooms,
                          unsigned threads = 0);

} // namespace pcl::sedr::benchmark
