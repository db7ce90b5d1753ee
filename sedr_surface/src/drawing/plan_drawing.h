// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Geometry>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief What a line of a drawing shows. */
enum class DrawnLayer {
  Wall,
  Column,
  Detail, ///< of a ceiling that is not level: ridges, valleys, springing lines, steps
  FloorDetail,
  Niche,
  Headroom ///< where a ceiling that is not level is 1.5 m above the floor
};

struct DrawnElement {
  PlanElement element;
  DrawnLayer layer = DrawnLayer::Wall;
  std::uint32_t room = 0;
};

/** @brief All lines and arcs of a plan; edges of details and niches that lie on a wall
 * or a column, as near as they are known, are drawn as such only, and of edges of
 * details what is within the room. */
std::vector<DrawnElement> drawnElements(const Floorplan& plan);

/** @brief A place for text within a loop, and its distance from what is around it,
 * metres: that of the place farthest from the loop and from `obstacles`. */
struct TextSpot {
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  double radius = 0;
};

TextSpot textSpotIn(const PlanLoop& loop, const std::vector<PlanLoop>& obstacles);

/** @brief Box around all that is drawn; empty without rooms. */
Eigen::AlignedBox2d boundsOf(const Floorplan& plan);

/** @brief The size of an element as a drawing has it: its length, or "R" and its
 * radius; metres, two decimals. */
std::string sizeText(const PlanElement& element);

/** @brief A level of the plan to be noted where it is: text such as "2.20", heights
 * above the room's floor, with a sign where it is a floor itself. */
struct LevelNote {
  TextSpot spot;
  std::string text;
  DrawnLayer layer = DrawnLayer::Detail;
};

/** @param room_spot where the text about the room stands: notes keep out of its way */
std::vector<LevelNote> levelNotes(const PlanRoom& room, const TextSpot& room_spot);

/** @brief The lines about a room: "Room 1", "23.65 m2", "h 2.40 m". */
std::vector<std::string> roomTexts(const PlanRoom& room,
                                   const Eigen::Vector2d& place,
                                   const std::string& square);

} // namespace sedr
} // namespace pcl
