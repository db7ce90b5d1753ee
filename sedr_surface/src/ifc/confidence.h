// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <algorithm>

namespace pcl {
namespace sedr {
namespace ifc {

/** @brief How far a surface may be trusted, from 0 to 1: the share of it that was seen,
 * less where points lie off it. A residual of up to 2 cm is what scanners and plaster
 * do; of twice that the confidence is half the share.
 * @param seen share, or less than 0 where it is not known: that is the result then
 * @param residual root mean square distance of the points, metres */
inline double
confidence(double seen, double residual)
{
  constexpr double tolerance = 0.02;
  return seen * std::min(1.0, tolerance / std::max(residual, tolerance));
}

/** @brief The confidence of a wall's face; -1 where nothing is known of it. */
inline double
confidenceOf(const PlanElement& face)
{
  return face.evidence.isKnown() ? confidence(face.evidence.seen, face.residual) : -1;
}

} // namespace ifc
} // namespace sedr
} // namespace pcl
