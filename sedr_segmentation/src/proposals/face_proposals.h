// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "face_lines.h"
#include "face_places.h"

#include <Eigen/Core>

#include <vector>

namespace pcl::sedr {

/** @brief Radii of circles that walls may have, metres. */
struct RadiusRange {
  double min = 0.15;
  double max = 25;

  /** @brief Checks whether a curve is a line or has such a radius.
   * @param noise of places on it, metres */
  bool allows(const PlanCurve& curve, double noise) const
  {
    return !curve.isCircle() || (curve.radius > min - 3 * noise && curve.radius < max);
  }
};

constexpr double long_face = 1; ///< metre: of a wall, not of a thing
constexpr double max_gap =
    2.5; ///< metres, within a proposed line: a labelling closes more

/** @brief The curves of faces, and the directions of most of them. */
struct FaceCurves {
  std::vector<FaceCurve> curves;
  std::vector<Eigen::Vector2d> normals; ///< main directions, two for each angle
  double certainty = 0; ///< nats a metre of surface, that it is structure
};

/** @brief Proposes lines and circles: peaks of the offsets along main directions, and
 * what is fitted to chains of neighbouring places with steady normals, each grown as
 * far as places go on. O(places x curves near them). */
FaceCurves
proposeFaces(const FacePlaces& places, const RadiusRange& radii, unsigned threads);

/** @brief Returns the normal of the main direction that a line is along, or null. */
const Eigen::Vector2d* mainNormalOf(const PlanCurve& curve,
                                    const std::vector<Eigen::Vector2d>& normals);

} // namespace pcl::sedr
