// SPDX-License-Identifier: BSD-3-Clause
#include "problems.h"

#include <algorithm>

namespace pcl::sedr::sim {

namespace {

/** @brief A box or cylinder: an upright prism. */
struct Prism {
  Loop footprint;
  double low = 0.0;
  double high = 0.0;
};

/** @brief Returns the parts of an object. */
std::vector<Prism>
prismsOf(const Object& object)
{
  std::vector<Prism> prisms;
  for (const Box& box : object.boxes) {
    const double rise = 0.5 * box.size.z();
    prisms.push_back(
        {polygonLoop(cornersOf(box)), box.center.z() - rise, box.center.z() + rise});
  }
  for (const Cylinder& cylinder : object.cylinders)
    prisms.push_back({circleLoop(plan(cylinder.base), cylinder.radius),
                      cylinder.base.z(), cylinder.base.z() + cylinder.height});
  return prisms;
}

class ObjectChecker {
public:
  ObjectChecker(const Scene& scene, Problems& problems)
      : scene_(scene)
      , problems_(problems)
      , floor_voids_(floorVoidsOf(scene))
  {}

  /** @brief Checks a piece of furniture; its first fault is enough. */
  void checkFurniture(const Object& object) const
  {
    const std::vector<Prism> prisms = prismsOf(object);
    Box2 bounds;
    for (const Prism& prism : prisms)
      bounds.extend(boundsOf(prism.footprint));
    const std::string name =
        object.place + (object.place.empty() ? "the " : ": the ") + object.name;
    for (const Prism& prism : prisms)
      if (!checkPrism(name, prism, bounds.diagonal().norm()))
        return;
  }

  bool checkStation(const Vec3& station, const std::string& name) const
  {
    const Vec2 place = plan(station);
    const std::uint32_t number = roomAt(scene_, station);
    if (number == 0 || !isInRoom(scene_.rooms[number - 1], place))
      return problems_.report(name, at(place), " is in no room");
    const Room& room = scene_.rooms[number - 1];
    if (station.z() <= floorBelow(room, place) ||
        station.z() >= ceilingAbove(room, place))
      return problems_.report(name, at(place), " is not between floor and ceiling");
    for (const Object& object : scene_.furniture)
      for (const Prism& prism : prismsOf(object))
        if (station.z() >= prism.low && station.z() <= prism.high &&
            prism.footprint.contains(place))
          return problems_.report(name, at(place), " is in the ", object.name);
    return true;
  }

private:
  bool checkPrism(const std::string& name, const Prism& prism, double size) const
  {
    const Box2 bounds = boundsOf(prism.footprint);
    const std::uint32_t number =
        roomAt(scene_, lifted(bounds.center(), 0.5 * (prism.low + prism.high)));
    if (number == 0)
      return problems_.report(name, at(bounds.center()), " is in no room");
    const Room& room = scene_.rooms[number - 1];
    for (const Loop& column : room.columns)
      if (prism.footprint.contains(column.elements.front().start))
        return problems_.report(name, " stands around a column");
    std::vector<Vec2> samples = samplesAlong(prism.footprint);
    for (const Layer layer : {Layer::Floor, Layer::Ceiling})
      for (const SlabDetail& detail : detailsOf(room, layer))
        if (detail.bounds.intersects(bounds))
          for (const Vec2& sample : samplesAlong(detail.loop, kContact))
            if (prism.footprint.contains(sample))
              samples.push_back(sample);
    return std::all_of(samples.begin(), samples.end(), [&](const Vec2& sample) {
      return checkSample(name, number, sample, prism, size);
    });
  }

  /** @brief Checks that nothing obstructs the object at a point of a part's
   * outline.
   * @param size of the object in the plan; on a slope it touches at its middle
   */
  bool checkSample(const std::string& name,
                   std::uint32_t number,
                   const Vec2& sample,
                   const Prism& prism,
                   double size) const
  {
    const Room& room = scene_.rooms[number - 1];
    if (!isInRoom(room, sample))
      return problems_.report(name, " meets a wall or column", at(sample));
    const auto over = [&](Layer layer) { // metres beyond the floor or ceiling
      const Slab& slab = slabOf(room, regionAt(room, sample, layer), layer);
      const double z = heightAt(slab, sample);
      return (layer == Layer::Floor ? z - prism.low : prism.high - z) - kContact -
             0.5 * size * slab.gradient.norm();
    };
    const auto holds = [&](const Loop& loop) { return loop.contains(sample); };
    const auto& below = floor_voids_[number - 1];
    if (over(Layer::Floor) > 0.0 && std::none_of(below.begin(), below.end(), holds))
      return problems_.report(name, " is below the floor", at(sample));
    if (over(Layer::Ceiling) > 0.0 &&
        std::none_of(room.voids.begin(), room.voids.end(),
                     [&](const CeilingVoid& v) { return v.leads_to && holds(v.loop); }))
      return problems_.report(name, " is above the ceiling", at(sample));
    return true;
  }

  const Scene& scene_;
  Problems& problems_;
  const std::vector<std::vector<Loop>> floor_voids_; ///< of each room
};

} // namespace

void
checkObjects(const Scene& scene, Problems& problems)
{
  const ObjectChecker checker(scene, problems);
  for (const Object& object : scene.furniture)
    checker.checkFurniture(object);
  for (std::size_t i = 0; i < scene.scanners.size(); ++i)
    for (std::size_t k = 0; k < scene.scanners[i].stations.size(); ++k)
      checker.checkStation(scene.scanners[i].stations[k],
                           placeOf("scanners", i) + ": station " + std::to_string(k));
}

} // namespace pcl::sedr::sim
