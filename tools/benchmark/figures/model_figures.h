// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/triangle_mesh.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>

namespace pcl::sedr::benchmark {

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

/** @brief Radius of the zone around the true details, metres. */
constexpr double detail_zone = 0.10;

/** @brief Quality figures of a mesh. Lengths are metres, shares from 0 to 1; values
 * that were not measured are empty or NaN. */
struct ModelFigures {
  std::optional<std::size_t> components;
  std::optional<bool> closed;
  std::optional<bool> edge_manifold;
  std::optional<bool> vertex_manifold;
  std::optional<bool> closed_manifold; ///< all three, and consistently oriented

  double truth_to_mesh_mean = not_known;
  double truth_to_mesh_rms = not_known;
  double truth_to_mesh_p95 = not_known;
  double truth_to_mesh_max = not_known;
  double truth_within_1cm = not_known; ///< share of the true area
  double truth_within_5cm = not_known;

  double mesh_to_truth_mean = not_known;
  double mesh_to_truth_p95 = not_known;
  double mesh_to_truth_max = not_known;
  double mesh_beyond_5cm = not_known; ///< share of the model's area

  /// Share of the true area in the zone around details and columns; NaN without any.
  double detail_within_1cm = not_known;
  double detail_within_5cm = not_known;

  bool isMeasured() const { return components.has_value(); }
};

/** @brief Measures a mesh against the truth, with samples every 2 cm on both.
 * @param truth with labels, for the zone around details
 * @throw std::runtime_error with MeshEvaluation's sentence if one of them is invalid */
ModelFigures measureModel(const std::shared_ptr<const TriangleMesh>& mesh,
                          const std::shared_ptr<const TriangleMesh>& truth,
                          unsigned threads = 0);

} // namespace pcl::sedr::benchmark
