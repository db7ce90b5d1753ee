// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../overhead/ceiling_faces.h"
#include "../overhead/surface_lines.h"
#include "plan_layers.h"
#include "sedr_filters/src/walls/plan_walls.h"

#include "sedr_filters/src/walls/tilted_walls.h"
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_surface/floorplan_drawing.h>

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

/** @brief What a drawing shows of the ceiling and the floor of a room. */
struct DrawnSurfaces {
  /** @param room must outlive this object */
  explicit DrawnSurfaces(const PlanRoom& room)
      : faces(room)
  {}

  /** @brief Finds the lines, see surfaceLines(). */
  void findLines(double finest);

  CeilingFaces faces;
  SurfaceLines ceiling{};
  SurfaceLines floor{};
};

/** @brief Returns all lines and arcs of a plan. Edges of niches on a wall or column are
 * not repeated, nor is drawn on a plan of the floor what of the ceiling is the
 * underside of a stair. An arrow leads up each slope, of the floor with its share, of
 * the ceiling with its angle as note. The head of a tilted wall has its tilt as note.
 * @param walls from findWalls(): of those with one seen face the far side is drawn
 * @param surfaces of each room */
std::vector<PlanLine> planLines(const Floorplan& plan,
                                const std::vector<PlanWall>& walls,
                                const std::vector<DrawnSurfaces>& surfaces,
                                DrawingView view = DrawingView::Floor);

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
