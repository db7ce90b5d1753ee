// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_layers.h"
#include "sedr_filters/src/walls/plan_walls.h"

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_surface/floorplan_drawing.h>

#include <array>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief An opening for drawing: a gap through its wall, from face to face. */
struct OpeningGap {
  std::string mark; ///< its number, see markOf()
  std::array<Eigen::Vector2d, 4>
      corners;       ///< around the gap: along a face, back; metres
  double width = 0;  ///< metres
  double height = 0; ///< metres
  double sill = 0;   ///< of a window above the floor, metres
  OpeningKind kind = OpeningKind::Unknown;
  bool has_faces = false;          ///< both faces of the wall go on below or above it
  bool has_filling = true;         ///< what shuts it is drawn
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
 * none of the walls, as deep as their reveals. Seen from below they have no leaves, and
 * the wall goes on above those that end below the ceiling. */
std::vector<OpeningGap> openingGaps(const Floorplan& plan,
                                    const std::vector<PlanWall>& walls,
                                    DrawingView view = DrawingView::Floor);

} // namespace pcl::sedr
