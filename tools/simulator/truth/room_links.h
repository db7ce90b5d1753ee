// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulator/scene/scene.h"

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::sedr::sim {

/** @brief A link between two rooms. Heights are z of the files, lengths in metres. */
struct RoomLink {
  std::string kind;       ///< door, passage, window; stairs, void
  std::uint32_t from = 0; ///< room, from 1; of stairs and voids: the lower one
  std::uint32_t to = 0;   ///< room, from 1
  Loop loop;              ///< plan of the hole in the slab; empty for openings
  Vec2 start;             ///< start of an opening on the wall's face in room `from`
  Vec2 end;               ///< its end
  double width = 0.0;     ///< of an opening
  double bottom = 0.0;    ///< z of the sill, or of the lower ceiling
  double top = 0.0;       ///< z of the head, or of the upper floor
  double lintel = 0.0;    ///< from an opening's head to the lower of both ceilings
  bool is_shut = false;   ///< a door with its leaf in the opening, or a pane
};

/** @brief Returns all openings between two rooms, and all voids between a room and one
 * above.
 *
 * An opening whose sill is at least 0.3 m above both floors is a window. Others are
 * doors up to 1.3 m wide and passages beyond. A void where stairs end has kind stairs.
 * @throw std::invalid_argument as openingsByRoom()
 */
std::vector<RoomLink> roomLinks(const Scene& scene);

} // namespace pcl::sedr::sim
