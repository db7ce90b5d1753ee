// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/priors.h>
#include <pcl/sedr_segmentation/building.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief Parameters of the room segmentation; lengths in metres. */
struct BuildingParameters {
  double cell_size =
      0.05; ///< of ceilings and floors; gaps are found in cells of twice that
  double headroom = 1.8;           ///< minimum height of a gap of a room
  double minimum_area = 1.0;       ///< of a room with headroom, square metres
  double minimum_enclosure = 0.15; ///< share of a room's outline with walls
  double storey_step = 1.6; ///< minimum height difference of the floors of two storeys
  bool own_frame = false;   ///< whether the grid lies in that of findBuildingFrame()
  Priors priors;            ///< for the owners of points
  unsigned threads = 0;     ///< 0: all processors
};

/** @brief Returns the reason why parameters are invalid, a sentence; empty if valid. */
std::string problemOf(const BuildingParameters& parameters);

/** @brief Divides a scan into rooms and storeys (paper, section 2.3.1, on the envelope
 * instead of a plane). The gaps of the profiles are linked to the free space of the
 * building, which is divided at walls, doors and lintels: at what parts two basins of
 * free space as a whole, not at single columns.
 *
 * @param points thinned, z up
 * @param indices the points to use; empty: all
 * @param[out] problem the reason if there is no building, a sentence; else empty
 * @param behind 1 per point seen only through panes, see findMirroredPoints(): space
 * behind them is no room; empty: not known. O(n) for n points; the result does not
 * depend on the number of threads.
 */
Building findBuilding(const PointView& points,
                      const std::vector<int>& indices,
                      const BuildingParameters& parameters,
                      std::string& problem,
                      const std::vector<std::uint8_t>& behind = {});

} // namespace pcl::sedr
