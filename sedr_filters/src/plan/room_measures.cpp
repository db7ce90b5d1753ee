// SPDX-License-Identifier: BSD-3-Clause
#include "plan_bounds.h"
#include "room_lookup.h"
#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_filters/straightening.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace pcl::sedr {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/** @brief A ray in plan. */
struct Ray {
  Eigen::Vector2d from;
  Eigen::Vector2d way; ///< unit
};

/** @brief Returns the distance at which a ray meets an element, above `least` metres;
 * infinite if it does not. */
double
distanceAlong(const Ray& ray, const PlanElement& e, double least)
{
  constexpr double on_element = 1e-6;
  double nearest = infinity;
  const auto consider = [&](double t) {
    if (t > least && t < nearest && e.distance(ray.from + t * ray.way) < on_element)
      nearest = t;
  };
  if (e.isArc()) {
    const Eigen::Vector2d to_centre = e.centre - ray.from;
    const double middle = to_centre.dot(ray.way);
    const double square =
        e.radius * e.radius - to_centre.squaredNorm() + middle * middle;
    if (square >= 0)
      for (const double side : {-1.0, 1.0})
        consider(middle + side * std::sqrt(square));
    return nearest;
  }
  const Eigen::Vector2d along = e.end - e.start;
  const double across = ray.way.x() * along.y() - ray.way.y() * along.x();
  if (std::abs(across) > 1e-12) {
    const Eigen::Vector2d to_start = e.start - ray.from;
    consider((to_start.x() * along.y() - to_start.y() * along.x()) / across);
  }
  return nearest;
}

/** @brief Returns the distance from a place of a boundary through its wall to a
 * parallel face; infinite if the first face behind it is not parallel. */
double
thicknessAt(const std::vector<const PlanRoom*>& rooms,
            const PlanElement& element,
            double s,
            double most)
{
  constexpr double parallel = 0.996; // cosine of 5 degrees
  constexpr double least = 0.005;    // below any thickness: this is the face itself
  const Eigen::Vector2d inward = element.normalAt(s);
  const Ray ray{element.pointAt(s), -inward};
  double nearest = most;
  double thickness = infinity;
  for (const PlanRoom* room : rooms)
    for (const PlanElement& face : room->boundary.elements) {
      const double t = distanceAlong(ray, face, least);
      if (t > nearest)
        continue;
      nearest = t;
      const double facing =
          -inward.dot(face.normalAt(face.project(ray.from + t * ray.way)));
      thickness = facing > parallel ? t : infinity;
    }
  return thickness;
}

/** @brief Returns the volume of a room with tilted walls, by samples. */
double
volumeBetweenTiltedWalls(const PlanRoom& room)
{
  constexpr double step = 0.05;
  const auto [low, high] = heightsOf(room);
  Eigen::AlignedBox2d box = boundsOf(room.boundary);
  box.extend(boundsOf(boundaryAt(room, std::max(high, headOf(room)))));
  std::size_t count = 0;
  for (double z = low + step / 2;; z += step) {
    const PlanLoop section = boundaryAt(room, z);
    const LoopLookup lookup(section);
    const std::size_t before = count;
    for (double y = box.min().y() + step / 2; y < box.max().y(); y += step)
      for (double x = box.min().x() + step / 2; x < box.max().x(); x += step) {
        const Eigen::Vector2d p(x, y);
        const bool is_air =
            lookup.contains(p) && z < room.ceilingAt(p) && z > room.floorAt(p) &&
            std::none_of(room.columns.begin(), room.columns.end(),
                         [&](const PlanLoop& c) { return c.contains(p); });
        count += is_air ? 1 : 0;
      }
    if (count == before)
      return static_cast<double>(count) * step * step * step;
  }
}

} // namespace

ClearHeight
clearHeight(const PlanRoom& room)
{
  constexpr double usual_step = 0.05;
  constexpr double max_samples = 1e6;
  Eigen::AlignedBox2d box;
  for (const auto& corner : room.boundary.polygon(0.01))
    box.extend(corner);
  ClearHeight found;
  if (box.isEmpty())
    return found;
  const double step = std::max(usual_step, std::sqrt(box.volume() / max_samples));
  const RoomLookup lookup(room);
  std::vector<double> heights;
  for (double y = box.min().y() + step / 2; y < box.max().y(); y += step)
    for (double x = box.min().x() + step / 2; x < box.max().x(); x += step) {
      const Eigen::Vector2d p(x, y);
      if (!lookup.contains(p))
        continue;
      const double height = lookup.ceilingAt(p) - lookup.floorAt(p);
      if (heights.empty() || height < found.least) {
        found.least = height;
        found.lowest = p;
      }
      found.mean += height;
      heights.push_back(height);
    }
  if (heights.empty())
    return found;
  found.mean /= static_cast<double>(heights.size());
  const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
  std::nth_element(heights.begin(), middle, heights.end());
  found.usual = *middle;
  return found;
}

double
volumeOf(const PlanRoom& room, double mean_height)
{
  double volume =
      isTilted(room) ? volumeBetweenTiltedWalls(room) : mean_height * room.area();
  for (const PlanNiche& niche : room.niches) {
    const Eigen::Vector2d somewhere = niche.boundary.elements.front().pointAt(0);
    volume += niche.boundary.area() *
              (niche.top.heightAt(somewhere) - niche.bottom.heightAt(somewhere));
  }
  return volume;
}

double
wallThickness(const Floorplan& plan, std::size_t room, std::size_t element, double most)
{
  constexpr double step = 0.1;
  constexpr double min_share = 0.2;
  const PlanElement& wall = plan.rooms[room].boundary.elements[element];
  const double length = wall.length();
  const std::vector<const PlanRoom*> rooms = roomsAt(plan, heightsOf(plan.rooms[room]));
  const auto samples = static_cast<std::size_t>(std::clamp(length / step, 3.0, 1000.0));
  std::vector<double> found;
  for (std::size_t i = 0; i < samples; ++i) {
    const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(samples);
    const double thickness = thicknessAt(rooms, wall, share * length, most);
    if (thickness < infinity)
      found.push_back(thickness);
  }
  if (static_cast<double>(found.size()) < min_share * static_cast<double>(samples))
    return 0;
  const auto middle =
      found.begin() + static_cast<std::ptrdiff_t>((found.size() - 1) / 2);
  std::nth_element(found.begin(), middle, found.end());
  return *middle;
}

std::vector<OpeningLeaf>
leavesOf(const PlanOpening& opening)
{
  std::vector<OpeningLeaf> leaves;
  const Eigen::Vector2d way = opening.end - opening.start;
  const double side = opening.swing == opening.rooms[0] ? 1 : -1;
  const Eigen::Vector2d into = side * Eigen::Vector2d(-way.y(), way.x());
  const Eigen::Vector2d face = opening.depth / 2 * into.normalized();
  const double share = opening.hinge == OpeningHinge::Both ? 0.5 : 1;
  if (opening.hinge == OpeningHinge::Start || opening.hinge == OpeningHinge::Both)
    leaves.push_back({opening.start + face, opening.start + face + share * way,
                      opening.start + face + share * into});
  if (opening.hinge == OpeningHinge::End || opening.hinge == OpeningHinge::Both)
    leaves.push_back({opening.end + face, opening.end + face - share * way,
                      opening.end + face + share * into});
  return leaves;
}

} // namespace pcl::sedr
