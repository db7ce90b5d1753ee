// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulator/scene/scene.h"

#include <nlohmann/json.hpp>

#include <string>

namespace pcl::sedr::sim {

using Json = nlohmann::ordered_json;

/** @brief Returns a point as [x, y]. */
Json toJson(const Vec2& point);

/** @brief Returns a loop as a list of elements as in a floor plan: type, start
 * and end; of arcs also centre, radius and counter_clockwise. */
Json toJson(const Loop& loop);

/** @brief Returns the doors, windows and passages of a scene, in the frame of
 * the files: see doc/pcl_simulate_indoor_scan.md.
 *
 * Kinds: an opening whose sill is at least 0.3 m above both floors is a window.
 * Others are doors up to 1.3 m wide and passages beyond.
 * @throw std::invalid_argument as openingsByRoom() */
Json openingsToJson(const Scene& scene);

/** @brief Returns what joins two rooms: openings between them, and voids
 * between a room and one above. A void where stairs end has kind stairs.
 * @param openings openingsToJson() */
Json linksToJson(const Scene& scene, const Json& openings);

} // namespace pcl::sedr::sim
