// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_filters/src/grids/cell_mask.h"
#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_filters/priors.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief What a room takes up of the height of a building: from its floor to its
 * ceiling but for a twentieth of that, which may be what was seen through a hole. O(n).
 * @param floor height of its floor, metres
 * @param ceilings heights of what was seen of its ceiling; of none the range is empty
 */
RoomHeights
heightsFrom(double floor, std::vector<float> ceilings, const Priors& priors = {});

/** @brief How far from a room's ceiling its walls may be, metres: the thickest, and
 * what noise makes of it. */
inline double
wallReach(const Priors& priors = {})
{
  return priors.max_wall + priors.surface_band;
}

/** @brief Which room a place belongs to: rooms grow from the cells of their ceilings
 * outwards until they meet or have gone as far as walls can be. So each face of a thin
 * partition lies in its own room. Rooms that lie above each other grow each in a layer
 * of its own, and a place is told by its height, too. O(cells of the box around all
 * rooms). */
class RoomTerritory {
public:
  /** @param scopes the cells of each room
   * @param heights of each room's lowest floor and highest ceiling; empty: no room lies
   * above another
   * @param reach how far rooms grow, metres */
  RoomTerritory(const CellGrid& grid,
                const std::vector<CellSet>& scopes,
                const std::vector<RoomHeights>& heights = {},
                double reach = wallReach(),
                const Priors& priors = {});

  /** @brief What is wrong, a sentence; empty if nothing is. */
  const std::string& problem() const { return problem_; }

  /** @brief Position in `scopes` of the room at `p`, -1 for none and for points not
   * finite. */
  std::int32_t roomAt(const Eigen::Vector3f& p) const;

  /** @brief The same of every point. O(n); `threads` 0: as many as there are
   * processors. */
  std::vector<std::int32_t> roomsAt(const PointView& points, unsigned threads) const;

  const CellGrid& grid() const { return grid_; }

  /** @brief The cells of one room that touch one of another, at a corner perhaps. */
  CellSet frontier() const;

private:
  /** @brief Rooms near each other. */
  struct Quarter {
    CellMask frame;
    std::vector<std::int32_t> room; ///< of each cell of the frame
  };

  /** @brief Rooms of which none lies above another. */
  using Layer = std::vector<Quarter>;

  bool addLayer(const std::vector<CellSet>& scopes,
                const std::vector<std::size_t>& rooms,
                int steps);

  std::int32_t roomIn(const Layer& layer, Cell cell) const;

  CellGrid grid_;
  double reach_;   ///< of a surface's noise, half of a slab, metres
  double outside_; ///< what counts for a place beside the room, metres
  double deepest_; ///< below a floor: steps; a mirror image is deeper
  std::vector<Layer> layers_;
  std::vector<CellSet> scopes_;      ///< kept where there are several layers
  std::vector<RoomHeights> heights_; ///< likewise
  std::string problem_;
};

} // namespace sedr
} // namespace pcl
