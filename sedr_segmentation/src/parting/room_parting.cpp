// SPDX-License-Identifier: BSD-3-Clause
#include "room_parting.h"

#include "room_basins.h"
#include "room_borders.h"

#include "../air/ceiling_dip.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief What the border of two rooms says of whether they are one. */
struct Openness {
  double share = 0;            ///< of the border that is open
  bool are_doors = false;      ///< and of it all between jambs as of doors
  bool has_doors = false;      ///< and these part two rooms
  bool is_other_level = false; ///< one lies above the other, or a storey's step apart
};

/** @brief Joins rooms until walls or doors are between all: first where nothing is like
 * a door, of these first where the border is most open. */
class RoomJoining {
public:
  RoomJoining(const AirGaps& air,
              const std::vector<float>& dip,
              const PartingParameters& parameters,
              RoomLabels& labels)
      : air_(air)
      , parameters_(parameters)
      , labels_(labels)
      , rooms_(air, parameters, labels)
      , measures_(air, dip, parameters)
  {}

  void joinAll()
  {
    for (const auto& entry : rooms_.borders())
      judge(entry.first);
    while (!to_join_.empty())
      join(to_join_.begin()->second);
  }

private:
  /** @brief What of borders to open is opened first: where no doors are, then the more
   * open one. */
  using Turn = std::pair<bool, double>;

  void forget(const RoomPair& pair)
  {
    if (const auto turn = turn_.find(pair); turn != turn_.end()) {
      to_join_.erase({turn->second, pair});
      turn_.erase(turn);
    }
  }

  void judge(const RoomPair& pair)
  {
    forget(pair);
    if (rooms_.areStacked(pair) && isPlace(higherOf(pair)))
      return; // else the air above a thing in the room
    const Openness openness = opennessOf(pair);
    if (openness.is_other_level || !isOneSpace(pair, openness))
      return;
    turn_[pair] = {openness.are_doors, -openness.share};
    to_join_.insert({turn_[pair], pair});
  }

  Openness opennessOf(const RoomPair& pair)
  {
    constexpr double cells_a_length = 1.2; // of a slanting line, in the mean
    const RoomBorder& border = rooms_.between(pair);
    const double cell = air_.columns().cellSize();
    Openness openness;
    double open = 0;
    double length = static_cast<double>(border.walls) * cell / cells_a_length;
    bool are_doors = true;
    bool are_plain = true; // no wider than one door
    bool have_lintels = true;
    double beside = 0; // of an opening with how far the wider room goes on beside it
    for (const MeasuredOpening& m : openingsIn(border)) {
      const bool is_step = floorStep(pair, m) > parameters_.same_floor &&
                           isLarge(pair.first) && isLarge(pair.second);
      const bool is_above_furniture = is_step && !areLevels(pair);
      length += m.width;
      open += m.width * (is_above_furniture ? 1 : m.open_height);
      are_doors = are_doors && isDoor(m, parameters_);
      beside = std::max(beside, m.width * m.open_height + m.beside);
      have_lintels = have_lintels && m.dip >= parameters_.lintel;
      are_plain = are_plain && have_lintels && m.width <= parameters_.widest_door;
      openness.is_other_level =
          openness.is_other_level || (is_step && !is_above_furniture);
    }
    if (open <= 0)
      return openness;
    openness.share = open / length;
    const double of_width =
        have_lintels ? open / std::max(length, beside) : openness.share;
    openness.are_doors = are_doors;
    openness.has_doors = are_doors &&
                         (are_plain || of_width <= parameters_.widest_share) &&
                         isPlace(pair.first) && isPlace(pair.second);
    return openness;
  }

  /** @brief The openings of a border: doors one by one, but a wide opening as one that
   * columns stand in. */
  std::vector<MeasuredOpening> openingsIn(const RoomBorder& border)
  {
    std::vector<MeasuredOpening> openings;
    for (const double pier : {0.0, parameters_.thickest_wall}) {
      openings.clear();
      for (const auto& crossings : openingsOf(air_, border.crossings, pier))
        openings.push_back(measures_.measure(crossings, labels_));
      if (std::all_of(openings.begin(), openings.end(), [&](const MeasuredOpening& m) {
            return m.width <= parameters_.widest_door;
          }))
        break;
    }
    return openings;
  }

  /** @brief What one steps up or down from one room to the other: near the opening, or
   * from floor to floor if that is less, past the edge of a stairwell. */
  double floorStep(const RoomPair& pair, const MeasuredOpening& opening) const
  {
    return std::min(std::abs(opening.floor_a - opening.floor_b),
                    std::abs(floorOf(pair.first) - floorOf(pair.second)));
  }

  double floorOf(std::uint32_t room) const
  {
    return rooms_.room(room).floors.highestCount();
  }

  std::uint32_t higherOf(const RoomPair& pair) const
  {
    return floorOf(pair.first) > floorOf(pair.second) ? pair.first : pair.second;
  }

  /** @brief Whether a room is large enough, has an outline of its own and takes someone
   * in: what is open on most sides is a place between columns or furniture, what is
   * narrower a ledge. */
  bool isPlace(std::uint32_t room) const
  {
    return rooms_.room(room).area >= parameters_.smallest_room &&
           rooms_.openShare(room) <= parameters_.max_open &&
           rooms_.room(room).depth >= parameters_.min_way / 2;
  }

  /** @brief Whether of two rooms the higher is on a floor: below a part of it is air of
   * the lower room's height in which one can stand, as below a gallery. Else it is the
   * air above furniture. */
  bool areLevels(const RoomPair& pair) const
  {
    const std::uint32_t high = higherOf(pair);
    const RoomExtent& higher = rooms_.room(high);
    const double floor = floorOf(high == pair.first ? pair.second : pair.first);
    const double cell = air_.columns().cellSize();
    return static_cast<double>(higher.roofs.countAbove(floor)) * cell * cell >
           parameters_.min_over_air * higher.area;
  }

  /** @brief Whether a room may be a level of its own, more than a landing. */
  bool isLarge(std::uint32_t room) const
  {
    return rooms_.room(room).area >= parameters_.smallest_level;
  }

  /** @brief Whether no wall and no door is between two rooms. */
  bool isOneSpace(const RoomPair& pair, const Openness& openness) const
  {
    return !openness.has_doors &&
           openness.share > (isPlace(pair.first) && isPlace(pair.second)
                                 ? parameters_.min_open
                                 : parameters_.min_open_of_part);
  }

  /** @brief Joins two rooms and judges anew all borders of the joined one. */
  void join(const RoomPair pair)
  {
    for (const std::uint32_t other : rooms_.room(pair.second).beside)
      forget(std::minmax(pair.second, other));
    rooms_.join(pair);
    for (const std::uint32_t other : rooms_.room(pair.first).beside)
      judge(std::minmax(pair.first, other));
  }

  const AirGaps& air_;
  const PartingParameters& parameters_;
  RoomLabels& labels_;
  RoomBorders rooms_;
  OpeningMeasures measures_;
  std::map<RoomPair, Turn> turn_; ///< of borders to open
  std::set<std::pair<Turn, RoomPair>> to_join_;
};

/** @brief Of the gaps of a column that are of one room the tallest stays: others are
 * below its stairs or above its furniture. */
void
keepHeightField(const AirGaps& air, std::vector<std::int32_t>& room)
{
  for (std::uint32_t g = 0; g + 1 < air.size(); ++g)
    for (std::uint32_t o = g + 1; o < air.size() && air[o].column == air[g].column; ++o)
      if (room[g] != PartedAir::no_room && room[g] == room[o])
        room[air.height(g) < air.height(o) ? g : o] = PartedAir::no_room;
}

std::vector<RoomOpening>
openingsBetween(const AirGaps& air,
                const std::vector<float>& dip,
                const PartingParameters& parameters,
                RoomLabels& labels)
{
  OpeningMeasures measures(air, dip, parameters);
  std::vector<RoomOpening> openings;
  for (const auto& [pair, all] : waysBetween(air, labels))
    for (const auto& crossings : openingsOf(air, all, 0)) {
      openings.push_back(measures.measure(crossings, labels));
      openings.back().a = pair.first;
      openings.back().b = pair.second;
    }
  return openings;
}

} // namespace

PartedAir
partIntoRooms(const AirGaps& air, const PartingParameters& parameters)
{
  const std::vector<float> dip =
      dipOfCeiling(air, static_cast<int>(std::lround(parameters.lintel_reach /
                                                     air.columns().cellSize())));
  RoomLabels labels(roomBasins(air, dip, parameters));
  RoomJoining(air, dip, parameters, labels).joinAll();
  std::vector<std::int32_t> room = labels.joined();
  keepHeightField(air, room);
  RoomLabels rooms(std::move(room));
  PartedAir parted;
  parted.room = rooms.joined();
  parted.rooms = rooms.sizes().size();
  parted.openings = openingsBetween(air, dip, parameters, rooms);
  return parted;
}

} // namespace pcl::sedr
