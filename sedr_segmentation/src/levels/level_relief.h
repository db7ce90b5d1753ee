// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "level_candidates.h"

#include <pcl/sedr_filters/priors.h>

#include <cstdint>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief The relief about a level: mean distance from its plane of what was seen in
 * each cell, metres, up is positive; NaN where nothing was. Means of cells tell steps
 * that are lost in the noise of single points. O(n).
 * @param candidates of the columns, sorted by height
 * @param reach how far from the plane is looked, metres */
std::vector<double> reliefOf(const LevelColumns& columns,
                             const std::vector<Candidate>& candidates,
                             const PlanSlab& slab,
                             double reach);

/** @brief Standard deviation of the cells of a relief from their neighbours: noise
 * alone, whatever the surface does. Metres; O(n). */
double noiseOfRelief(const CellSet& cells, const std::vector<double>& relief);

/** @brief The median of a cell and its eight neighbours, NaN where the cell is. Steps
 * keep their place in it. O(n).
 * @param flat medians no farther than that from 0 are given as 0, metres; negative:
 * none is */
std::vector<double> smoothRelief(const CellSet& cells,
                                 const std::vector<double>& relief,
                                 unsigned threads,
                                 double flat = -1);

/** @brief Marks the cells of drops: where the middle means of what is on either side,
 * in the 20 cm from a cell on, differ by 1.5 cm or more, and clearly more than noise
 * lets them. O(n); the same for any number of threads. */
std::vector<std::uint8_t> cellsOfDrops(const CellSet& cells,
                                       const std::vector<double>& relief,
                                       unsigned threads,
                                       const Priors& priors = {});

/** @brief Marks the cells of steps: of drops of which four fifths are there within 10
 * cm, along one in ten of these cells. What bends or leans, however steep it is, has
 * none: three fifths of its height are. O(n); the same for any number of threads. */
std::vector<std::uint8_t> cellsOfSteps(const CellSet& cells,
                                       const std::vector<double>& relief,
                                       unsigned threads,
                                       const Priors& priors = {});

/** @brief How far from a step what is beside it is looked for, cells. */
inline int
stepReach(const Priors& priors)
{
  return static_cast<int>(2 * priors.riser_cells);
}

} // namespace sedr
} // namespace pcl
