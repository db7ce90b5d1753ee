// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/priors.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief The range of heights that a room occupies, metres. */
struct RoomHeights {
  double low = 0;
  double high = 0;
};

/** @brief Returns the heights of a room's main floor and ceiling at the middle of the
 * bounding box of its boundary. O(elements). */
RoomHeights heightsOf(const PlanRoom& room);

/** @brief Returns the heights of all rooms, in plan order. */
std::vector<RoomHeights> heightsOf(const Floorplan& plan);

/** @brief Checks whether rooms of these heights can affect each other in plan, for
 * example share a wall. This holds if they share more than a quarter of the height of
 * the less tall room. Storeys play no role: a hall of two storeys shares heights with
 * the rooms of both. The quarter tolerates a floor found too low, or a ceiling that
 * slopes up beside the floor above. */
bool shareHeights(const RoomHeights& a, const RoomHeights& b);

/** @brief Checks the same for two rooms. */
bool shareHeights(const PlanRoom& a, const PlanRoom& b);

/** @brief Returns the rooms of a plan that share the given heights, in plan order. */
std::vector<const PlanRoom*> roomsAt(const Floorplan& plan, const RoomHeights& heights);

/** @brief The heights of a room, metres, and its area, square metres. */
struct RoomLevel {
  std::uint32_t id = 0;
  double floor = 0;
  double ceiling = 0;
  double area = 0;
};

/** @brief Returns the storeys of rooms from the lowest up: a floor less than `step`
 * metres above the mean one of a storey, by area, is in it. O(n log n). */
std::vector<PlanStorey> storeysOf(std::vector<RoomLevel> rooms, double step = 1.6);

/** @brief Returns the storeys from the lowest up. Every room is in exactly one storey,
 * and no storey is empty.
 *
 * Uses Floorplan::storeys if set, without rooms and storeys that no longer exist. An
 * unlisted room goes to the storey with the nearest floor. Otherwise floors decide, as
 * above. */
std::vector<PlanStorey> storeysOf(const Floorplan& plan);

/** @brief Returns the storey number of each room, by PlanRoom::id. */
std::map<std::uint32_t, std::uint32_t> storeyOfRooms(const Floorplan& plan);

/** @brief Returns the height of the main floor over half of a storey's area: pits and
 * landings have heights of their own. */
double usualFloor(const Floorplan& plan, const PlanStorey& storey);

/** @brief Returns the part of a plan that belongs to a storey: its rooms, and the
 * openings and stairs that touch one of them. */
Floorplan partOf(const Floorplan& plan, const PlanStorey& storey);

/** @brief Numbers the openings that have no number yet: in their kind, storey by storey
 * from the lowest up, after those that have one. Numbers stay what they are, so that
 * drawings and schedules of an edited plan agree with earlier ones. */
void numberOpenings(Floorplan& plan);

/** @brief Returns the height of an opening's lower edge above the floor beside it, of
 * the first of its rooms that the plan has; metres. */
double sillOf(const Floorplan& plan, const PlanOpening& opening);

/** @brief A leaf of a door, at the face of the wall that it turns away from. */
struct OpeningLeaf {
  Eigen::Vector2d hinge = Eigen::Vector2d::Zero();
  Eigen::Vector2d shut = Eigen::Vector2d::Zero(); ///< where it ends when shut
  Eigen::Vector2d open = Eigen::Vector2d::Zero(); ///< likewise, turned by 90 degrees
};

/** @brief Returns the leaves of an opening whose hinge is known. */
std::vector<OpeningLeaf> leavesOf(const PlanOpening& opening);

/** @brief Returns the hand of a door's leaf as one sees it who pushes it open, as IFC
 * does: "left" or "right", where its hinges are; "double"; "" if it is not known. */
std::string leafOf(const PlanOpening& opening);

/** @brief Checks whether an opening is at a place in plan: beside its width, less than
 * 0.5 m off the middle of its wall, at heights that overlap its own. */
bool isAt(const PlanOpening& opening,
          const Eigen::Vector2d& place,
          double bottom,
          double top);

/** @brief Returns the name of a kind in files: "door". */
const char* nameOf(OpeningKind kind);

/** @brief Returns the number of an opening on drawings and in schedules: "D3" for a
 * door, "W12" for a window, "P1" for a passage, "O2" for one of unknown kind. */
std::string markOf(const PlanOpening& opening);

/** @brief Returns the default name of a storey: "storey 2". */
std::string storeyName(std::uint32_t number);

/** @brief Heights of a room's ceiling above its floor, details of both included;
 * metres. */
struct ClearHeight {
  double usual = 0; ///< over the middle of the floor by height: half of it has less
  double mean = 0;
  double least = 0;
  double greatest = 0;
  double share_2_0 = 0; ///< of the floor, with at least 2.0 m
  double share_1_5 = 0; ///< of the floor, with at least 1.5 m
  Eigen::Vector2d lowest = Eigen::Vector2d::Zero(); ///< where it is least
};

/** @brief Returns the heights of a room, sampled every 5 cm of its floor, with at most
 * a million samples; 0 if no sample lies in it. Tables, the report and drawings tell
 * the usual one. */
ClearHeight clearHeight(const PlanRoom& room);

/** @brief Returns the volume of a room and its niches, cubic metres; below tilted walls
 * by sections every 5 cm, to some thousandths. */
double volumeOf(const PlanRoom& room, double mean_height);

/** @brief Returns the thickness of the wall behind each element of each room's
 * boundary, metres: that of the longest stretch with a parallel face behind it (within
 * 5 degrees, arcs concentric), of this room or another one at its heights. 0: the wall
 * is known from one side only. Drawings and the IFC have the same walls.
 * @param max_wall maximum thickness, metres */
std::vector<std::vector<double>> wallThicknesses(const Floorplan& plan,
                                                 double max_wall = Priors().max_wall);

/** @brief How much of walls was measured, as shares of their surface without the doors,
 * windows and passages of the plan; the shares add up to 1.
 *
 * A wall of 2.5 m height of which a scan shows the lower half, a cupboard hides a
 * quarter, and nobody saw a quarter: measured 0.5, inferred 0.25, unseen 0.25. */
struct WallShares {
  double area = 0;     ///< square metres; 0: nothing is known of these walls
  double measured = 1; ///< points lie on it
  double inferred = 0; ///< behind something: the wall goes on there
  double unseen = 0;   ///< nothing was seen there, neither a wall nor what hides it

  /** @brief Checks whether so little was measured that the wall is a guess: less than a
   * fifth. */
  bool isGuess() const { return area > 0 && measured < 0.2; }

  WallShares& operator+=(const WallShares& other);
};

/** @brief Returns the shares of a wall: an element of a room's boundary. */
WallShares wallShares(const Floorplan& plan, const PlanRoom& room, std::size_t element);

/** @brief Returns the shares of all walls of a room. */
WallShares wallShares(const Floorplan& plan, const PlanRoom& room);

/** @brief Returns the shares of all walls of a plan. O(elements times openings). */
WallShares wallShares(const Floorplan& plan);

} // namespace pcl::sedr
