// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../overhead/ceiling_lines.h"

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/straightening.h>

#include <Eigen/Geometry>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief What a line of a drawing represents. */
enum class DrawnLayer {
  Wall,
  Column,
  Detail, ///< of a sloping or curved ceiling: springing lines, steps
  Ridge,  ///< ridges, hips and valleys of a sloping ceiling
  FloorDetail,
  Niche,
  Headroom ///< where a ceiling that is not level is 1.5 or 2.3 m above the floor
};

struct DrawnElement {
  PlanElement element;
  DrawnLayer layer = DrawnLayer::Wall;
  std::uint32_t room = 0;
  std::string note{}; ///< text along it: "ridge 4.35", "h 1.50"; usually empty
};

/** @brief Returns the lines of the ceiling of each room, see ceilingLines(). */
std::vector<CeilingLines> ceilingsOf(const Floorplan& plan, double finest);

/** @brief Returns all lines and arcs of a plan. Edges of details and niches that
 * coincide with a wall or column, within tolerance, are drawn only as such. Edges of
 * details are cut off at the room; borders of facets are lines of the ceilings. The
 * head of a tilted wall is a detail, with its tilt as text.
 * @param ceilings from ceilingsOf() */
std::vector<DrawnElement> drawnElements(const Floorplan& plan,
                                        const std::vector<CeilingLines>& ceilings,
                                        const WallTilts& tilts = {});

/** @brief A place for text within a loop, as far as possible from the loop and from
 * `obstacles`, and that distance in metres. */
struct TextSpot {
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  double radius = 0;
};

TextSpot textSpotIn(const PlanLoop& loop, const std::vector<PlanLoop>& obstacles);

/** @brief Returns the size of an element for a drawing: its length, or "R" and its
 * radius; metres, two decimals. */
std::string sizeText(const PlanElement& element);

/** @brief Returns the size of a column: "Ø 0.40", "0.30 x 0.50"; empty for other
 * shapes. */
std::string columnText(const PlanLoop& column);

/** @brief Returns the text lines of a room: "Room 1", "23.65 m2", "h 2.40 m". */
std::vector<std::string> roomTexts(const PlanRoom& room,
                                   const CeilingLines& ceiling,
                                   const Eigen::Vector2d& place,
                                   const std::string& square);

} // namespace pcl::sedr
