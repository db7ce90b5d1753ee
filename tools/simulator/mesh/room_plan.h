// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene_mesh.h"
#include "simulator/scene/queries.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace pcl::sedr::sim {

/** @brief A triangle of a room's plan, counter-clockwise, below one part of its ceiling
 * and above one part of its floor. */
struct PlanTriangle {
  std::array<std::uint32_t, 3> corners{}; ///< points of the plan
  int floor = -1;                         ///< detail of the floor, -1: none
  int ceiling = -1;                       ///< detail of the ceiling, -1: none
  bool floor_is_open = false;             ///< to a room below
  std::optional<std::size_t> hole_above;  ///< void of the room
};

/** @brief A side of a triangle where the room ends, or its floor or ceiling changes. */
struct PlanSide {
  std::uint32_t a = 0; ///< point where it starts, with the triangle to its left
  std::uint32_t b = 0; ///< point where it ends
  std::size_t triangle = 0;
  std::optional<std::size_t> beyond; ///< triangle to its right; empty: a wall or column
  std::optional<std::size_t> wall;   ///< element of the room's outline
  double from = 0.0;                 ///< metres along that element, of a
  double to = 0.0;                   ///< metres along that element, of b

  bool isWithin(const WallGap& gap) const
  {
    const double middle = 0.5 * (from + to);
    return wall == gap.wall && middle > gap.from && middle < gap.to;
  }
};

/** @brief A room's plan in triangles. Its sides include all outlines, in chords, and
 * end at the ends of all gaps in walls. */
struct RoomPlan {
  std::vector<Vec2> points;
  std::vector<PlanTriangle> triangles; ///< in the room only
  std::vector<PlanSide> sides;
};

/** @brief Returns the plan of a room, by the exact arrangement and the constrained
 * triangulation of sedr_surface. O(n log n) for n corners.
 * @param openings in its walls, also those given by other rooms
 * @param floor_voids holes in its floor
 * @throw std::invalid_argument if outlines are degenerate */
RoomPlan planOf(const Room& room,
                const std::vector<Opening>& openings,
                const std::vector<Loop>& floor_voids);

/** @brief Adds the closed mesh of one room to the mesh of a scene.
 *
 * Floors and ceilings are the triangles of the plan, lifted to their slabs. Walls,
 * columns, risers and niches are strips over sides of the plan. A strip has all
 * vertices above its ends, so that faces fit their neighbours.
 * @param number of the room, from 1
 * @param openings in its walls, also those given by other rooms
 * @param floor_voids holes in its floor
 * @return the plan of the room
 * @throw std::invalid_argument with the end of a sentence: see meshOf() */
RoomPlan addRoom(const Room& room,
                 std::uint32_t number,
                 const std::vector<Opening>& openings,
                 const std::vector<Loop>& floor_voids,
                 SceneMesh& scene);

} // namespace pcl::sedr::sim
