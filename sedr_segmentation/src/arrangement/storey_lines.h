// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../faces/storeys.h"
#include "face_curves.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace pcl::sedr {

/** @brief A line or a circle on which walls of a storey may lie, and where its surface
 * was seen. Lengths in metres, along the curve. */
struct StoreyLine : FaceCurve {
  /** @brief What is on a line where no surface was seen. */
  enum class Between : std::uint8_t {
    Partly, ///< below or above it goes on, as at a window or a door
    Gap,    ///< between two parts of the surface: a passage, a cupboard before it
    Beyond, ///< near an end of the surface, or from there to a corner
    Nothing ///< farther away
  };

  bool is_end = false; ///< no surface: air that was seen ends there, or a face does
  double parameters = 1;
  double near = 0.03; ///< maximum distance of its surfaces
  std::map<std::uint32_t, std::vector<float>>
      seen;                         ///< share explained, by room and bin
  std::vector<float> any;           ///< the most of them
  std::vector<float> tall;          ///< the same where it reaches up to the ceiling
  std::vector<Between> between;     ///< of each bin where it does not
  std::vector<std::uint8_t> is_own; ///< in each bin: no better line has its surface
  std::vector<double> edges; ///< where the surface begins or ends, along the curve

  /** @brief Returns how well a surface is explained at a place; -1 beyond the ends. */
  double seenAt(const Eigen::Vector2d& p) const;

  /** @brief Returns the length on which a surface was seen. */
  double support() const;
};

/** @brief The lines of a storey. */
struct StoreyLines {
  std::vector<StoreyLine> lines;
  double certainty = 0; ///< nats a metre of surface, that it is a wall's
};

/** @brief Finds the lines of a storey: those of its faces, where seen air ends without
 * one, and across the ends of faces. Those with most surface come first.
 * @param near distance of surfaces from their line, metres */
StoreyLines storeyLines(const Storey& storey,
                        const std::vector<RoomCells>& cells,
                        const CellGrid& grid,
                        const RadiusRange& radii,
                        double near);

} // namespace pcl::sedr
