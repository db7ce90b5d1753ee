// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <algorithm>

namespace pcl::sedr::ifc {

/** @brief Returns the confidence of a surface, 0 to 1: the share of it that was seen,
 * reduced where points lie off it. A residual of up to 2 cm is normal for scanners and
 * plaster; at twice that the confidence is half of the share.
 * @param seen share; below 0 if unknown, which is then the result
 * @param residual root mean square distance of the points, metres */
inline double
confidence(double seen, double residual)
{
  constexpr double tolerance = 0.02;
  return seen * std::min(1.0, tolerance / std::max(residual, tolerance));
}

/** @brief Returns the confidence of a wall face; -1 if nothing is known of it. */
inline double
confidenceOf(const PlanElement& face)
{
  return face.evidence.isKnown() ? confidence(face.evidence.seen, face.residual) : -1;
}

} // namespace pcl::sedr::ifc
