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

/** @brief What tells the kind of an opening: 1; 1 if it has a sill; height of the sill,
 * metres; 1 if a room is behind it; how much narrower, wider and higher it is than
 * usual doors; how much lower than usual its lintel and how much thinner its wall is;
 * share of its area that shows something within the wall; share of its jambs and head
 * beside which a wall was seen; 1 if a leaf stands open beside it. */
using OpeningFeatures = std::array<double, 12>;

/** @brief An opening on the map of a side. */
struct FoundOpening {
  std::size_t side = 0;
  std::size_t behind = 0; ///< the side behind it; the number of sides: none
  WallRectangle rectangle;
  double gain = 0;   ///< nats
  double filled = 0; ///< share that shows something within the wall
  double around = 0; ///< share of jambs and head beside which a wall was seen
  PlanOpening opening;
};

/** @brief The maps of all sides of walls, and the openings on them. */
struct OpeningSearch {
  std::vector<WallSide> sides;
  std::vector<WallMap> maps;
  std::vector<FoundOpening> found; ///< each once

  /** @brief Finds the openings of a plan in a scan.
   * @param sight rays of the scanners; null: unknown */
  OpeningSearch(const Floorplan& plan,
                const PointView& points,
                const pcl::Indices* indices,
                const SightLines* sight,
                const OpeningParameters& parameters);
};

/** @brief Returns the height of the floor before or behind an opening, the higher one.
 */
double highestFloor(const Floorplan& plan, const PlanOpening& opening);

} // namespace pcl::sedr
