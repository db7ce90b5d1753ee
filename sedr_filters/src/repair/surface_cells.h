// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../grids/place_table.h"
#include "../plan/plan_surfaces.h"
#include "../plan/room_lookup.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief A cell of a room's surfaces, and the point that stands for it. */
struct SurfaceCell {
  SurfacePoint centre;
  bool is_occupied = false; ///< whether a scanned point lies in it
  std::size_t source = 0;   ///< that point, the one nearest to the centre
  double distance = 0;      ///< of it from the centre, metres
};

/** @brief The surfaces of a room cut into cells of nearly one size: upright surfaces
 * along their elements and up their heights, each into equal parts; floors, ceilings
 * and the bottoms and tops of niches by grids in plan. The cells cover the whole room
 * without gaps, so the empty ones are its holes (paper, section 2.4). */
class SurfaceCells {
public:
  /** @brief Cells of an upright surface: column after column along the element. */
  struct Strip {
    UprightSurface surface;
    double length = 0;
    std::vector<std::size_t> first; ///< cell of each column, and one past the last
    std::vector<UprightSpan> spans; ///< of each column
  };

  /** @param room must stay where it is
   * @param size edge of a cell, metres, > 0; surfaceCellsProblem() of the plan must be
   * empty */
  SurfaceCells(const PlanRoom& room, double size);

  /** @brief Says that point `source` of the scan, on the structure already, lies in its
   * cell.
   * @return false where the room has no such surface */
  bool occupy(const SurfacePoint& point, std::size_t source);

  /** @brief All cells: upright surfaces, then floor, then ceiling, then niches. */
  const std::vector<SurfaceCell>& cells() const { return cells_; }

  /** @brief The first cell of each surface, in the order of the cells, and one past the
   * last. */
  const std::vector<std::size_t>& starts() const { return starts_; }

  /** @brief The upright surfaces as they were cut; they point into the room. */
  const std::vector<Strip>& strips() const { return strips_; }

private:
  void addStrip(const UprightSurface& surface);

  /** @brief Cells of a level surface: a grid in plan, finer where the surface is steep.
   */
  struct Sheet {
    Eigen::Vector2d origin;
    std::size_t width = 0;
    std::size_t height = 0;
    std::vector<std::uint8_t> parts; ///< of each cell of the grid, to each side
    std::vector<std::size_t> first;  ///< of each cell of the grid, in `cell`
    std::vector<std::size_t> cell;   ///< of each part, row by row, or none
  };

  /** @brief Appends the cells of a sheet over the inside of `loop`: `pointAt(place,
   * point)` gives the surface there, or says that there is none. */
  template <typename PointAt>
  void addSheet(const PlanLoop& loop, PointAt pointAt);

  void addSlabs();

  /** @brief The cell of a sheet at a place, or none. */
  std::size_t cellOf(const Sheet& sheet, const Eigen::Vector2d& place) const;

  std::size_t findLevel(const SurfacePoint& point) const;

  std::size_t findUpright(const SurfacePoint& point) const;

  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  const PlanRoom& room_;
  RoomLookup lookup_;
  double size_;
  PlaceTable near_; ///< the strips within a cell's size
  std::vector<Strip> strips_;
  std::vector<SurfaceCell> cells_;
  std::vector<std::size_t> starts_{0};
  std::vector<Sheet> sheets_; ///< floor, ceiling, then bottom and top of each niche
};

} // namespace sedr
} // namespace pcl
