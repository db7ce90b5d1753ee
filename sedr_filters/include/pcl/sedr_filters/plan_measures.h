// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief What a room takes up of the height of a building, metres. */
struct RoomHeights {
  double low = 0;
  double high = 0;
};

/** @brief The heights of a room's main floor and ceiling at the middle of the box
 * around its corners. O(elements). */
RoomHeights heightsOf(const PlanRoom& room);

/** @brief Those of all rooms, in their order. */
std::vector<RoomHeights> heightsOf(const Floorplan& plan);

/** @brief Whether rooms of these heights can have to do with each other in plan: share
 * a wall, be in each other's way. They do where they have more than a quarter of the
 * lower room's height in common. Rooms that do not lie one above the other, whatever
 * their storeys: a hall of two storeys shares heights with the rooms of both. A floor
 * found too low or a ceiling that slopes up beside the floor above is forgiven. */
bool shareHeights(const RoomHeights& a, const RoomHeights& b);

/** @brief The same of two rooms. */
bool shareHeights(const PlanRoom& a, const PlanRoom& b);

/** @brief The rooms of a plan that share some heights, in its order. */
std::vector<const PlanRoom*> roomsAt(const Floorplan& plan, const RoomHeights& heights);

/** @brief The rooms by storey, from the lowest up: every room is in one of them, and
 * each has a room.
 *
 * Floorplan::storeys where the plan has them, without rooms and storeys that are not
 * there (any more); a room that none of them lists goes to the one whose floor is
 * nearest. Else rooms are of one storey where their heights have more than half of the
 * lower room's in common with those of a room of it. Cost: rooms squared. */
std::vector<PlanStorey> storeysOf(const Floorplan& plan);

/** @brief The number of the storey of each room, by PlanRoom::id. */
std::map<std::uint32_t, std::uint32_t> storeyOfRooms(const Floorplan& plan);

/** @brief The part of a plan that is of a storey: its rooms, and the doorways and
 * stairs that touch one of them. */
Floorplan partOf(const Floorplan& plan, const PlanStorey& storey);

/** @brief The usual name of a storey: "storey 2". */
std::string storeyName(std::uint32_t number);

/** @brief Mean height of a room in metres, over samples of its floor every 5 cm, a
 * million at most; 0 if none lies in it. */
double meanHeight(const PlanRoom& room);

/** @brief What a room of this mean height encloses, its niches too, cubic metres. */
double volumeOf(const PlanRoom& room, double mean_height);

/** @brief Thickness of the wall behind an element of a room's boundary, metres: the
 * median distance to the face on its other side, of another room at its heights or of
 * this one, where that is parallel (to 5 degrees) and at most `most` away. 0 where less
 * than a fifth of the element has such a face: the wall is known from one side only.
 * @param room,element indices into the plan */
double wallThickness(const Floorplan& plan,
                     std::size_t room,
                     std::size_t element,
                     double most = 0.6);

} // namespace sedr
} // namespace pcl
