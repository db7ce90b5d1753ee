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

/** @brief Finds the lines of a storey: those of its faces, and across their ends. Those
 * with most surface come first. */
StoreyLines storeyLines(const StoreyEvidence& storey);

} // namespace pcl::sedr
