// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/impl/cell_grid.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/priors.h>
#include <pcl/sedr_segmentation/building.h>

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace pcl::sedr {

/** @brief The free height of a room over a cell of the plan, metres. */
struct RoomGap {
  Cell cell;
  std::uint32_t room = 0; ///< number of the room, from 1
  float low = 0;          ///< height of the floor, or of what stands on it
  float high = 0;         ///< height of the ceiling there
  float lowest = 0; ///< height of the room's floor: `low` may be that of furniture
};

/** @brief Returns the maximum distance in plan of a room's walls from its ceiling,
 * metres: the maximum wall thickness and a margin for noise. */
inline double
wallReach(const Priors& priors = {})
{
  return priors.max_wall + priors.surface_band;
}

/** @brief The gaps of all rooms of a building, several a cell, and which of them owns a
 * point: the nearest one in space with no other between. Around the rooms their gaps
 * spread step by step, each at its own heights, until they meet or reach the farthest
 * point of a niche; within two cells of a gap the nearest one decides. So each face of
 * a thin partition belongs to the room where its air is, whether the other face was
 * seen or not, and rooms above each other take no points of each other. */
class RoomGaps {
public:
  /** @brief O(gaps and cells around them).
   * @param gaps of two at the same heights of a cell the first one counts */
  RoomGaps(const CellGrid& grid,
           const std::vector<RoomGap>& gaps,
           const Priors& priors = {});

  /** @brief Returns the owner of a place; none for non-finite ones. O(1). */
  PointOwner ownerOf(const Eigen::Vector3f& p) const;

  /** @brief Returns the owner of every point. O(n); `threads` 0: all processors. */
  std::vector<PointOwner> ownersOf(const PointView& points, unsigned threads) const;

private:
  /** @brief A gap in its cell, or a cell around it. */
  struct Span {
    float low;
    float high;
    float lowest;
    std::uint32_t room;
    std::uint32_t steps; ///< from the gap, cells
    std::int32_t next;   ///< of the same cell; none: -1
  };

  static constexpr int edge = 32;                     // cells of a tile
  using Tile = std::array<std::int32_t, edge * edge>; ///< first span of each cell

  const Tile* tileAt(Cell cell) const;
  static std::size_t withinTile(Cell cell);
  template <typename Visit>
  void forEachSpan(Cell cell, Visit visit) const;
  bool add(Cell cell, const Span& span);
  void spread(int steps);

  CellGrid grid_;
  double above_;   ///< farthest that a point is above its gap, metres
  double below_;   ///< likewise below the floor; reflections are deeper
  int wall_steps_; ///< beyond them there are only niches
  std::unordered_map<CellKey, Tile> tiles_;
  std::vector<Span> spans_;
  std::vector<Cell> cells_; ///< of the spans
};

/** @brief Returns the gaps of all rooms of a building, a cell of `grid` each: from the
 * ceiling, or where none was seen the end of the profile there, down to the floor of
 * the profile, beside a wall of the nearest one.
 * @param building with the labels of the points */
std::vector<RoomGap>
gapsOf(const Building& building, const PointView& points, const CellGrid& grid);

} // namespace pcl::sedr
