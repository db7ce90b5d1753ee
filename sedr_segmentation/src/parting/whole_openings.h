// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room_borders.h"
#include "room_opening.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <unordered_map>
#include <vector>

namespace pcl::sedr {

/** @brief The openings of rooms as seen from one side, each as a whole: a passage into
 * a hall may lead to several of the parts between its beams. They are found once for
 * each room, until it is joined with another. */
class WholeOpenings {
public:
  /** @param air and all others must outlive this */
  WholeOpenings(const AirGaps& air,
                const PartingParameters& parameters,
                const RoomBorders& rooms,
                OpeningMeasures& measures,
                RoomLabels& labels)
      : air_(air)
      , parameters_(parameters)
      , rooms_(rooms)
      , measures_(measures)
      , labels_(labels)
  {}

  /** @brief Whether an opening below a lintel, with no wall at one of its ends, is part
   * of a wider one out of a room that is a door: in one wall, with jambs on both sides.
   * The first question for a room is O(its crossings). */
  bool isPartOfDoor(std::uint32_t room, const MeasuredOpening& opening);

  /** @brief Forgets what has changed when the second of two rooms was joined to the
   * first.
   * @return borders of other rooms that share an opening with one of the joined room:
   * isPartOfDoor() may have changed for them */
  std::vector<RoomPair> afterJoining(const RoomPair& pair);

private:
  struct Whole {
    std::vector<Crossing> crossings; ///< out of the room
    std::optional<MeasuredOpening> measured;
  };

  /** @brief The openings of a room. */
  struct OfRoom {
    std::vector<Whole> wholes;
    std::unordered_map<std::uint64_t, std::size_t> at; ///< by crossing, see keyOf()
  };

  Crossing outOf(std::uint32_t room, const Crossing& crossing) const
  {
    return labels_.roomOf(crossing.from) == room ? crossing
                                                 : Crossing{crossing.to, crossing.from};
  }
  static std::uint64_t keyOf(const Crossing& crossing)
  {
    return (std::uint64_t{crossing.from} << 32U) | crossing.to;
  }

  OfRoom& ofRoom(std::uint32_t room);

  const AirGaps& air_;
  const PartingParameters& parameters_;
  const RoomBorders& rooms_;
  OpeningMeasures& measures_;
  RoomLabels& labels_;
  std::map<std::uint32_t, OfRoom> known_;
};

} // namespace pcl::sedr
