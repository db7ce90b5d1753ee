// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_filters/src/grids/cell_table.h"
#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief A part of a vertical surface of constant height. */
struct RefitStretch {
  std::size_t curve = 0;
  PlanElement part; ///< away from corners
  double low = 0;
  double high = 0;
};

/** @brief A slab and the rectangle of its patches. */
struct RefitSlab {
  PlanSlab* slab = nullptr;
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  std::size_t parent = 0; ///< slab with the same direction
  Eigen::Vector2d half =
      Eigen::Vector2d::Zero(); ///< half extents of its loop around the centre
  double width = 0;            ///< minimum width of its loop, metres
  std::size_t along = 0;       ///< patches along x
  std::size_t rows = 0;        ///< patches along y
};

/** @brief Slabs above and below the cells of a room, -1 for none and near edges. */
struct RefitRoomMap {
  double cell = 0.05;
  Eigen::Vector2d low = Eigen::Vector2d::Zero();
  std::int32_t width = 0;
  std::int32_t height = 0;
  std::vector<std::int32_t> ceiling;
  std::vector<std::int32_t> floor;

  /** @brief Returns the slabs above and below a position, -1 for none. */
  std::array<std::int32_t, 2> slabsAt(const Eigen::Vector2d& p) const
  {
    const Eigen::Vector2d at = (p - low) / cell;
    if (at.x() < 0 || at.y() < 0 || at.x() >= width || at.y() >= height)
      return {-1, -1};
    const auto i = static_cast<std::size_t>(at.y()) * static_cast<std::size_t>(width) +
                   static_cast<std::size_t>(at.x());
    return {ceiling[i], floor[i]};
  }
};

/** @brief The bottom and top of a niche. */
struct RefitNiche {
  const PlanNiche* niche = nullptr;
  std::size_t bottom = 0;
  std::size_t top = 0;
};

/** @brief Spatial index of the surfaces of a plan, by the cells of their points. */
struct RefitPlaces {
  static constexpr double table_cell = 0.2; ///< metres

  std::vector<RefitStretch> stretches;
  std::vector<RefitSlab> slabs;
  std::vector<RefitRoomMap> rooms;
  std::vector<RefitNiche> niches;
  CellTable stretches_near{table_cell};
  CellTable rooms_near{table_cell};
  CellTable niches_near{table_cell};

  /** @brief Step along stretches and slabs, metres; so much beyond `reach` all points
   * near a stretch are its. */
  static constexpr double step = 0.05;

  /** @brief Adds the map of a room; `ceiling` and `floor` are its main slabs' numbers.
   */
  void addRoom(const PlanRoom& room,
               std::size_t ceiling,
               std::size_t floor,
               unsigned threads);

  /** @brief Sorts stretches (within `reach` metres), rooms and niches by cells.
   * @return the reason for a failure, a sentence; else empty */
  std::string tabulate(double reach);
};

/** @brief Returns the minimum extent of a loop perpendicular to any element's chord. */
double widthOf(const PlanLoop& loop);

} // namespace pcl::sedr
