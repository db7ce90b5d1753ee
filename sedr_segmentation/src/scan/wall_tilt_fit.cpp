// SPDX-License-Identifier: BSD-3-Clause
#include "wall_tilt_fit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pcl::sedr {

namespace {

/** @brief Returns the tilted face that most of a wall is on, null if there is none;
 * `sign` is 1 or -1 for equal or opposite directions. */
const TiltedFace*
faceBehind(const PlanElement& wall, const std::vector<TiltedFace>& faces, double& sign)
{
  constexpr double near = 0.1; // metres
  constexpr double min_cosine = 0.99;
  if (wall.isArc())
    return nullptr;
  const TiltedFace* behind = nullptr;
  double longest = 0;
  for (const TiltedFace& face : faces) {
    const Eigen::Vector2d way = (face.end - face.start).normalized();
    const Eigen::Vector2d left(-way.y(), way.x());
    const double cosine = way.dot((wall.end - wall.start).normalized());
    const auto [first, last] = std::minmax(
        {(wall.start - face.start).dot(way), (wall.end - face.start).dot(way)});
    const double from = std::max(first, 0.0);
    const double to = std::min(last, (face.end - face.start).norm());
    const Eigen::Vector2d middle = face.start + (from + to) / 2 * way;
    const double off = std::abs(
        (wall.pointAt(std::abs((middle - wall.start).dot(way))) - middle).dot(left));
    if (face.run == 0 || std::abs(cosine) < min_cosine || off >= near ||
        to - from <= longest)
      continue;
    behind = &face;
    longest = to - from;
    sign = cosine > 0 ? 1 : -1;
  }
  return behind;
}

void
moveDetails(const Straightening& map, PlanRoom& room)
{
  const auto move = [&](PlanLoop& loop, const PlanSlab& slab) {
    for (PlanElement& element : loop.elements)
      for (Eigen::Vector2d* end : {&element.start, &element.end})
        if (!element.isArc())
          *end = map.back({end->x(), end->y(), slab.heightAt(*end)}).head<2>();
  };
  for (auto* const details : {&room.details, &room.floor_details})
    for (PlanDetail& detail : *details) {
      move(detail.boundary, detail.slab);
      for (PlanLoop& hole : detail.holes)
        move(hole, detail.slab);
    }
}

} // namespace

void
tiltWalls(const Straightening& map,
          const std::vector<TiltedFace>& faces,
          Floorplan& plan)
{
  for (PlanRoom& room : plan.rooms) {
    auto& walls = room.boundary.elements;
    std::vector<bool> is_moved(walls.size(), false);
    for (std::size_t i = 0; i < walls.size(); ++i) {
      PlanElement& wall = walls[i];
      double sign = 1;
      const TiltedFace* const face = faceBehind(wall, faces, sign);
      if (!face)
        continue;
      const double floor = room.floor.heightAt(wall.pointAt(wall.length() / 2));
      const Eigen::Vector2d out = -wall.normalAt(0);
      const Eigen::Vector2d foot = sign * face->run * (face->head - floor) * out;
      wall.start += foot;
      wall.end += foot;
      is_moved[i] = true;
      wall.tilt = std::atan(sign * face->run);
    }
    if (std::find(is_moved.begin(), is_moved.end(), true) == is_moved.end())
      continue;
    moveDetails(map, room);
    rejoin(room.boundary, is_moved);
  }
}

} // namespace pcl::sedr
