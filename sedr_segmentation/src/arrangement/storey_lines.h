// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../proposals/face_curves.h"
#include "storey_line.h"

#include <vector>

namespace pcl::sedr {

/** @brief The lines of a storey. */
struct StoreyLines {
  std::vector<StoreyLine> lines;
  double certainty = 0; ///< nats a metre of surface, that it is a wall's
};

/** @brief Returns a line without a surface, where a face or air ends.
 * @param reach its length to both sides of `middle`, metres
 * @param beyond as far it is as past the end of a surface, metres */
StoreyLine endLine(const Eigen::Vector2d& middle,
                   const Eigen::Vector2d& direction,
                   double reach,
                   double beyond,
                   double near);

/** @brief Finds the lines of a storey: those of its faces, and across their ends. Those
 * with most surface come first. */
StoreyLines storeyLines(const StoreyEvidence& storey);

} // namespace pcl::sedr
