// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_filters/src/grids/cell_mask.h"
#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_filters/priors.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief Returns the height range of a room, from its floor to its ceiling. The top
 * twentieth of the ceiling points is ignored, as it may be seen through a hole. O(n).
 * @param floor height of its floor, metres
 * @param ceilings heights of its ceiling points; if empty, so is the range */
RoomHeights
heightsFrom(double floor, std::vector<float> ceilings, const Priors& priors = {});

/** @brief Returns the maximum distance in plan of a room's walls from its ceiling,
 * metres: the maximum wall thickness and a margin for noise. */
inline double
wallReach(const Priors& priors = {})
{
  return priors.max_wall + priors.surface_band;
}

/** @brief Merges boxes, grown by `margin` cells, into disjoint boxes. Distant parts are
 * thus processed separately, without a grid over the empty space between. O(n^2). */
std::vector<CellBox> clusterBoxes(const std::vector<CellBox>& boxes, int margin);

/** @brief Assigns positions to rooms. Rooms grow outwards from their ceiling cells
 * until they meet or reach the maximum distance of walls; within two cells of a ceiling
 * the nearest one decides. So each face of a thin partition lies in the room where its
 * air is, whether its other face was seen or not. Rooms above each other grow in
 * separate layers, selected by height. O(cells of the box around all rooms). */
class RoomTerritory {
public:
  /** @param scopes the cells of each room
   * @param heights of each room's lowest floor and highest ceiling; empty if no room
   * lies above another
   * @param reach maximum growth of rooms, metres */
  RoomTerritory(const CellGrid& grid,
                const std::vector<CellSet>& scopes,
                const std::vector<RoomHeights>& heights = {},
                double reach = wallReach(),
                const Priors& priors = {});

  /** @brief Returns the reason for a failure, a sentence; else empty. */
  const std::string& problem() const { return problem_; }

  /** @brief Returns the index in `scopes` of the room at `p`; -1 for none and for
   * non-finite points. */
  std::int32_t roomAt(const Eigen::Vector3f& p) const;

  /** @brief Returns roomAt() of every point. O(n); `threads` 0: all processors. */
  std::vector<std::int32_t> roomsAt(const PointView& points, unsigned threads) const;

private:
  /** @brief The grid of a group of nearby rooms. */
  struct Quarter {
    CellMask seen;                  ///< cells of the rooms' ceilings
    std::vector<std::int32_t> room; ///< room of each cell of the box
  };

  /** @brief A set of rooms that do not lie above each other. */
  using Layer = std::vector<Quarter>;

  bool addLayer(const std::vector<CellSet>& scopes,
                const std::vector<std::size_t>& rooms,
                int steps);

  std::int32_t roomIn(const Layer& layer, Cell cell, const Eigen::Vector2d& p) const;

  CellGrid grid_;
  double reach_;   ///< maximum distance outside a room's heights, half a slab, metres
  double outside_; ///< penalty for a position outside the room's cells, metres
  double deepest_; ///< maximum depth below a floor; reflections are deeper
  std::vector<Layer> layers_;
  std::vector<CellSet> scopes_; ///< only with several layers
  std::vector<RoomHeights> heights_;
  std::string problem_;
};

} // namespace pcl::sedr
