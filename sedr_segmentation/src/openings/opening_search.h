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

/** @brief Returns where the openings of a plan lie on a side. */
std::vector<WallRectangle> openingsOn(const Floorplan& plan, const WallSide& side);

/** @brief Returns the height of the floor before or behind an opening, the higher one.
 */
double highestFloor(const Floorplan& plan, const PlanOpening& opening);

} // namespace pcl::sedr
