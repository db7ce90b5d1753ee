// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "detail_fit.h"

#include "sedr_filters/src/grids/cell_mask.h"
#include <pcl/sedr_filters/priors.h>

#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief Height labels of a room's cells: 0 main slab, k the k-th detail, -1 none. */
struct HeightMap {
  Priors priors;
  CellMask room{CellBox{{0, 0}, {-1, -1}}};
  std::vector<std::int32_t> label;
  std::vector<std::int32_t> seen; ///< labels of seen cells, -1 for filled cells
  PlanSlab main;
  std::vector<PlanSlab> details; ///< with labels 1, 2, ...

  /** @brief Returns whether a cell was not seen. */
  bool isShadow(std::size_t i) const { return seen[i] < 0; }

  const PlanSlab& slabOf(std::int32_t of) const
  {
    return of == 0 ? main : details[static_cast<std::size_t>(of - 1)];
  }
};

/** @brief Labels the cells of a room by its surface, if that is of level planes: the
 * main slab is the largest facet, every other piece of a facet is a detail. Lamps, and
 * pieces that are too small or nearly at the height of the main slab, are none.
 * @param room cells within the boundary */
HeightMap seenHeights(const PointView& points,
                      const SlabEvidence& evidence,
                      const CellMask& room,
                      const RoomFitParameters& parameters);

/** @brief Returns the bounding box of each label's cells, label 0 first; empty for
 * labels without cells. */
std::vector<CellBox> boxesOf(const HeightMap& map);

/** @brief Returns the cells of a label; `box` must contain them. */
CellMask cellsOf(const HeightMap& map, std::int32_t label, const CellBox& box);

/** @brief Gives cells that were not seen, straight between two heights, to the higher
 * one: a ceiling's lower part ends where it was last seen, and hides what is beside it.
 * O(cells not seen times their distance from those that were). */
void giveShadowsToHigher(HeightMap& map, const CellGrid& grid);

/** @brief Assigns the nearest label, by grid steps, to every other cell of the room. */
void fillHeights(HeightMap& map);

} // namespace pcl::sedr
