// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "json_view.h"
#include "simulator/scene/furniture.h"

#include <string>
#include <vector>

namespace pcl::sedr::sim {

/** @brief Where the coordinates of a list of objects are counted from. */
struct ObjectFrame {
  Vec2 origin;
  double yaw = 0.0; ///< radians, counter-clockwise

  Vec2 operator()(Vec2 point) const { return origin + rotated(point, yaw); }
};

/** @brief Tells where the things in a room, or outside, stand and hang. */
class ObjectPlaces {
public:
  /** @param room null for the outside */
  explicit ObjectPlaces(const Room* room)
      : room_(room)
  {}

  /** @brief The same room, coordinates counted from @p place within this frame.
   *
   * Things that belong together stand where they are put, not at walls.
   */
  ObjectPlaces within(const ObjectFrame& place) const;

  /** @brief The keys that say where something stands. */
  std::vector<std::string> keysOfSpots() const;

  /** @brief Where something of that footprint stands: one spot, or a row of them. */
  std::vector<Spot> spotsOf(const JsonView& view, double width, double depth) const;

  /** @brief z of the floor under @p point, which is already in the scene's frame. */
  double floorAt(const JsonView& view, Vec2 point) const;

  /** @brief z of the ceiling above @p point. */
  double ceilingAt(const JsonView& view, Vec2 point) const;

  /** @brief A point of the list's frame in that of the scene. */
  Vec2 toScene(Vec2 point) const { return frame_(point); }

  /** @brief A point of the file in the scene's frame. */
  Vec2 pointOf(const JsonView& view) const { return frame_(view.point2()); }

  /** @brief An angle of the file, in degrees, as radians in the scene's frame. */
  double yawOf(const JsonView& view, const std::string& key = "yaw") const;

private:
  std::vector<Spot> spotsAtWall(const JsonView& view, double width, double depth) const;

  void requireWithin(const JsonView& view, Vec2 point) const;

  const Room* room_;
  ObjectFrame frame_;
  bool is_group_ = false;
};

} // namespace pcl::sedr::sim
