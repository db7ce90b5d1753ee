// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "face_lines.h"

#include <Eigen/Core>

#include <vector>

namespace pcl::sedr {

/** @brief Radii of circles that walls may have, metres. */
struct RadiusRange {
  double min = 0.15;
  double max = 25;
};

/** @brief What curves cost, and what they gain by the faces that they explain, nats.
 * Errors of places are correlated over some 10 cm, beyond three sigma an observation
 * costs 4.5; a parameter of a curve costs the logarithm of 1.5 m to 7 mm, a direction
 * besides the main ones 3 more, a circle 7 more (LoopEnergy). */
struct FaceCosts {
  double face = 40;  ///< a metre that is explained
  double line = 5.4; ///< of a line along a main direction
  double oblique = 13.7;
  double circle = 23;
  double reach = 0.03; ///< metres; places farther from a curve are not explained
};

/** @brief The curves of faces, and the directions of most of them. */
struct FaceCurves {
  std::vector<FaceCurve> curves;
  std::vector<Eigen::Vector2d> normals; ///< main directions, two for each angle
};

/** @brief Finds lines and circles that explain places on the faces of walls: peaks of
 * the offsets along main directions, and what is fitted to chains of neighbouring
 * places with steady normals; each grown as far as places go on. Of all these those are
 * kept that explain what no better one does, by more than their parameters cost
 * (greedily: what is explained is submodular). O(places x curves near them). */
FaceCurves faceCurves(const std::vector<Eigen::Vector2d>& places,
                      const RadiusRange& radii = {});

} // namespace pcl::sedr
