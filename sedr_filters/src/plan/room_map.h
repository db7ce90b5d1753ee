// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/cell_grid.h>
#include <pcl/types.h>

#include <cstdint>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Which room lies over a place: that of the ceiling above it, or under a detail
 * of the ceiling that of the ceiling the detail adjoins.
 *
 * A cell takes the room with most ceiling points in it; rooms grow from there over the
 * cells of details that have none. Where ceilings lie above each other, a point is of
 * the lowest one that is not below it. O(n log n). */
class RoomMap {
public:
  /** @param grid cells of the plan
   * @param points the cloud, must outlive the map
   * @param room of each point of the cloud, 0 none
   * @param ceiling, detail indices into the cloud */
  RoomMap(const CellGrid& grid,
          const PointView& points,
          const std::vector<std::uint32_t>& room,
          const pcl::Indices& ceiling,
          const pcl::Indices& detail);

  /** @brief Room over (or at) point `index` of the cloud, 0 if there is none. O(log n).
   */
  std::uint32_t roomOver(pcl::index_t index) const;

private:
  /** @brief A room over a cell. */
  struct Above {
    std::uint32_t room = 0;
    std::size_t points = 0; ///< of its ceiling, in the cell
    double height = 0;      ///< their mean, metres
  };

  void noteCeilings(const std::vector<std::uint32_t>& room,
                    const pcl::Indices& ceiling);

  CellGrid grid_;
  PointView points_;
  CellSet cells_;
  std::vector<std::uint32_t> room_of_cell_;
  std::vector<std::vector<Above>> above_; ///< by cell: the rooms with a ceiling in it
};

} // namespace sedr
} // namespace pcl
