// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../overhead/ceiling_lines.h"
#include "plan_layers.h"
#include "sedr_filters/src/walls/plan_walls.h"

#include "sedr_filters/src/walls/tilted_walls.h"
#include <pcl/sedr_filters/floorplan.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief A line of a drawing, metres. */
struct PlanLine {
  PlanElement element;
  PlanLayer layer = PlanLayer::Wall;
  std::uint32_t room = 0;
  std::string note{}; ///< text along it: "ridge 4.35", "h 1.50"; usually empty
};

/** @brief Returns the lines of the ceiling of each room, see ceilingLines(). */
std::vector<CeilingLines> ceilingsOf(const Floorplan& plan, double finest);

/** @brief Returns all lines and arcs of a plan. Edges of floor details and niches on a
 * wall or column are not repeated, nor is drawn what of them is outside of the room, or
 * of the ceiling where it is the underside of a stair. An arrow leads up each slope of
 * the floor, with its share as note.
 * The head of a tilted wall has its tilt as note.
 * @param walls from findWalls(): of those with one seen face the far side is drawn
 * @param ceilings from ceilingsOf() */
std::vector<PlanLine> planLines(const Floorplan& plan,
                                const std::vector<PlanWall>& walls,
                                const std::vector<CeilingLines>& ceilings);

/** @brief An opening for drawing: a gap through its wall, from face to face. */
struct OpeningGap {
  std::string mark; ///< its number, see markOf()
  std::array<Eigen::Vector2d, 4>
      corners;       ///< around the gap: along a face, back; metres
  double width = 0;  ///< metres
  double height = 0; ///< metres
  double sill = 0;   ///< of a window above the floor, metres
  OpeningKind kind = OpeningKind::Unknown;
  std::vector<PlanElement> leaf{}; ///< of a door: its leaves and their swings
};

/** @brief Returns the layer of a gap. */
inline PlanLayer
layerOf(const OpeningGap& gap)
{
  return gap.kind == OpeningKind::Window ? PlanLayer::Window : PlanLayer::Door;
}

/** @brief Returns the lines along a gap of what shuts it, metres: two of a window, one
 * of a door whose leaves are not known; none for other gaps. */
std::vector<PlanElement> fillingOf(const OpeningGap& gap);

/** @brief Returns all lines of a gap: its jambs, both faces below a window, what shuts
 * it, leaves and swings. */
std::vector<PlanElement> linesOf(const OpeningGap& gap);

/** @brief Returns what is left of the face of a wall beside gaps in it. */
std::vector<PlanElement> cutAtGaps(const PlanElement& element,
                                   const std::vector<OpeningGap>& gaps);

/** @brief Returns the gaps of the openings of a plan, each through its whole wall; in
 * none of the walls, as deep as their reveals. */
std::vector<OpeningGap> openingGaps(const Floorplan& plan,
                                    const std::vector<PlanWall>& walls);

/** @brief Returns both sides of the head of an arrow, metres. */
std::array<PlanElement, 2> arrowHead(const Eigen::Vector2d& from,
                                     const Eigen::Vector2d& tip);

/** @brief Returns the convex outline of a stair's flights in plan. */
PlanLoop stairwellOf(const PlanStair& stair);

/** @brief Adds the flights of all stairs: up to 1.2 m above the lower room's floor on a
 * plan with that room, whole on one that has the upper room only, without what lies
 * below another flight that is drawn. */
void addStairs(const Floorplan& plan, std::vector<PlanLine>& lines);

} // namespace pcl::sedr
