// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/cell_grid.h>
#include <pcl/types.h>

#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief The map from a place to the room of the ceiling above it; under a detail, the
 * room of the adjoining ceiling.
 *
 * A cell takes the room with most ceiling points in it; rooms then grow over cells of
 * details without a room. Where several ceilings lie above a point, the lowest of them
 * counts. O(n log n). */
class RoomMap {
public:
  /** @param grid cells of the plan
   * @param points the cloud, must outlive the map
   * @param room room of each point of the cloud, 0 for none
   * @param ceiling,detail indices into the cloud */
  RoomMap(const CellGrid& grid,
          const PointView& points,
          const std::vector<std::uint32_t>& room,
          const pcl::Indices& ceiling,
          const pcl::Indices& detail);

  /** @brief Returns the room above (or at) point `index` of the cloud, 0 if there is
   * none. O(log n). */
  std::uint32_t roomOver(pcl::index_t index) const;

private:
  /** @brief A room over a cell. */
  struct Above {
    std::uint32_t room = 0;
    std::size_t points = 0; ///< number of its ceiling points in the cell
    double height = 0;      ///< mean height of these points, metres
  };

  void noteCeilings(const std::vector<std::uint32_t>& room,
                    const pcl::Indices& ceiling);

  CellGrid grid_;
  PointView points_;
  CellSet cells_;
  std::vector<std::uint32_t> room_of_cell_;
  std::vector<std::vector<Above>> above_; ///< rooms with a ceiling in each cell
};

} // namespace pcl::sedr
