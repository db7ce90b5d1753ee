// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "detail_fit.h"

#include "sedr_filters/src/grids/cell_mask.h"
#include <pcl/sedr_filters/priors.h>

#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief The height of every cell of a room: 0 the main slab, k the k-th detail, -1
 * none. */
struct HeightMap {
  Priors priors;
  CellMask room{CellBox{{0, 0}, {-1, -1}}};
  std::vector<std::int32_t> label;
  std::vector<std::int32_t> seen; ///< the labels of what was seen, -1 where filled
  PlanSlab main;
  std::vector<PlanSlab> details; ///< of labels 1, 2, ...
  std::vector<double> relief;    ///< of a ceiling: what was seen of each cell, over the
                                 ///< main slab, metres; NaN where nothing was
  std::set<std::pair<std::int32_t, std::int32_t>>
      bends; ///< labels from one to the other of which a ceiling goes on without a step

  const PlanSlab& slabOf(std::int32_t of) const
  {
    return of == 0 ? main : details[static_cast<std::size_t>(of - 1)];
  }
};

/** @brief Mean height of a slab over the main one, above the cells of a mask. */
double heightOverMain(const PlanSlab& main,
                      const PlanSlab& slab,
                      const CellMask& cells,
                      const CellGrid& grid);

/** @brief The evidence of a ceiling, with what is no step off its main slab among that
 * of it: the fields into which beams part a ceiling may be of several levels. */
SlabEvidence withFieldsOfMain(const PointView& points,
                              SlabEvidence evidence,
                              const PlanSlab& main_slab,
                              const RoomFitParameters& parameters);

/** @brief Labels the cells of the main slab and of each connected detail. */
HeightMap seenHeights(const PointView& points,
                      const SlabEvidence& evidence,
                      const PlanSlab& main_slab,
                      const CellMask& room,
                      const RoomFitParameters& parameters);

/** @brief The box of the cells of each label, 0 first; empty for those without any. */
std::vector<CellBox> boxesOf(const HeightMap& map);

/** @brief The cells of a label; `box` holds them. */
CellMask cellsOf(const HeightMap& map, std::int32_t label, const CellBox& box);

/** @brief Gives every other cell of the room the label that is nearest by steps. */
void fillHeights(HeightMap& map);

} // namespace sedr
} // namespace pcl
