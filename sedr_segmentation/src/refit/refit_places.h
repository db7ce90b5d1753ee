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

namespace pcl {
namespace sedr {

/** @brief A part of an upright surface with one height. */
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
  std::size_t parent = 0; ///< whose direction it has
  Eigen::Vector2d half =
      Eigen::Vector2d::Zero(); ///< extent of its loop about the middle
  double width = 0;            ///< of its loop, where that is narrowest, metres
  std::size_t along = 0;       ///< patches along x
  std::size_t rows = 0;        ///< patches along y
};

/** @brief Which slabs are above and below the cells of a room, -1 none, away from
 * edges. */
struct RefitRoomMap {
  double cell = 0.05;
  Eigen::Vector2d low = Eigen::Vector2d::Zero();
  std::int32_t width = 0;
  std::int32_t height = 0;
  std::vector<std::int32_t> ceiling;
  std::vector<std::int32_t> floor;

  /** @brief The slabs above and below a place, -1 none. */
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

/** @brief Where the surfaces of a plan are: by the cells that they may be seen in. */
struct RefitPlaces {
  static constexpr double table_cell = 0.2; ///< metres

  std::vector<RefitStretch> stretches;
  std::vector<RefitSlab> slabs;
  std::vector<RefitRoomMap> rooms;
  std::vector<RefitNiche> niches;
  CellTable stretches_near{table_cell};
  CellTable rooms_near{table_cell};
  CellTable niches_near{table_cell};

  /** @brief Adds the map of a room, `ceiling` and `floor` being the numbers of its own
   * slabs. */
  void addRoom(const PlanRoom& room,
               std::size_t ceiling,
               std::size_t floor,
               unsigned threads);

  /** @brief Sorts stretches, rooms and niches by cells; stretches are seen from
   * `reach` metres.
   * @return why that cannot be done, a sentence; empty otherwise */
  std::string tabulate(double reach);
};

/** @brief Smallest box around a loop, which must not be empty. */
std::pair<Eigen::Vector2d, Eigen::Vector2d> boundsOf(const PlanLoop& loop);

/** @brief The least extent of a loop square to any of its elements' chords. */
double widthOf(const PlanLoop& loop);

} // namespace sedr
} // namespace pcl
