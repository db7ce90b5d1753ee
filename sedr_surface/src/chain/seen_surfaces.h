// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_filters/src/grids/place_table.h"
#include "sedr_filters/src/plan/room_lookup.h"
#include "wall_tiles.h"

#include <cstdint>
#include <deque>
#include <map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace pcl::sedr {

/** @brief What was seen of the surfaces of a plan and about them. */
class SeenSurfaces {
public:
  /** @param grid of the cells of floors and ceilings */
  SeenSurfaces(const Floorplan& plan, const CellGrid& grid, const Priors& priors);

  /** @brief Counts a point for the walls that it lies on, else for those that it lies
   * before, or behind unless a room has it; for the floor or ceiling that it lies on,
   * and for what stands up to a ceiling. */
  void add(const Eigen::Vector3d& p);

  /** @brief Checks whether a cell shows points on the floor or ceiling of the r-th room
   * of the plan. */
  bool isOnSlab(std::size_t r, CellKey cell, bool is_floor) const
  {
    return on_slab_[2 * r + (is_floor ? 0 : 1)].count(cell) > 0;
  }

  /** @brief Appends a warning for each wall and each room of which much was not
   * explained, and one if what stands in rooms hangs from their ceilings. */
  void tell(std::vector<PlanWarning>& warnings) const;

private:
  /** @brief Returns the room in which a point lies, or a niche of which; -1: none. */
  int ownerOf(const Eigen::Vector3d& p) const;

  void addStanding(const Eigen::Vector3d& p, std::size_t room);

  /** @brief Counts a point of no room below a floor or above a ceiling. */
  void addBeyond(const Eigen::Vector3d& p);

  /** @brief Warns of a floor and a ceiling that both were seen twice, as in two scans
   * that do not fit. */
  void tellDoubled(std::size_t room, std::vector<PlanWarning>& warnings) const;
  void tellStanding(std::size_t room, std::vector<PlanWarning>& warnings) const;

  /** @brief Warns of what stands on the floor like a wall but ends below the ceiling:
   * long, thin, and with floor on both sides. */
  void tellHalfWalls(std::size_t room, std::vector<PlanWarning>& warnings) const;

  Priors priors_;
  CellGrid grid_;
  std::vector<std::unordered_set<CellKey>> on_slab_; ///< floor and ceiling of each room
  std::vector<std::map<CellKey, float>> beyond_;     ///< heights seen beyond them
  std::deque<RoomLookup> rooms_;
  PlaceTable rooms_near_;
  std::vector<WallTiles> walls_;
  std::vector<std::size_t> room_of_; ///< of each wall
  PlaceTable walls_near_;
  std::vector<std::pair<std::uint32_t, double>> beside_;
  /** @brief What is seen between floor and ceiling in one cell of a room. */
  struct Standing {
    double ceiling = 0; ///< the lowest in and beside the cell: no step stands out
    double floor = 0;
    std::uint64_t heights = 0; ///< in steps of a cell below the ceiling, a bit each
    std::uint64_t above = 0;   ///< likewise above the floor
    Eigen::Vector3d places = Eigen::Vector3d::Zero(); ///< sums of x, y and 1
  };
  std::vector<std::map<CellKey, Standing>> standing_; ///< of each room
};

} // namespace pcl::sedr
