// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/priors.h>

namespace pcl::sedr {

/** @brief Log-likelihood ratios of "opening" over "wall" and costs of openings, in
 * nats. Neighbouring cells of a wall share their cause, so evidence counts by area and
 * length, not by cells or points. */
struct OpeningWeights {
  // A square metre of a map.
  double seen = -150;     ///< the face was seen: only a wrong line or a flush leaf
  double half_seen = -15; ///< one face was seen where nothing shows the other: a leaf
                          ///< flush with it, or furniture before the other
  double within = 120;    ///< points between the two faces: no wall is there
  double empty = 20; ///< nothing, neither on the face nor before it: 0.9 of an opening
                     ///< look so, and a tenth of a wall, in patches of 0.1 m2; or a
                     ///< leaf that stands ajar
  double empty_outside = 8; ///< likewise of a face without another behind it
  // A metre of an edge.
  double reveal = 12;      ///< from a seen face to points within the wall
  double rim = 5;          ///< from a seen face to nothing; 0 in a shade
  double unseen_edge = -4; ///< hidden, or nothing on both sides
  double no_edge = -10;    ///< the same on both sides, as inside of an opening
  // An opening.
  double edge = -0.5;    ///< of each edge that is not on the floor, times
                         ///< ln(length of all edges / edge_bin): BIC
  double arch = 8;       ///< cost of an arched head: top and rise, by BIC, and that
                         ///< most heads are flat
  double low_head = -15; ///< it stands on the floor, and nobody could walk through
};

/** @brief Sizes of openings and of what is beside them, metres. */
struct OpeningSizes {
  double min_width = 0.35;
  double min_height = 0.3;              ///< of a cellar window
  double min_head = 1.75;               ///< height of a door
  double max_gap = 12;                  ///< of a bay, drawn to its pane
  double max_depth = Priors().max_wall; ///< of a wall
  double shallow = 0.3;                 ///< of a wall without a known face behind it
  double before = 1.2;                  ///< depth of what hides it
  double max_niche = 1;                 ///< depth of a niche: Priors::max_niche_depth
  double on_floor = 0.06;               ///< maximum height of a threshold
  double min_around = 0.3;     ///< share of jambs and head with a wall beside them
  double beside = 0.1;         ///< distance from them, beyond the points of a corner;
                               ///< a wall is looked for up to twice as far
  double edge_reach = 0.12;    ///< distance of the true edge from that of the cells
  double usual_lintel = 0.3;   ///< of a usual door below the ceiling
  double leaf_reach = 1.4;     ///< of points before a side that may show a leaf
  double leaf_margin = 0.15;   ///< at the edges of a leaf, where other things are
  double leaf_strip = 0.025;   ///< half the depth of a leaf's points
  double max_leaf = 1.4;       ///< width of a single leaf
  double min_double = 1.1;     ///< width of a door with two leaves
  double min_leaf_share = 0.5; ///< of a leaf that shows
  double max_ajar = 1.05;      ///< angle of a leaf that stands ajar, radians
};

/** @brief Numbers of the maps of walls, of fits and of comparisons. */
struct OpeningNumbers {
  double max_rows = 160;       ///< of a map: cells of halls are larger
  double max_columns = 2000;   ///< of a map
  double edge_bin = 0.01;      ///< of positions of an edge, metres
  double reveal_strip = 0.15;  ///< of a reveal behind the face, before frames, metres
  double min_reveal = 0.35;    ///< share of the length of an edge that shows its reveal
  double sure_reveal = 0.5;    ///< likewise, from which on a reveal is as exact as its
                               ///< points, and a depth that shows as much is closed
  double end_error = 0.015;    ///< of edges that no such reveal shows, metres: of 540
                               ///< of simulated scans 98 % were within twice that
  double unseen_error = 0.07;  ///< of edges that nothing shows; likewise 90 % of 159
  double bay_share = 0.08;     ///< of what is seen of a bay, on the wall before it
  double beyond = -1e6;        ///< nats a square metre where no wall is
  double narrow_door = 0.8;    ///< narrowest usual door, metres
  double high_door = 2.25;     ///< highest usual door, metres
  double usual_wall = 0.1;     ///< thickness of a wall with a usual door, metres
  double min_confidence = 0.5; ///< of a kind that is told
  double leaf_cell = 0.1;      ///< of a leaf, metres
  double raised = 0.3;         ///< sill above which no opening is a door, metres
  double low_window = 0.9;     ///< height of the lowest usual window, metres
  double back_step =
      0.05; ///< between places where the side behind is looked up, metres
  double back_band = 0.03; ///< of points of a back, metres
  double same_share = 0.3; ///< of the smaller of two that are one opening
  double inside = 0.05; ///< of a room beside its wall, where heights are read, metres
  double noise_band = 0.06;    ///< of the points that show the noise, metres
  double min_tolerance = 0.02; ///< of points of a face, metres
  double slab_band = 0.04;     ///< of points of floor and ceiling, metres
  double on_face = 0.05;       ///< of boards on a wall and of a reveal, metres
  double on_model = 0.05;      ///< of points on a wall of the plan, metres
  double off_edge = 0.02;      ///< of a ceiling before a wall, metres
  double ceiling_before = 0.3; ///< that shows how dense its points are, metres
  double min_points = 50;      ///< that show the noise of a face
  double cell_points = 3;      ///< in the middle one of the cells that were seen
  double least_share = 0.15;   ///< of the usual points of a cell in one that was seen
  double sparse_gap = 0.15;    ///< between cells that were seen, metres
  double relief_reach = 0.06;  ///< of cells whose offsets are averaged, metres
  double min_relief = 0.01;    ///< of a leaf behind the face, metres
  double clear = 0.15;         ///< of rays from a face that they cross, metres
  double height_step = 0.25;   ///< between places where heights are read, metres
  double min_island = 4;       ///< around a loop that walls surround, metres
  double min_cosine = 0.97;    ///< between sides of one wall or opening: 14 degrees
};

inline const OpeningNumbers opening_numbers;

} // namespace pcl::sedr
