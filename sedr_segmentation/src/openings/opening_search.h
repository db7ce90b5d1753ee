// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "opening_edges.h"
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

/** @brief What tells whether there is an opening, and of what kind: 1; how far it is
 * raised, 0 on the floor to 1; height of the sill, metres; 1 if a room is behind it;
 * how much narrower, wider and higher it is than usual doors; how much lower than usual
 * its lintel; share of its area that shows something within the wall; share of its
 * jambs and head beside which a wall was seen; 1 if a leaf stands open beside it; share
 * of a raised one in which a face was seen; how much lower than usual windows it is. */
using OpeningFeatures = std::array<double, 13>;

/** @brief An opening on the map of a side. */
struct FoundOpening {
  std::size_t side = 0;
  std::size_t behind = 0; ///< the side behind it; the number of sides: none
  WallRectangle rectangle;
  double gain = 0;   ///< nats
  double filled = 0; ///< share that shows something within the wall
  double around = 0; ///< share of jambs and head beside which a wall was seen
  double closed = 0; ///< share in which one face was seen, of that of which more was
  PlanOpening opening;
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

  /** @brief Keeps of those that are the same, seen from two sides, the best one. */
  void keepEachOnce();

  /** @brief Returns the share of an opening in which the face of its side was seen. */
  double seenInside(const FoundOpening& opening) const;
};

/** @brief Returns the height of the floor before or behind an opening, the higher one.
 */
double highestFloor(const Floorplan& plan, const PlanOpening& opening);

/** @brief Sets the niches of the rooms to those of the candidates for openings that
 * have a back.
 *
 * A niche is a rectangle in a straight wall most cells of which show nothing on the
 * wall or before it and end at one depth behind it, and hardly any shows something
 * farther behind. Shallow ones are closed doors or blinds, those from floor to ceiling
 * parts of the room. None reaches into a room or a niche of another one. Of niches
 * above each other, only the largest one is kept, as a plan has one floor and one
 * ceiling per position. */
void findNiches(const Priors& priors, const OpeningSearch& search, Floorplan& plan);

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
