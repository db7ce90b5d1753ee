// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "json_view.h"
#include "simulator/scene/furniture.h"

#include <string>
#include <vector>

namespace pcl::sedr::sim {

/** @brief The frame in which the coordinates of a list of objects are given. */
struct ObjectFrame {
  Vec2 origin;
  double yaw = 0.0; ///< radians, counter-clockwise

  Vec2 operator()(Vec2 point) const { return origin + rotated(point, yaw); }
};

/** @brief Computes the positions of objects in a room or outside. */
class ObjectPlaces {
public:
  /** @param room null for the outside */
  explicit ObjectPlaces(const Room* room)
      : room_(room)
  {}

  /** @brief Returns the places of a group: @p place, given in this frame, as new frame.
   *
   * Objects of a group cannot refer to walls.
   */
  ObjectPlaces within(const ObjectFrame& place) const;

  /** @brief Returns the keys that define a position. */
  std::vector<std::string> keysOfSpots() const;

  /** @brief Returns the spots of an object with this footprint: one, or a row. */
  std::vector<Spot> spotsOf(const JsonView& view, double width, double depth) const;

  /** @brief Returns z of the floor below @p point, which is in the scene's frame. */
  double floorAt(const JsonView& view, Vec2 point) const;

  /** @brief Returns z of the ceiling above @p point, which is in the scene's frame. */
  double ceilingAt(const JsonView& view, Vec2 point) const;

  /** @brief Transforms a point from the list's frame to the scene's. */
  Vec2 toScene(Vec2 point) const { return frame_(point); }

  /** @brief Reads a point of the file and transforms it to the scene's frame. */
  Vec2 pointOf(const JsonView& view) const { return frame_(view.point2()); }

  /** @brief Reads an angle in degrees; returns radians in the scene's frame. */
  double yawOf(const JsonView& view, const std::string& key = "yaw") const;

private:
  std::vector<Spot> spotsAtWall(const JsonView& view, double width, double depth) const;

  void requireWithin(const JsonView& view, Vec2 point) const;

  const Room* room_;
  ObjectFrame frame_;
  bool is_group_ = false;
};

} // namespace pcl::sedr::sim
