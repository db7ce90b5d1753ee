// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "loop.h"
#include "scene.h"

#include <cstddef>
#include <vector>

namespace pcl::sedr::sim {

/** @brief Which loop of a room an edge comes from. */
enum class EdgeSource { Outline, Column, Detail };

/** @brief A region of a room's plan: kVoid, kMain or the detail of number region - 1.
 */
using Region = int;
constexpr Region kVoid = -1; ///< outside of the room, or inside a column
constexpr Region kMain = 0;  ///< the ceiling without its details

/** @brief A segment or arc between two nodes, with one region on either side. */
struct PlanEdge {
  Element element;
  std::size_t start = 0; ///< node
  std::size_t end = 0;   ///< node
  EdgeSource source = EdgeSource::Outline;
  std::size_t source_element = 0; ///< element of the outline, column or detail
  double source_offset = 0.0;     ///< metres along that element where the edge starts
  Region left = kVoid;
  Region right = kVoid;
};

/** @brief A room's plan cut into regions of one ceiling height each.
 *
 * Arcs stay arcs. Two edges meet in nodes only, so that whatever is built from the
 * edges of a subdivision fits together without gaps.
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

/** @brief The region of @p room that @p point is in. */
Region regionAt(const Room& room, Vec2 point);

/** @brief Ceiling height above a region other than kVoid. */
double ceilingHeight(const Room& room, Region region);

/** @brief The vertical face that stands on an edge; none where low equals high. */
struct VerticalFace {
  double low = 0.0;
  double high = 0.0;
  bool room_is_left = true; ///< between these heights the room is left of the edge
  Label label = Label::Wall;
};

/** @brief The face between the ceiling heights on the two sides of @p edge. */
VerticalFace verticalFaceOf(const Room& room, const PlanEdge& edge);

/** @brief Cuts the plan of @p room at all its loops. */
Subdivision subdivide(const Room& room);

/** @brief The closed boundaries of all regions for which @p member is true.
 *
 * The members are to the left: outer boundaries run counter-clockwise, those of holes
 * clockwise. @p member is indexed by region + 1.
 * @throw std::invalid_argument where edges cross or regions touch in a single point.
 */
std::vector<Cycle> boundariesOf(const Subdivision& subdivision,
                                const std::vector<bool>& member);

} // namespace pcl::sedr::sim
