// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../grids/place_table.h"
#include "../plan/plan_surfaces.h"
#include "../plan/room_lookup.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief A cell of a room's surfaces and the point that represents it. */
struct SurfaceCell {
  SurfacePoint centre;
  bool is_occupied = false; ///< whether a scanned point lies in it
  std::size_t source = 0;   ///< index of the scanned point nearest to the centre
  double distance = 0;      ///< distance of that point from the centre, metres
};

/** @brief The surfaces of a room, divided into cells of nearly equal size. Vertical
 * surfaces are divided into equal parts along their elements and in height; floors,
 * ceilings, and bottoms and tops of niches by grids in plan. The cells cover the whole
 * room, so empty cells are its holes (paper, section 2.4). */
class SurfaceCells {
public:
  /** @brief The cells of a vertical surface: profiles along the element. */
  struct Strip {
    VerticalSurface surface;
    double length = 0;
    std::vector<std::size_t> first;  ///< first cell of each profile, then the end
    std::vector<VerticalSpan> spans; ///< heights of each profile
  };

  /** @param room must not move while this object exists
   * @param size edge of a cell, metres, > 0; surfaceCellsProblem() of the plan must be
   * empty */
  SurfaceCells(const PlanRoom& room, double size);

  /** @brief Assigns point `source` of the scan, already on the structure, to its cell.
   * @return false if the room has no such surface */
  bool occupy(const SurfacePoint& point, std::size_t source);

  /** @brief Returns all cells: vertical surfaces, then floor, ceiling and niches. */
  const std::vector<SurfaceCell>& cells() const { return cells_; }

  /** @brief Returns the first cell of each surface, in order, then the end. */
  const std::vector<std::size_t>& starts() const { return starts_; }

  /** @brief Returns the divided vertical surfaces; they point into the room. */
  const std::vector<Strip>& strips() const { return strips_; }

private:
  void addStrip(const VerticalSurface& surface);

  /** @brief The cells of a floor, ceiling or niche: a grid in plan, finer where steep.
   */
  struct Sheet {
    Eigen::Vector2d origin;
    std::size_t width = 0;
    std::size_t height = 0;
    std::vector<std::uint8_t> parts; ///< parts of each grid cell in x and in y
    std::vector<std::size_t> first;  ///< first entry of each grid cell in `cell`
    std::vector<std::size_t> cell;   ///< cell of each part, row by row, or `none`
  };

  /** @brief Appends the cells of a sheet inside `loop`. `pointAt(place, point)` gives
   * the surface point at a place, or returns false if there is none. */
  template <typename PointAt>
  void addSheet(const PlanLoop& loop, PointAt pointAt);

  void addSlabs();

  /** @brief Returns the cell of a sheet at a place, or `none`. */
  std::size_t cellOf(const Sheet& sheet, const Eigen::Vector2d& place) const;

  std::size_t findLevel(const SurfacePoint& point) const;

  std::size_t findVertical(const SurfacePoint& point) const;

  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  const PlanRoom& room_;
  RoomLookup lookup_;
  double size_;
  PlaceTable near_; ///< strips within one cell size
  std::vector<Strip> strips_;
  std::vector<SurfaceCell> cells_;
  std::vector<std::size_t> starts_{0};
  std::vector<Sheet> sheets_; ///< floor, ceiling, then bottom and top of each niche
};

} // namespace pcl::sedr
