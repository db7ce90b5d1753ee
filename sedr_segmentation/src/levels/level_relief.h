// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "level_candidates.h"

#include <pcl/sedr_filters/priors.h>

#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief Returns the relief of a level: the mean signed distance of each cell's points
 * from its plane, metres, positive up; NaN for empty cells. Cell means show steps that
 * the noise of single points hides. O(n).
 * @param candidates points of the profiles, sorted by height
 * @param reach maximum distance from the plane, metres */
std::vector<double> reliefOf(const LevelColumns& columns,
                             const std::vector<Candidate>& candidates,
                             const PlanSlab& slab,
                             double reach);

/** @brief Returns the noise of a relief: the standard deviation between neighbouring
 * cells, metres. It does not depend on the shape of the surface. O(n). */
double noiseOfRelief(const CellSet& cells, const std::vector<double>& relief);

/** @brief Returns the median of each cell and its eight neighbours, NaN where the cell
 * is NaN. The median preserves the position of steps. O(n).
 * @param flat medians within this distance of 0 become 0, metres; negative: none */
std::vector<double> smoothRelief(const CellSet& cells,
                                 const std::vector<double>& relief,
                                 unsigned threads,
                                 double flat = -1);

/** @brief Marks the cells of drops: the trimmed means of the 20 cm on either side
 * differ by at least 1.5 cm and clearly more than by noise. O(n); the result does not
 * depend on the number of threads. */
std::vector<std::uint8_t> cellsOfDrops(const CellSet& cells,
                                       const std::vector<double>& relief,
                                       unsigned threads,
                                       const Priors& priors = {});

/** @brief Marks the cells of steps: drops with four fifths of their height within 10
 * cm, at one in ten of their cells. A bent or tilted surface of any slope reaches only
 * three fifths. O(n); the result does not depend on the number of threads. */
std::vector<std::uint8_t> cellsOfSteps(const CellSet& cells,
                                       const std::vector<double>& relief,
                                       unsigned threads,
                                       const Priors& priors = {});

/** @brief Returns the search distance for the regions beside a step, cells. */
inline int
stepReach(const Priors& priors)
{
  return static_cast<int>(2 * priors.riser_cells);
}

} // namespace pcl::sedr
