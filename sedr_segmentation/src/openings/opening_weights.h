// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pcl::sedr {

/** @brief Log-likelihood ratios of "opening" over "wall" and costs of openings, in nats.
 * Neighbouring cells of a wall share their cause, so evidence counts by area and
 * length, not by cells or points. */
struct OpeningWeights {
  // A square metre of a map.
  double seen = -150; ///< the face was seen: only a wrong line or a flush leaf
  double half_seen = -15; ///< one face was seen where nothing shows the other: a leaf
                          ///< flush with it, or furniture before the other
  double within = 120;    ///< points between the two faces: no wall is there
  double empty = 20; ///< nothing, neither on the face nor before it: 0.9 of an opening
                     ///< look so, and a tenth of a wall, in patches of 0.1 m2
  double empty_outside = 8; ///< likewise of a face without another behind it
  // A metre of an edge.
  double reveal = 12;    ///< from a seen face to points within the wall
  double rim = 5;        ///< from a seen face to nothing
  double unseen_edge = -4; ///< hidden, or nothing on both sides
  double no_edge = -10;    ///< the same on both sides, as inside of an opening
  // An opening.
  double opening = -12; ///< four edges and their observations, by BIC
  double no_head = -25;  ///< it reaches the ceiling: a bay, or no wall at all
  double low_head = -15; ///< it stands on the floor, and nobody could walk through
};

/** @brief Sizes of openings and of what is beside them, metres. */
struct OpeningSizes {
  double min_width = 0.35;
  double max_width = 8;     ///< of a glazed front
  double min_height = 0.3;  ///< of a cellar window
  double min_head = 1.75;   ///< height of a door
  double max_gap = 4;       ///< between walls in a line: a bay, drawn to its pane
  double same_line = 0.05;  ///< deviation of walls in a line
  double min_side = 0.4;    ///< length of a wall
  double max_depth = 0.6;   ///< of a wall: Priors::max_wall
  double shallow = 0.3;     ///< of a wall without a known face behind it
  double before = 0.9;      ///< depth of what hides it: Priors::max_furniture_depth
  double on_floor = 0.06;   ///< maximum height of a threshold
  double edge_reach = 0.12; ///< distance of the true edge from that of the cells
};

} // namespace pcl::sedr
