// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "storey_regions.h"

#include <array>
#include <vector>

namespace pcl::sedr {

/** @brief The surfaces around a room, its own and those of the rooms beside it, and how
 * dear a border between two cells is. */
struct Surroundings {
  CellMask opaque;
  CellMask air;    ///< seen by any room
  CellMask others; ///< seen air of other rooms, fixed to them
  std::array<std::vector<float>, 4> factor;
};

/** @brief Cells behind the lines of walls. */
struct BehindLines {
  CellMask reveal; ///< seen, within a wall's thickness
  CellMask back;   ///< around the backs of shallow niches
  CellMask wall;   ///< within a wall
};

/** @brief Returns a mask with gaps of twice a radius, in cells, filled. */
CellMask closed(const CellMask& mask, double radius);

/** @brief Finds reveals, backs of niches and the inside of walls, by steps outwards
 * from the lines of a room's walls. */
class RevealSearch {
public:
  /** @brief The arguments must outlive this. */
  RevealSearch(const RoomCells& room,
               const Surroundings& around,
               const CellGrid& grid,
               const RegionEnergy& energy);

  /** @brief Looks at both sides of a line. */
  void lookBehind(const WallLine& line);

  const BehindLines& found() const { return found_; }

private:
  bool is(const CellMask& mask, const Eigen::Vector2d& p) const;
  void mark(CellMask& mask, const Eigen::Vector2d& p);
  void lookBehind(const Eigen::Vector2d& p, const Eigen::Vector2d& out, AlongLine what);

  const CellGrid& grid_;
  const RegionEnergy& energy_;
  const CellMask& air_;
  CellMask seen_;
  CellMask closed_; ///< near opaque surfaces
  CellMask next_;   ///< near the air of other rooms
  CellMask pillar_; ///< near what may be columns
  CellMask above_;  ///< walls that go on above an opening,
  CellMask below_;  ///< and below it
  BehindLines found_;
};

} // namespace pcl::sedr
