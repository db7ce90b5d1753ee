// SPDX-License-Identifier: BSD-3-Clause
#include "scene_parts.h"

#include "simulator/scan/scene_surfaces.h"
#include "simulator/scan/walk.h"
#include "simulator/truth/room_regions.h"

namespace pcl::sedr::sim {

namespace {

constexpr std::size_t kMostStations = 10'000;
constexpr std::size_t kMostRays = 100'000'000;
constexpr double kLowest = -1e5; ///< below every room

/** @brief Reads stations along a path, at a height above the floor below them. */
std::vector<Vec3>
readWalk(const JsonView& view, const Scene& scene)
{
  view.allowOnly({"path", "count", "height", "sway", "floor"});
  std::vector<Vec2> path;
  for (const JsonView& corner : view.at("path").items(2))
    path.push_back(corner.point2());
  const std::size_t count = view.at("count").count(1, kMostStations);
  auto stations =
      walkAlong(path, count, view.at("height").size(), view.numberOr("sway", 0.0));
  const double floor = view.numberOr("floor", kLowest);
  for (Vec3& station : stations)
    if (const std::uint32_t room = roomAt(scene, lifted(plan(station), floor)))
      station.z += floorBelow(scene.rooms[room - 1], plan(station));
  return stations;
}

std::vector<Vec3>
readStations(const JsonView& view, const Scene& scene)
{
  const auto list = view.find("stations");
  const auto walk = view.find("walk");
  if (list.has_value() == walk.has_value())
    view.fail("must have either \"stations\" or a \"walk\"");
  if (walk)
    return readWalk(*walk, scene);
  std::vector<Vec3> stations;
  for (const JsonView& station : list->items(1))
    stations.push_back(station.point3());
  if (stations.size() > kMostStations)
    list->fail("has more than " + std::to_string(kMostStations) + " stations");
  return stations;
}

} // namespace

Scanner
readScanner(const JsonView& view, const Scene& scene)
{
  view.allowOnly(
      {"stations", "walk", "rays", "min_elevation", "jitter", "max_range", "noise"});
  Scanner scanner;
  scanner.stations = readStations(view, scene);
  scanner.rays_per_station = view.at("rays").count(1, kMostRays);
  if (const auto elevation = view.find("min_elevation"))
    scanner.min_elevation = elevation->number(-90.0, 89.0);
  if (const auto jitter = view.find("jitter"))
    scanner.jitter = jitter->number(0.0, 1.0);
  if (const auto range = view.find("max_range"))
    scanner.max_range = range->size();
  scanner.noise = view.at("noise").number(0.0, 1.0);
  return scanner;
}

} // namespace pcl::sedr::sim
