// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulator/scene/scene.h"

#include <utility>

/** @file Small scenes whose measures are known in closed form. */

namespace pcl::sedr::sim::test {

/** @brief Returns a room of @p width x @p depth x @p height with its corner at the
 * origin. */
inline Room
makeBoxRoom(double width, double depth, double height)
{
  Room room;
  room.name = "box";
  room.outline = rectangleLoop({0.0, 0.0}, {width, depth});
  room.ceiling.height = height;
  return room;
}

/** @brief Returns a scene of one room, scanned from one station without noise. */
inline Scene
makeScene(Room room, Vec3 station, std::size_t rays)
{
  Scene scene;
  scene.name = "sample";
  scene.rooms.push_back(std::move(room));
  Scanner scanner;
  scanner.stations = {station};
  scanner.rays_per_station = rays;
  scene.scanners.push_back(scanner);
  return scene;
}

} // namespace pcl::sedr::sim::test
