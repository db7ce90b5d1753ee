// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "opening_weights.h"
#include "wall_map.h"
#include "wall_sides.h"

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/priors.h>

#include <array>
#include <vector>

namespace pcl::sedr {

/** @brief Parameters of the search for openings. */
struct OpeningParameters {
  OpeningWeights weights;
  OpeningSizes sizes;
  unsigned threads = 0; ///< 0: all processors
};

/** @brief What tells whether there is an opening or niche, and of what kind: 1; how far
 * it is raised, 0 on the floor to 1; height of the sill, metres; 1 if a room is behind
 * it; how much narrower than usual doors it is, wider with a room behind it, and
 * higher; how much lower than usual its lintel; share of its area that shows something
 * within the wall; share of its jambs and head beside which a wall was seen; 1 if a
 * leaf stands open beside it; share in which a face was seen, the greater one; how much
 * lower than usual windows it is; shares that a back closes and that show something
 * farther behind; depth of the back; how much lower than a door it is on the floor;
 * share of its height below which it has a back and above none; 1 if it is the lower,
 * or the upper part of such a one; how much thicker than a leaf is what parts its back
 * from a face behind it that was seen; how much wider than usual doors it is with no
 * room behind it; that raise if its wall has two faces, nothing closes it and all edges
 * show reveals. */
using OpeningFeatures = std::array<double, 23>;

/** @brief What closes a rectangle of a wall behind its face. */
struct OpeningBack {
  double depth = 0;  ///< most usual of what is farthest, metres; 0: nothing is seen
  double closed = 0; ///< share of the cells that end there
  double beyond = 0; ///< share of the cells that show something farther behind
};

/** @brief An opening on the map of a side. */
struct FoundOpening {
  std::size_t side = 0;
  std::size_t behind = 0; ///< the side behind it; the number of sides: none
  WallRectangle rectangle;
  double filled = 0; ///< share that shows something within the wall
  double around = 0; ///< share of jambs and head beside which a wall was seen
  double closed = 0; ///< share in which the face of its side was seen
  double solid = 0;  ///< share in which the face behind was seen
  OpeningBack back;
  double split = 0; ///< share of its height below which it has a back and above none
  double odds = 0;  ///< log-odds of the likeliest kind over none
  int part = 0; ///< of the one before: 1, its lower part; 2, its upper one; 0: whole
  PlanOpening opening;
  PlanNiche niche; ///< without a boundary: it is none

  bool isNiche() const { return !niche.boundary.elements.empty(); }
};

/** @brief The maps of all sides of walls, and the openings on them. */
struct OpeningSearch {
  std::vector<WallSide> sides;
  std::vector<WallMap> maps;
  std::vector<FoundOpening> found;

  /** @brief Finds the openings of a plan in a scan.
   * @param sight rays of the scanners; null: unknown */
  OpeningSearch(const Floorplan& plan,
                const PointView& points,
                const pcl::Indices* indices,
                const SightLines* sight,
                const OpeningParameters& parameters);

  /** @brief Keeps of those that are the same, seen from two sides, the likeliest. */
  void keepEachOnce(double max_depth);
};

/** @brief Returns the height of the floor before or behind an opening, the higher one.
 */
double highestFloor(const Floorplan& plan, const PlanOpening& opening);

/** @brief Returns the rectangle with edges moved to the planes of the reveals, else to
 * the rim of the face's points. An arched head stays.
 * @param cells extent of the rectangle found on the map */
WallRectangle
fittedEdges(const WallMap& map, const WallRectangle& cells, const OpeningSizes& sizes);

/** @brief Counts what the cells of a candidate show on both faces of its wall. */
void countCells(const OpeningSearch& search,
                const OpeningSizes& sizes,
                FoundOpening& candidate);

/** @brief Returns the share of jambs and head beside which a face was seen, on either
 * side of the wall: an opening is a hole in a wall. */
double seenAround(const OpeningSearch& search,
                  const FoundOpening& candidate,
                  const WallRectangle& at,
                  const OpeningSizes& sizes);

/** @brief Returns the back of a rectangle, away from its rim. O(cells log cells). */
OpeningBack backOf(const WallMap& map, const WallRectangle& at);

/** @brief Returns the height of the border between a lower part of a rectangle that has
 * a back and an upper one that has none at that depth; its bottom: there is none. */
double
headOfBack(const WallMap& map, const WallRectangle& at, const OpeningSizes& sizes);

/** @brief Sets hinge, swing and state of the openings beside which a leaf stands open:
 * a sheet as wide and high as the opening, or two of half its width, that begins at a
 * jamb and ends. Those are turned so that the leaf is to the left of their direction.
 * Others stay unknown.
 * @param indices of the points to use; null: all */
void findLeaves(const Floorplan& plan,
                const PointView& points,
                const pcl::Indices* indices,
                const OpeningSizes& sizes,
                unsigned threads,
                std::vector<FoundOpening>& found);

/** @brief Keeps those that are openings or niches by log-odds of what was measured of
 * them, each once and a whole one or its parts, and names their kinds. Below a
 * probability of one half a kind is unknown, as is that of a door or passage too low to
 * walk. Only doors have leaves; one that shuts a door within its wall is closed. */
void
nameOpenings(const Floorplan& plan, OpeningSearch& search, const OpeningSizes& sizes);

/** @brief Returns a candidate as a niche of its room: a box behind a straight wall, up
 * to its back. Without a boundary if it cannot be one: it has no back or a deep one, it
 * reaches from floor to ceiling and is a part of the room, or a room is there. */
PlanNiche nicheOf(const Floorplan& plan,
                  const OpeningSearch& search,
                  const FoundOpening& found,
                  const OpeningSizes& sizes);

/** @brief Moves those found that are niches to their rooms. Of niches above each other
 * the likeliest is kept, as a plan has one floor and one ceiling per position. */
void placeNiches(OpeningSearch& search, Floorplan& plan);

/** @brief Returns whether a niche of a room overlaps that room, another one of the same
 * heights or a niche of one. */
bool isShared(const Floorplan& plan, const PlanRoom& room, const PlanNiche& niche);

/** @brief Stores in PlanElement::evidence which shares of every wall and side of a
 * column the maps show: seen, with points on the plan's surface; hidden, by what stands
 * before it or in its shade; open, as all of its openings. A surface that was hardly
 * seen is hidden but where rays went through. Mouths of niches, corners and the edges
 * to floor and ceiling do not count. O(cells). */
void measureEvidence(const OpeningSearch& search, unsigned threads, Floorplan& plan);

} // namespace pcl::sedr
