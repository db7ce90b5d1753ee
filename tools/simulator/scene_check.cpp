// SPDX-License-Identifier: BSD-3-Clause
#include "scene_check.h"

#include "scene_surfaces.h"
#include "subdivision.h"
#include "surface.h"
#include "truth_mesh.h"

#include <algorithm>
#include <exception>
#include <sstream>

namespace pcl::sedr::sim {

namespace {

constexpr double kSlack = 1e-6;   ///< contact is no overlap
constexpr double kSpacing = 0.05; ///< of the samples along a footprint

bool
touchesOutline(const Loop& loop, Vec2 point)
{
  for (std::size_t i = 0; i < loop.size(); ++i)
    if (locate(elementOf(loop, i), point, kSlack))
      return true;
  return false;
}

/** @brief Metres along an element every few centimetres, both ends included. */
std::vector<double>
stepsAlong(const Element& element)
{
  const double size = lengthOf(element);
  const auto count = static_cast<std::size_t>(std::ceil(size / kSpacing));
  std::vector<double> steps;
  for (std::size_t i = 0; i <= count; ++i)
    steps.push_back(size * static_cast<double>(i) / static_cast<double>(count));
  return steps;
}

std::vector<Vec2>
samplesAlong(const Loop& loop)
{
  std::vector<Vec2> samples;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Element element = elementOf(loop, i);
    for (const double s : stepsAlong(element))
      samples.push_back(pointAt(element, s));
  }
  return samples;
}

Loop
footprintOf(const Box& box)
{
  const Vec2 half{0.5 * box.size.x, 0.5 * box.size.y};
  Loop loop = rectangleLoop(-1.0 * half, half);
  for (LoopVertex& vertex : loop)
    vertex.position = plan(box.center) + rotated(vertex.position, box.yaw);
  return loop;
}

/** @brief Collects the sentences. */
class Checker {
public:
  explicit Checker(const Scene& scene)
      : scene_(scene)
  {}

  std::vector<std::string> run()
  {
    for (const Room& room : scene_.rooms)
      checkRoom(room);
    if (problems_.empty())
      checkGeometry();
    for (const Object& object : scene_.furniture)
      checkFurniture(object);
    for (const Scanner& scanner : scene_.scanners)
      for (const Vec3& station : scanner.stations)
        checkStation(station);
    return problems_;
  }

private:
  template <typename... Parts>
  void report(const Parts&... parts)
  {
    std::ostringstream text;
    (text << ... << parts);
    problems_.push_back(text.str());
  }

  void checkRoom(const Room& room)
  {
    if (room.outline.size() < 2 || !(areaOf(room.outline) > 0.0))
      return report("Room '", room.name, "' does not run counter-clockwise");
    if (!(room.floor.height < room.ceiling.height))
      report("Room '", room.name, "' has no height");
    for (const CeilingDetail& detail : room.details)
      checkDetail(room, detail);
    for (const Loop& column : room.columns)
      for (const Vec2 sample : samplesAlong(column))
        if (!contains(room.outline, sample) || touchesOutline(room.outline, sample))
          return report("A column of room '", room.name, "' is not within the room");
    for (const Opening& opening : room.openings)
      if (opening.sill < room.floor.height - kSlack || !(opening.depth > 0.0))
        report("An opening of room '", room.name,
               "' has no depth or is below the floor");
  }

  void checkDetail(const Room& room, const CeilingDetail& detail)
  {
    if (!(detail.slab.height > room.floor.height))
      report("A detail of room '", room.name, "' is below the floor");
    for (const Vec2 sample : samplesAlong(detail.loop))
      if (!contains(room.outline, sample) && !touchesOutline(room.outline, sample))
        return report("A detail of room '", room.name, "' reaches out of the room");
  }

  void checkGeometry()
  {
    try {
      surfacesOf(scene_);
      truthMesh(scene_);
      const auto openings = openingsByRoom(scene_);
      for (std::size_t i = 0; i < openings.size(); ++i)
        for (const Opening& opening : openings[i])
          checkHead(scene_.rooms[i], opening);
    }
    catch (const std::exception& error) {
      report(error.what());
    }
  }

  /** @brief The lintel is below whatever ceiling or soffit meets the wall. */
  void checkHead(const Room& room, const Opening& opening)
  {
    const Element wall = elementOf(room.outline, opening.wall);
    const Element piece = pieceOf(wall, opening.from, opening.to);
    for (const double s : stepsAlong(piece)) {
      const Vec2 inside = pointAt(piece, s) - 1e-4 * rightNormalAt(piece, s);
      const Region region = regionAt(room, inside);
      if (region != kVoid && opening.head > ceilingHeight(room, region))
        return report("An opening of room '", room.name, "' reaches above its ceiling");
    }
  }

  void checkFurniture(const Object& object)
  {
    for (const Box& box : object.boxes)
      checkPart(object, footprintOf(box), boundsOf(Shape{box}));
    for (const Cylinder& cylinder : object.cylinders)
      checkPart(object, circleLoop(plan(cylinder.base), cylinder.radius),
                boundsOf(Shape{cylinder}));
  }

  void checkPart(const Object& object, const Loop& footprint, const Bounds& bounds)
  {
    const Vec2 center = plan(0.5 * (bounds.min + bounds.max));
    const std::uint32_t number = roomAt(scene_, center);
    if (number == 0)
      return report("The ", object.name, " at ", center.x, ", ", center.y,
                    " is in no room");
    const Room& room = scene_.rooms[number - 1];
    if (bounds.min.z < room.floor.height - kSlack)
      report("The ", object.name, " at ", center.x, ", ", center.y,
             " is below the floor");
    for (const Loop& column : room.columns)
      if (contains(footprint, column.front().position))
        return report("A column stands in the ", object.name);
    for (const Vec2 sample : samplesAlong(footprint)) {
      const Region region = regionAt(room, sample);
      if (region == kVoid)
        return report("The ", object.name, " meets a wall or column at ", sample.x,
                      ", ", sample.y);
      if (bounds.max.z > ceilingHeight(room, region) + kSlack)
        return report("The ", object.name, " at ", sample.x, ", ", sample.y,
                      " is above the ceiling");
    }
  }

  void checkStation(Vec3 station)
  {
    const std::uint32_t number = roomAt(scene_, plan(station));
    const Region region =
        number == 0 ? kVoid : regionAt(scene_.rooms[number - 1], plan(station));
    if (region == kVoid)
      return report("The scanner at ", station.x, ", ", station.y, " is in no room");
    const Room& room = scene_.rooms[number - 1];
    if (station.z <= room.floor.height || station.z >= ceilingHeight(room, region))
      report("The scanner at ", station.x, ", ", station.y, " is not in the air");
    for (const Object& object : scene_.furniture)
      if (isInside(object, station))
        report("The scanner at ", station.x, ", ", station.y, " is in a ", object.name);
  }

  static bool isInside(const Object& object, Vec3 point)
  {
    const auto between = [&point](const Bounds& bounds) {
      return point.z >= bounds.min.z && point.z <= bounds.max.z;
    };
    return std::any_of(object.boxes.begin(), object.boxes.end(),
                       [&](const Box& box) {
                         return between(boundsOf(Shape{box})) &&
                                contains(footprintOf(box), plan(point));
                       }) ||
           std::any_of(object.cylinders.begin(), object.cylinders.end(),
                       [&](const Cylinder& cylinder) {
                         return between(boundsOf(Shape{cylinder})) &&
                                length(plan(point) - plan(cylinder.base)) <=
                                    cylinder.radius;
                       });
  }

  const Scene& scene_;
  std::vector<std::string> problems_;
};

} // namespace

std::vector<std::string>
problemsOf(const Scene& scene)
{
  return Checker(scene).run();
}

} // namespace pcl::sedr::sim
