// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "level_parting.h"

#include <pcl/sedr_filters/priors.h>

#include <cstddef>
#include <vector>

namespace pcl::sedr {

/** @brief Separates surfaces a small step above or below a level, though within its
 * tolerance: a window reveal just below the ceiling, a shallow soffit or tray.
 *
 * A separate surface is off the plane by at least 3 cm, or four times the noise of its
 * cells if more. It is at least a decimetre wide and begins abruptly at the edge of the
 * plane; an uneven plane deviates gradually. O(n).
 * @param columns profiles of all points
 * @param[in,out] draft must have its plane and relief; gets the cells apart */
void setStepsApart(const LevelColumns& columns,
                   double tolerance,
                   const Priors& priors,
                   LevelDraft& draft);

/** @brief Returns the maximum distance of a plane's own points: four standard
 * deviations, at least 1.5 cm, at most the tolerance; metres. */
double noiseOf(const PlanSlab& slab, double tolerance, const Priors& priors);

/** @brief Returns the cells that lie in a block of 5 x 5 with more than 10 cells of the
 * set, i.e. more than a strip two cells wide. This keeps uneven parts of a ceiling and
 * removes the last centimetres of a wall below it. */
CellSet withoutFringes(const CellSet& cells);

} // namespace pcl::sedr
