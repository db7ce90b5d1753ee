// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/cell_grid.h>
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/sight_lines.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief How a scan is parted into rooms; lengths in metres. */
struct BuildingParameters {
  double cell_size = 0.05;   ///< of ceilings and floors; air is looked for in cells of
                             ///< twice that
  double headroom = 1.8;     ///< air as high as this is a room's
  double minimum_area = 1.0; ///< of a room with headroom, square metres
  double minimum_enclosure = 0.15; ///< share of a room's outline at which walls stand
  double widest_door = 1.6;    ///< a wider opening parts two rooms only below a lintel
  double widest_passage = 4.0; ///< a wider one does not, whatever is above it
  double storey_step = 1.6;    ///< floors that differ by less may be of one storey
  unsigned threads = 0;        ///< 0: as many as there are processors
};

/** @brief A column of a room: where its air ends above and below, metres. */
struct RoomColumn {
  Cell cell; ///< of the grid of BuildingRooms
  float floor = 0;
  float ceiling = 0;
  bool floor_seen = true;   ///< else something hid it, and it is that of its neighbours
  bool ceiling_seen = true; ///< likewise
  bool is_level = true;     ///< of a part of the ceiling that is level and large enough
                            ///< to be told: not of a vault, a roof or fine ribs
};

/** @brief A room: what hangs together of the air of a building, a height field. */
struct BuildingRoom {
  std::uint32_t id = 0;            ///< from 1, largest first
  std::uint32_t storey = 0;        ///< PlanStorey::number
  std::vector<RoomColumn> columns; ///< by the keys of their cells
  double floor = 0;     ///< height of the lowest level that a tenth of it has
  double ceiling = 0;   ///< the height that most of it has
  double area = 0;      ///< square metres
  double enclosure = 0; ///< share of its outline at which walls stand, doors left out
};

/** @brief What is no room although it was seen. */
enum class LeftOutKind {
  Low,     ///< nowhere large enough to stand in
  Open,    ///< without walls around it: outdoors, or seen through an opening
  Landing, ///< small and on the floor of no storey
  Mirror,  ///< what a floor mirrors, or was seen only through panes
  Void     ///< within slabs, below furniture
};

/** @brief Something that was seen and is no room. */
struct LeftOut {
  LeftOutKind kind = LeftOutKind::Low;
  std::string reason; ///< for people: "no walls around it"
  double area = 0;    ///< in plan, square metres
  double floor = 0;   ///< metres
  double ceiling = 0;
  Eigen::Vector2d at = Eigen::Vector2d::Zero(); ///< a place in it
};

/** @brief What a scan shows of a building. */
struct Building {
  double cell_size = 0; ///< of the columns of its rooms, metres
  std::vector<BuildingRoom> rooms;
  std::vector<PlanStorey> storeys; ///< from the lowest up
  std::vector<PlanDoorway> doorways;
  std::vector<PlanStair> stairs;
  std::vector<LeftOut> left_out; ///< largest first
  double seen_area = 0;          ///< of all air in plan, rooms and not, square metres

  /** @brief The points of the scan: which room each is of, 0 none, and whether it is on
   * its ceiling (1), its floor (2) or neither (0), as StructureLabel says. */
  std::vector<std::uint32_t> room_of;
  std::vector<std::uint32_t> label_of;
};

/** @brief What scanners whose positions are known tell of a scan. */
struct BuildingSight {
  const SightLines* lines = nullptr;  ///< rays; null: not known
  std::vector<std::uint8_t> behind{}; ///< 1 for each point that was seen only through
                                      ///< panes, see findMirroredPoints()
};

/** @brief Parts a scan into rooms and storeys (paper, section 2.3.1, on the envelope
 * instead of on a plane): the free stretches of the plan's columns are linked to the
 * air of the building, whatever its shapes, and parted where walls, doors and lintels
 * are.
 *
 * @param points thinned, z up
 * @param indices those of them that count; empty: all
 * @param[out] problem why there is none, a sentence; empty otherwise
 * @param sight what is seen only through panes is no room, a hole in a slab that rays
 * go through is open
 * O(n) for n points; the same for any number of threads. */
Building findBuilding(const PointView& points,
                      const std::vector<int>& indices,
                      const BuildingParameters& parameters,
                      std::string& problem,
                      const BuildingSight& sight = {});

/** @brief Gives a plan the storeys, doorways and stairs of a building, those of rooms
 * that the plan has: its rooms have the ids of the building's. */
void giveStoreys(const Building& building, Floorplan& plan);

} // namespace sedr
} // namespace pcl
