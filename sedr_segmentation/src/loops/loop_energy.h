// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace pcl::sedr {

/** @brief The energy of the loops of a storey, in nats (negative log-likelihoods).
 *
 *     E = sum over samples of the contours
 *           explained share x min(1, obstacles + (d / 3 sigma)^2) x outlier
 *             d: distance of the surface beside the sample from its curve
 *         + unexplained share x what an unseen wall of that kind costs x outlier
 *         + area between contour and curve: `cut` where seen air is cut off, `other`
 * within another room, else `add`
 *       + sum over changes of curve
 *           corner ln(`wall` / spacing) + `bend` a metre of extension; two and a
 * parameter for a connecting piece, which is a line that nothing shows
 *       + sum over distinct curves
 *           ln(reach / sigma) a parameter, + `rare_oblique`, `rare_arc`
 *
 * Samples lie a cell apart. Their deviations are correlated over a length that is
 * measured (WallNoise), so a sample is spacing / correlation of an observation. */
struct LoopEnergy {
  double min_correlation = 0.05; ///< metres: of neighbouring samples
  double max_correlation = 0.2;  ///< metres
  double outlier = 4.5;          ///< nats of an observation beyond three sigma
  double rare_arc = 7;           ///< nats: one wall in a thousand is curved
  double rare_oblique = 3;       ///< nats: one in twenty is along no main direction
  double unseen_oblique = 0.3;   ///< share of `outlier` of a wall that nobody saw
  double cut = 400;              ///< nats a square metre of seen air that is cut off
  double add = 20;               ///< nats a square metre that is taken in
  double other = 3600;           ///< nats a square metre of another room
  double wall = 3;               ///< metres: walls are so long between corners
  double bend = 20;              ///< nats a metre of a connecting piece or an extension
  double free_extension = 0.2;   ///< metres; shorter extensions are the corner's own
  double reach = 1.5;       ///< metres: curves farther from the contour do not matter
  double min_sigma = 0.007; ///< metres: walls are not known better here
  double max_sigma = 0.02;  ///< metres
  double max_spread = 0.03; ///< metres, of a wall of some metres
  double min_radius = 0.15; ///< metres, of arcs
  double max_radius = 25;   ///< metres
};

/** @brief Limits of the search for the least energy. They decide how long it takes, and
 * what it may miss. */
struct LoopSearch {
  double beyond = 6;           ///< metres: a wall goes on in line beyond its surface
  double max_extension = 3;    ///< metres, of two curves to their corner
  double max_turn = 0.07;      ///< radians: lines are turned so far into a direction
  double min_seen = 0.6;       ///< share of the samples through which a curve is laid
  double least_fall = 0.5;     ///< nats: of a round, or it was the last
  double least_gain = 0.1;     ///< nats: of a proposal where it replaces others
  std::size_t candidates = 12; ///< of a sample
  std::size_t neighbours = 40; ///< samples solved again on each side of a change
};

} // namespace pcl::sedr
