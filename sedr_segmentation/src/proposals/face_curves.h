// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "face_proposals.h"

namespace pcl::sedr {

/** @brief What curves cost, and what they gain by the faces that they explain, nats: a
 * place is on a curve, with the noise of the scan, or anywhere, as often as places are
 * on no long curve. A parameter of a curve costs the logarithm of 1.5 m to 7 mm, a
 * direction besides the main ones 3 more, a circle 7 more, and both what things cost
 * that lie in line by chance. */
struct FaceCosts {
  double anywhere = 1.5;     ///< metres about a place, where another may be
  double correlation = 0.25; ///< metres, of what places are on
  double together = 0.17;    ///< metres, of what is structure
  double line = 5.4;         ///< of a line along a main direction
  double direction = 8.3;    ///< besides, of a line along another
  double circle = 23;
  double chance = 160; ///< both besides, times the share of places on no long face
  /** @brief Metres. Places farther from a curve than the share of them that is on no
   * long face, in metres, and than this are not explained, nearer ones the less the
   * farther they are: of faces so near each other one is enough, unless they are long.
   */
  double reach = 0.06;
};

/** @brief Finds lines and circles that explain places on the faces of walls: peaks of
 * the offsets along main directions, and what is fitted to chains of neighbouring
 * places with steady normals; each grown as far as places go on. Of all these those are
 * kept that explain what no better one does, by more than their parameters cost
 * (greedily: what is explained is submodular). O(places x curves near them). */
FaceCurves faceCurves(const FacePlaces& places,
                      const RadiusRange& radii = {},
                      unsigned threads = 1);

} // namespace pcl::sedr
