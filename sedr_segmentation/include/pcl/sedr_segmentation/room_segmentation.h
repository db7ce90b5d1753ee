// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_segmentation/horizontal_levels.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief How ceilings are parted into rooms; lengths in metres. */
struct RoomParameters {
  double cell_size = 0.05;
  double minimum_area = 1.0;        ///< of a room, square metres
  double minimum_height = 1.5;      ///< of a room, from floor to ceiling
  double minimum_floor_share = 0.1; ///< of a room's cells that have its floor below
  double minimum_enclosure = 0.4;   ///< of its outline walled less that left open
  double minimum_open_share =
      0.15; ///< of the outline of a piece that is open to what it belongs to
  double widest_door = 1.6; ///< an opening below a lintel that is wider joins two rooms
  unsigned threads = 0;     ///< 0: as many as there are processors
};

/** @brief A room as the ceilings show it. */
struct RoomRegion {
  std::size_t ceiling_level = 0; ///< of the main, largest ceiling
  std::size_t floor_level = 0;
  CellSet
      ceiling; ///< cells of the main ceiling on both sides of beams, small gaps closed
  CellSet scope;  ///< cells of all its ceilings
  CellSet hidden; ///< those of them along walls that something below hides
};

/** @brief Parts the ceilings of a storey into rooms, largest first.
 *
 * Within a level, rooms are the connected regions of ceiling without wall columns,
 * necks of the width of scan noise cut. Regions that face each other, of one level or
 * two, are one room where no wall stands between them: a step, a beam or a soffit is
 * open below, a doorway is narrow and has a lintel. Regions without floor below are
 * not rooms, nor are those without walls around, but for those that lintels frame.
 *
 * @param levels classified, with inliers
 * @param[out] problem why nothing could be done, a sentence; empty otherwise
 * O(n log n) plus the cells of the bounding box. */
std::vector<RoomRegion> segmentRooms(const PointView& points,
                                     const std::vector<int>& indices,
                                     const std::vector<Level>& levels,
                                     const RoomParameters& parameters,
                                     std::string& problem);

} // namespace sedr
} // namespace pcl
