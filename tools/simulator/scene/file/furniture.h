// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "json_view.h"
#include "simulator/scene/scene.h"

#include <cstddef>
#include <string>
#include <vector>

namespace pcl::sedr::sim {

/** @brief Reads a list of objects; the only key of each is its kind.
 *
 * @param list elements such as {"table": {"at": [x, y], "size": [w, d, h]}}; the kinds
 * and their keys are in doc/pcl_simulate_indoor_scan.md
 * @param room provides floor, ceiling and walls; null for the outside, where objects
 * cannot stand at walls and the key "floor" gives the height of their feet */
std::vector<Object> readObjects(const std::vector<JsonView>& list, const Room* room);

/** @brief Returns the index, from 0, of the room that @p view names. */
std::size_t roomNamed(const JsonView& view, const Scene& scene);

/** @brief Reads where a niche or opening is in its wall; without a sill it begins at
 * the floor. */
WallGap readGap(const JsonView& view, const Room& room);

/** @brief Adds an opening to a room, and its leaf and lobby to the scene's objects.
 *
 * The names of all rooms of @p scene must be known. */
void readOpening(const JsonView& view, std::size_t room, Scene& scene);

/** @brief Adds the rooms of a list, with furniture and the lobbies behind doors.
 *
 * Openings may lead to any room of the list, by name. */
void readRooms(const JsonView& list, Scene& scene);

/** @brief Position and direction of an object: the middle of its footprint. At yaw 0
 * the width runs along x, the depth along y, and the front faces -y. */
struct Spot {
  Vec2 center = Vec2::Zero();
  double yaw = 0.0; ///< radians, counter-clockwise
  double z = 0.0;   ///< of its feet; of what hangs, of the ceiling above it
};

/** @brief An object under construction; its parts are relative to its spot. */
class Assembly {
public:
  Assembly(std::string name, const Spot& spot);

  /** @brief Adds a box by its lower and upper corner. */
  void addBox(const Vec3& low, const Vec3& high);

  /** @brief Adds a box by its centre, turned about z. */
  void addBox(const Vec3& center, const Vec3& size, double yaw);

  /** @brief Adds a cylinder in facets within kCurveTolerance. */
  void addCylinder(const Vec3& base, double radius, double height);

  /** @brief Returns the width and depth of all parts. */
  Vec2 footprint() const;

  Object object;

private:
  Vec3 moved(const Vec3& point) const;

  Spot spot_;
};

/** @brief The name of every flight of stairs. */
constexpr const char* kStairs = "stairs";

} // namespace pcl::sedr::sim
