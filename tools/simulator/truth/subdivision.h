// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room_regions.h"
#include "simulator/scene/loop.h"
#include "simulator/scene/scene.h"

#include <cstddef>
#include <vector>

namespace pcl::sedr::sim {

/** @brief The kind of loop that an edge comes from. */
enum class EdgeSource { Outline, Column, Detail };

/** @brief The regions on the two sides of an edge. */
struct Sides {
  Region left = kVoid;
  Region right = kVoid;
};

/** @brief A segment or arc between two nodes; separates regions of floor or ceiling. */
struct PlanEdge {
  Element element;
  std::size_t start = 0; ///< node
  std::size_t end = 0;   ///< node
  EdgeSource source = EdgeSource::Outline;
  std::size_t source_element = 0; ///< element of the outline, column or detail
  double source_offset = 0.0;     ///< metres along that element where the edge starts
  Sides floor;
  Sides ceiling;

  const Sides& sides(Layer layer) const
  {
    return layer == Layer::Floor ? floor : ceiling;
  }
};

/** @brief A room's plan, cut into regions of one plane each for floor and ceiling.
 *
 * Arcs stay arcs. Edges that separate regions of the same layer meet only in nodes; the
 * ends of niches are nodes, too. Meshes built from the edges therefore have no gaps.
 * Edges of the floor may cross those of the ceiling.
 */
struct Subdivision {
  std::vector<Vec2> nodes;
  std::vector<PlanEdge> edges;
};

/** @brief An edge traversed from start to end or backwards. */
struct DirectedEdge {
  std::size_t edge = 0;
  bool forward = true;
};

using Cycle = std::vector<DirectedEdge>;

/** @brief The vertical face above an edge, between two planes. */
struct VerticalFace {
  Slab low;
  Slab high;
  bool room_is_left = true; ///< between these planes, the room is left of the edge
  Label label = Label::Wall;
};

/** @brief Returns the vertical faces above @p edge.
 *
 * These are a wall or column from floor to ceiling, or the risers between parts of the
 * floor and of the ceiling of different heights.
 * @throw std::invalid_argument if two parts of the ceiling (or floor) cross there
 */
std::vector<VerticalFace> verticalFacesOf(const Room& room, const PlanEdge& edge);

/** @brief Cuts the plan of @p room at all its loops. */
Subdivision subdivide(const Room& room);

/** @brief Returns the boundaries of all regions of a layer for which @p member is true.
 *
 * Member regions are to the left: outer boundaries run counter-clockwise, those of
 * holes clockwise. @p member is indexed by region + 1.
 * @throw std::invalid_argument where edges cross or regions touch in a single point.
 */
std::vector<Cycle> boundariesOf(const Subdivision& subdivision,
                                Layer layer,
                                const std::vector<bool>& member);

} // namespace pcl::sedr::sim
