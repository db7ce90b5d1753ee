// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene_mesh.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr::sim {

/** @brief The air between two heights of a cell. */
struct Space {
  enum Kind {
    Inside, ///< of the room
    Niche,  ///< of the room, too
    Reveal, ///< of an opening: open to the room beside it
    Shaft,  ///< from a void of the ceiling to the room above
    Plenum  ///< above the ceiling
  };

  Kind kind = Inside;
  Slab low;
  Slab high;
  Label floor = Label::Other;
  Label ceiling = Label::Other;
  bool floor_is_open = false; ///< to a shaft, as is the ceiling to it or to a plenum
  bool ceiling_is_open = false;
  std::uint32_t opening = 0; ///< number, of a reveal
  bool is_given = true;      ///< by this room; else by that on the other side

  bool isRoom() const { return kind == Inside || kind == Niche; }
};

/** @brief Spaces above each other, from below; none outside of the room. */
using Spaces = std::vector<Space>;

/** @brief A triangle of a room's plan, counter-clockwise. */
struct PlanTriangle {
  std::array<std::uint32_t, 3> corners{}; ///< points of the plan
  std::size_t cell = 0;
};

/** @brief A side of a triangle at the border of its cell. */
struct PlanSide {
  std::uint32_t a = 0; ///< point where it starts, with the cell to its left
  std::uint32_t b = 0; ///< point where it ends
  std::size_t cell = 0;
  std::size_t beyond = 0;   ///< the cell to its right
  bool is_wall = false;     ///< on the room's outline
  bool is_far_side = false; ///< of a reveal
};

/** @brief The plan of a room, its niches and what is open to it, in triangles and
 * cells, each with the same spaces all over. Borders are in chords. */
struct RoomCells {
  std::vector<Vec2> points;
  std::vector<Spaces> cells; ///< the first is that outside of all
  std::vector<PlanTriangle> triangles;
  std::vector<PlanSide> sides;
};

/** @brief Returns the cells of a room, by the exact arrangement and the constrained
 * triangulation of sedr_surface. O(n log n) for n corners.
 * @param index of the room in the scene
 * @throw std::invalid_argument if outlines are degenerate */
RoomCells cellsOf(const Scene& scene, std::size_t index);

/** @brief Adds the closed mesh of a room to that of a scene, and the faces of the other
 * spaces that it gives.
 *
 * Floors and ceilings are the triangles of the plan, lifted to their slabs. Walls,
 * columns, risers, niches and reveals are strips over sides of the plan. A strip has
 * all vertices above its ends, so that faces fit their neighbours.
 * @param index of the room in the scene
 * @throw std::invalid_argument with the end of a sentence: see meshOf() */
void addRoom(const Scene& scene, std::size_t index, SceneMesh& mesh);

} // namespace pcl::sedr::sim
