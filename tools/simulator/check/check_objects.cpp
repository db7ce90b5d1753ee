// SPDX-License-Identifier: BSD-3-Clause
#include "problems.h"
#include "simulator/scan/scene_surfaces.h"
#include "simulator/scan/surface.h"
#include "simulator/scene/loop.h"
#include "simulator/truth/room_regions.h"

#include <algorithm>
#include <utility>

namespace pcl::sedr::sim {

namespace {

Loop
footprintOf(const Box& box)
{
  const Vec2 half{0.5 * box.size.x, 0.5 * box.size.y};
  Loop loop = rectangleLoop(-1.0 * half, half);
  for (LoopVertex& vertex : loop)
    vertex.position = plan(box.center) + rotated(vertex.position, box.yaw);
  return loop;
}

Loop
footprintOf(const Cylinder& cylinder)
{
  return circleLoop(plan(cylinder.base), cylinder.radius);
}

/** @brief Returns true if @p point is inside the box or cylinder. */
template <typename Part>
bool
holds(const Part& part, Vec3 point)
{
  const Bounds bounds = boundsOf(Shape{part});
  return point.z >= bounds.min.z && point.z <= bounds.max.z &&
         contains(footprintOf(part), plan(point));
}

bool
holds(const Object& object, Vec3 point)
{
  const auto holds_point = [point](const auto& part) { return holds(part, point); };
  return std::any_of(object.boxes.begin(), object.boxes.end(), holds_point) ||
         std::any_of(object.cylinders.begin(), object.cylinders.end(), holds_point);
}

/** @brief Returns the diagonal of the object's bounds in the plan. */
double
sizeOf(const Object& object)
{
  Rectangle bounds;
  bool is_first = true;
  const auto extend = [&](const auto& part) {
    const Bounds box = boundsOf(Shape{part});
    if (std::exchange(is_first, false))
      bounds = {plan(box.min), plan(box.max)};
    bounds.min = {std::min(bounds.min.x, box.min.x), std::min(bounds.min.y, box.min.y)};
    bounds.max = {std::max(bounds.max.x, box.max.x), std::max(bounds.max.y, box.max.y)};
  };
  for (const Box& box : object.boxes)
    extend(box);
  for (const Cylinder& cylinder : object.cylinders)
    extend(cylinder);
  return length(bounds.max - bounds.min);
}

class ObjectChecker {
public:
  ObjectChecker(const Scene& scene, Problems& problems)
      : scene_(scene)
      , problems_(problems)
  {}

  void run()
  {
    floor_voids_ = floorVoidsOf(scene_);
    for (const Object& object : scene_.furniture)
      checkFurniture(object);
    for (std::size_t i = 0; i < scene_.scanners.size(); ++i)
      for (std::size_t k = 0; k < scene_.scanners[i].stations.size(); ++k)
        checkStation(scene_.scanners[i].stations[k], i, k);
  }

private:
  void checkFurniture(const Object& object)
  {
    const double size = sizeOf(object);
    // Report an object once, not part by part.
    for (const Box& box : object.boxes)
      if (!checkPart(object, box, size))
        return;
    for (const Cylinder& cylinder : object.cylinders)
      if (!checkPart(object, cylinder, size))
        return;
  }

  template <typename... Parts>
  bool fail(const Object& object, const Parts&... parts)
  {
    const char* join = object.place.empty() ? "" : ": ";
    problems_.report(object.place, join, "the ", object.name, parts...);
    return false;
  }

  template <typename Part>
  bool checkPart(const Object& object, const Part& part, double size)
  {
    const Loop footprint = footprintOf(part);
    const Bounds bounds = boundsOf(Shape{part});
    const Vec3 center = 0.5 * (bounds.min + bounds.max);
    const std::uint32_t number = roomAt(scene_, center);
    if (number == 0)
      return fail(object, " at (", center.x, ", ", center.y, ") is in no room");
    const Room& room = scene_.rooms[number - 1];
    for (const Loop& column : room.columns)
      if (contains(footprint, column.front().position))
        return fail(object, " stands around a column");
    std::vector<Vec2> samples = samplesAlong(footprint);
    for (const Layer layer : {Layer::Floor, Layer::Ceiling})
      for (const SlabDetail& detail : detailsOf(room, layer))
        if (meet(boundsOf(detail.loop), boundsOf(footprint)))
          for (const Vec2 sample : samplesAlong(detail.loop, kContact))
            if (contains(footprint, sample))
              samples.push_back(sample);
    return std::all_of(samples.begin(), samples.end(), [&](Vec2 sample) {
      return checkSample(object, room, sample, bounds, size);
    });
  }

  /** @brief Checks that nothing obstructs the object at a point of a part's outline.
   * @param size of the object in the plan; on a slope it touches at its middle
   */
  bool checkSample(const Object& object,
                   const Room& room,
                   Vec2 sample,
                   const Bounds& bounds,
                   double size)
  {
    if (!isInRoom(room, sample))
      return fail(object, " meets a wall or column at (", sample.x, ", ", sample.y,
                  ")");
    const auto slack = [&](Layer layer) {
      const Slab& slab = slabOf(room, regionAt(room, sample, layer), layer);
      return kContact + 0.5 * size * length(slab.gradient);
    };
    if (bounds.min.z < floorBelow(room, sample) - slack(Layer::Floor) &&
        !isOverVoid(room, sample))
      return fail(object, " is below the floor at (", sample.x, ", ", sample.y, ")");
    if (bounds.max.z > ceilingAbove(room, sample) + slack(Layer::Ceiling) &&
        !isUnderVoid(room, sample))
      return fail(object, " is above the ceiling at (", sample.x, ", ", sample.y, ")");
    return true;
  }

  static bool isUnderVoid(const Room& room, Vec2 point)
  {
    return std::any_of(room.voids.begin(), room.voids.end(),
                       [point](const CeilingVoid& hole) {
                         return hole.leads_to && contains(hole.loop, point);
                       });
  }

  bool isOverVoid(const Room& room, Vec2 point) const
  {
    const auto& voids = floor_voids_[&room - scene_.rooms.data()];
    return std::any_of(voids.begin(), voids.end(),
                       [point](const Loop& loop) { return contains(loop, point); });
  }

  void checkStation(Vec3 station, std::size_t scanner, std::size_t index)
  {
    std::ostringstream text;
    text << placeOf("scanners", scanner) << ": station " << index << " at ("
         << station.x << ", " << station.y << ", " << station.z << ")";
    const std::string place = text.str();
    const std::uint32_t number = roomAt(scene_, station);
    if (number == 0 || !isInRoom(scene_.rooms[number - 1], plan(station)))
      return problems_.report(place, " is in no room");
    const Room& room = scene_.rooms[number - 1];
    if (station.z <= floorBelow(room, plan(station)) ||
        station.z >= ceilingAbove(room, plan(station)))
      problems_.report(place, " is not between floor and ceiling");
    for (const Object& object : scene_.furniture)
      if (holds(object, station))
        problems_.report(place, " is in the ", object.name);
  }

  const Scene& scene_;
  Problems& problems_;
  std::vector<std::vector<Loop>> floor_voids_; ///< of each room
};

} // namespace

void
checkObjects(const Scene& scene, Problems& problems)
{
  ObjectChecker(scene, problems).run();
}

} // namespace pcl::sedr::sim
