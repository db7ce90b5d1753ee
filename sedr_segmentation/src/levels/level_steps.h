// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "level_parting.h"

#include <pcl/sedr_filters/priors.h>

#include <cstddef>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Sets apart what lies a small step above or below a level, though within its
 * tolerance: the reveal of a window that ends just below the ceiling, a shallow soffit
 * or tray.
 *
 * What is off the plane by 3 cm, or four times the noise of its cells if that is more,
 * a decimetre and more wide, and begins at once where the plane ends, is a surface of
 * its own; a plane that is uneven leaves itself gradually. O(n).
 * @param columns all points
 * @param[in,out] draft with its plane and relief; gets the cells apart */
void setStepsApart(const LevelColumns& columns,
                   double tolerance,
                   const Priors& priors,
                   LevelDraft& draft);

/** @brief How far from a plane its own points are: four standard deviations, at least
 * 1.5 cm, at most the tolerance; metres. */
double noiseOf(const PlanSlab& slab, double tolerance, const Priors& priors);

/** @brief The cells of a set that lie in a block of five by five with more cells of the
 * set than a strip two cells wide has: an uneven part of a ceiling does, the last
 * centimetres of a wall below it do not. */
CellSet withoutFringes(const CellSet& cells);

} // namespace sedr
} // namespace pcl
