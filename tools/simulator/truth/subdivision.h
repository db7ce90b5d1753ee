// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room_regions.h"
#include "simulator/scene/loop.h"
#include "simulator/scene/scene.h"

#include <cstddef>
#include <vector>

namespace pcl::sedr::sim {

/** @brief Which loop of a room an edge comes from. */
enum class EdgeSource { Outline, Column, Detail };

/** @brief The regions on the two sides of an edge. */
struct Sides {
  Region left = kVoid;
  Region right = kVoid;
};

/** @brief A segment or arc between two nodes that parts regions of floor or ceiling. */
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

/** @brief A room's plan cut into regions of one plane each, of floor and of ceiling.
 *
 * Arcs stay arcs. Two edges that part the same layer meet in nodes only, and so do
 * edges and the ends of niches, so that whatever is built from the edges of a
 * subdivision fits together without gaps. Edges of the floor may cross those of the
 * ceiling.
 */
struct Subdivision {
  std::vector<Vec2> nodes;
  std::vector<PlanEdge> edges;
};

/** @brief An edge walked from start to end or backwards. */
struct DirectedEdge {
  std::size_t edge = 0;
  bool forward = true;
};

using Cycle = std::vector<DirectedEdge>;

/** @brief The vertical face that stands on an edge, between two planes. */
struct VerticalFace {
  Slab low;
  Slab high;
  bool room_is_left = true; ///< between these planes the room is left of the edge
  Label label = Label::Wall;
};

/** @brief The faces that stand on @p edge.
 *
 * Wall or column from floor to ceiling, or the risers between two parts of the floor
 * and between two parts of the ceiling, as far as these are of different heights.
 * @throw std::invalid_argument if two parts of the ceiling (or floor) cross there
 */
std::vector<VerticalFace> verticalFacesOf(const Room& room, const PlanEdge& edge);

/** @brief Cuts the plan of @p room at all its loops. */
Subdivision subdivide(const Room& room);

/** @brief The closed boundaries of all regions of a layer for which @p member is true.
 *
 * The members are to the left: outer boundaries run counter-clockwise, those of holes
 * clockwise. @p member is indexed by region + 1.
 * @throw std::invalid_argument where edges cross or regions touch in a single point.
 */
std::vector<Cycle> boundariesOf(const Subdivision& subdivision,
                                Layer layer,
                                const std::vector<bool>& member);

} // namespace pcl::sedr::sim
