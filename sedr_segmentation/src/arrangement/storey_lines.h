// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../curves/plan_curve.h"
#include "../regions/storey_regions.h"
#include <pcl/sedr_filters/floorplan.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace pcl::sedr {

/** @brief A line or a circle on which walls of a storey may lie, and where its surface
 * was seen. Lengths in metres, along the curve. */
struct StoreyLine {
  static constexpr double bin = 0.05; ///< of what was seen

  /** @brief What is on a line where no surface was seen. */
  enum class Between : std::uint8_t {
    Gap, ///< between two parts of the surface: a door, a window, a cupboard before it
    Beyond, ///< near an end of the surface
    Nothing ///< farther away
  };

  PlanCurve curve;
  double from = 0;
  double to = 0;
  bool is_end = false; ///< no surface: there ends the air that was seen
  double parameters = 1;
  std::map<std::uint32_t, std::vector<float>>
      seen;                     ///< share explained, by room and bin
  std::vector<float> any;       ///< the most of them
  std::vector<Between> between; ///< of each bin

  /** @brief Returns how far along the curve the place nearest to `p` is. */
  double along(const Eigen::Vector2d& p) const;
  Eigen::Vector2d at(double s) const;

  /** @brief Returns how well a surface is explained at a place; -1 beyond the ends. */
  double seenAt(const Eigen::Vector2d& p) const;

  /** @brief Returns the length on which a surface was seen. */
  double support() const;
};

/** @brief Finds the lines of a storey: peaks of the offsets of its surfaces along the
 * main directions, other lines that are long, the arcs of outlines that are known, and
 * where seen air ends without a surface. Those with most surface come first.
 * O(surfaces x lines). */
std::vector<StoreyLine> storeyLines(const Storey& storey,
                                    const std::vector<RoomCells>& cells,
                                    const CellGrid& grid,
                                    const std::vector<PlanRoom>& rooms);

} // namespace pcl::sedr
