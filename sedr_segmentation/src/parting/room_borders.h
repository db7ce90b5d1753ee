// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../air/air_gaps.h"
#include "../air/height_counts.h"
#include "parting_parameters.h"
#include "room_labels.h"
#include "room_opening.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace pcl::sedr {

/** @brief Two rooms, the lower number first. */
using RoomPair = std::pair<std::uint32_t, std::uint32_t>;

/** @brief What is between two rooms. */
struct RoomBorder {
  std::vector<Crossing> crossings;
  std::size_t walls = 0; ///< ends of air that face the other room's across a wall
};

/** @brief The ways from one room to another, by pairs of rooms: their links, but for
 * those over the edge of a gallery, and where one climbs through a slab, see
 * AirGaps::isDrop() and AirGaps::climb(). O(links). */
std::map<RoomPair, std::vector<Crossing>> waysBetween(const AirGaps& air,
                                                      RoomLabels& labels);

/** @brief What is known of a room while rooms are joined. */
struct RoomExtent {
  double area = 0;                ///< square metres
  double depth = 0;               ///< of the place farthest from its rim, metres
  std::size_t ends = 0;           ///< where its air ends
  HeightCounts floors;            ///< of its gaps
  HeightCounts roofs;             ///< of the air below them in which one can stand
  std::set<std::uint32_t> beside; ///< rooms with which it has a border
  std::map<std::uint32_t, std::size_t> stacked; ///< pairs of a gap and one of another
                                                ///< room in the same column
};

/** @brief The rooms of a building and the borders between them, which are joined. */
class RoomBorders {
public:
  /** @brief O(gaps).
   * @param labels of the gaps; must outlive this */
  RoomBorders(const AirGaps& air,
              const PartingParameters& parameters,
              RoomLabels& labels);

  const std::map<RoomPair, RoomBorder>& borders() const { return borders_; }
  const RoomBorder& between(const RoomPair& pair) const { return borders_.at(pair); }
  const RoomExtent& room(std::uint32_t r) const { return rooms_[r]; }

  /** @brief Share of a room's outline at which it goes on into others. */
  double openShare(std::uint32_t room) const;

  /** @brief Whether most of the smaller of two rooms lies above or below the other, by
   * their pairs of gaps. */
  bool areStacked(const RoomPair& pair) const;

  /** @brief Joins the second of two rooms to the first, and its borders. */
  void join(const RoomPair& pair);

private:
  void measureRooms(const AirGaps& air);
  void countWalls(const AirGaps& air, int reach);

  RoomLabels& labels_;
  double column_area_; ///< square metres
  std::vector<RoomExtent> rooms_;
  std::map<RoomPair, RoomBorder> borders_;
};

} // namespace pcl::sedr
