// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pcl::sedr {

/** @brief What is believed of stairs; metres. Building codes ask for rises of 0.14 to
 * 0.2 and goings of 0.22 to 0.37, on the line on which one walks. */
struct StairPriors {
  double min_rise = 0.12;
  double max_rise = 0.22;
  double min_going = 0.1; ///< of winders, near the newel
  double max_going = 0.45;
  double deepest = 0.55;    ///< of a tread; what is deeper is a landing
  double min_area = 0.02;   ///< square metres, of the part of a tread that was seen
  double clearance = 1.2;   ///< of the air above one
  double level = 0.025;     ///< a surface rises by less a cell or two
  double flatness = 0.02;   ///< standard deviation of its heights
  double rise_sigma = 0.02; ///< of the steps of a flight
  double going_sigma = 0.06;
  double turn_sigma = 0.6;  ///< radians a step
  double step_gain = 3;     ///< nats that the next step is worth against furniture
  double missing = 2.5;     ///< nats that a tread costs which was not seen
  int max_missing = 3;      ///< of treads that follow each other
  double floor_gain = 3;    ///< nats that the floor at an end of a chain is worth
  double chain_cost = 9;    ///< nats: a chain may begin anywhere
  double min_odds = 4;      ///< nats of a chain that is told
  double same_floor = 0.08; ///< metres between heights of one floor
  double near = 0.6;        ///< metres from the end of a flight to its floor, and from
                            ///< treads to their underside
  double level_sigma = 0.012; ///< of the height of a patch, metres
  double edge_sigma = 0.03;   ///< of its front and its back
  double oblique = 3;         ///< nats: one flight in twenty is along no wall beside it
  double around = 2.5;        ///< metres from treads to the walls that tell directions
  double wall = 1;            ///< metres of height of a surface of a wall
  int max_unseen = 20;        ///< treads from the last one that was seen to a floor
};

inline constexpr StairPriors stair_priors;

} // namespace pcl::sedr
