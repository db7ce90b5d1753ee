// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pcl::sedr {

/** @brief Thresholds that several stages have in common and that no belief about a
 * building changes. Lengths in metres, shares from 0 to 1, directions in radians. */
struct StageThresholds {
  // Bands: ten deviations of 1 cm; the paper's Table 1.
  static constexpr double surface_band =
      0.1; ///< width of the band of a surface with its noise
  static constexpr double wall_band =
      0.05; ///< points of a wall are within this distance

  // Sampling: cells and gaps in which evidence is counted.
  static constexpr double run_gap =
      0.15; ///< maximum gap in a surface, three usual voxels
  static constexpr double patch =
      0.5; ///< edge of a surface patch whose direction is fitted
  static constexpr double cell_fill =
      0.97; ///< share of ceiling cells filled in a dense enough scan
  static constexpr double max_enlargement =
      2.5; ///< maximum factor of the cell size in a sparse scan
  static constexpr double min_scan_points =
      1000; ///< minimum number of points of a room

  // The share of an object that was seen.
  static constexpr double share_unseen = 0.05; ///< smaller shares count as nothing
  static constexpr double share_little = 0.2;  ///< smaller shares may be strays
  static constexpr double share_clear = 0.6;   ///< seen of a wall that certainly exists
  static constexpr double share_closed = 0.7;  ///< seen of the back of a niche
  static constexpr double share_most = 0.8;    ///< seen of what certainly exists

  // Directions.
  static constexpr double same_axis =
      0.026; ///< parallel or square to the scan's axes: 1.5 degrees
};

} // namespace pcl::sedr
