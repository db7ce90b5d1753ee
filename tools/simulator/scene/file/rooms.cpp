// SPDX-License-Identifier: BSD-3-Clause
#include "furniture.h"

#include "simulator/scene/shapes.h"

#include "sedr_filters/src/base/number_text.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>

namespace pcl::sedr::sim {

namespace {

constexpr double kShortest = 1e-3; ///< metres; corners closer than this are a mistake
constexpr double kLargestBulge = 10.0;

Vec2
readPosition(const JsonView& corner)
{
  return corner.isObject() ? corner.at("at").point2() : corner.point2();
}

/** @brief Reads the bulge of the element from @p corner over @p chord metres. */
double
readBulge(const JsonView& corner, double chord)
{
  if (!corner.isObject())
    return 0.0;
  if (const auto bulge = corner.find("bulge"))
    return bulge->number(-kLargestBulge, kLargestBulge);
  const double radius = corner.at("radius").number();
  if (std::abs(radius) < 0.5 * chord)
    corner.at("radius").fail("is " + numberText(radius) +
                             ", too small for an arc to a corner " + numberText(chord) +
                             " m away");
  return std::tan(0.5 * std::asin(0.5 * chord / radius));
}

Loop
readCorners(const JsonView& view)
{
  const auto corners = view.items(2);
  Loop loop;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 start = readPosition(corners[i]);
    const Vec2 end = readPosition(corners[(i + 1) % corners.size()]);
    const double chord = (end - start).norm();
    if (chord < kShortest)
      corners[i].fail("is the same point as the corner after it");
    loop.elements.push_back(elementBetween(start, end, readBulge(corners[i], chord)));
  }
  return loop;
}

/** @brief Reads a loop: a list of corners, a rectangle, or a circle.
 *
 * A corner is [x, y]. Where an arc starts, it is {"at": [x, y], "radius": r} or {"at":
 * [x, y], "bulge": b}. A positive radius turns left, and the arc is less than half a
 * circle; a bulge is that of elementBetween(). {"rectangle": [[x, y], [x, y]]} gives
 * two opposite corners, {"circle": [x, y], "radius": r} centre and radius. */
Loop
readLoop(const JsonView& view)
{
  if (view.isList())
    return readCorners(view);
  if (view.find("circle"))
    return circleLoop(view.at("circle").point2(), view.at("radius").size());
  const auto rectangle = view.find("rectangle");
  if (!rectangle)
    view.fail("must be a list of corners, a \"rectangle\" or a \"circle\"");
  const auto corners = rectangle->items(2);
  if (corners.size() != 2)
    rectangle->fail("must be two corners, [[x, y], [x, y]]");
  const Box2 box(corners[0].point2(), corners[1].point2());
  if ((box.sizes().array() < kShortest).any())
    rectangle->fail("must give the corner of smaller x and y first");
  return loopAround(box);
}

constexpr double kSteepest = 60.0; ///< degrees
constexpr double kMostTilt = 45.0; ///< degrees
constexpr std::size_t kMostStoreys = 200;
constexpr std::size_t kMostRibs = 5000; ///< of a family
constexpr double kNarrowest = 0.01;     ///< spacing of ribs, metres

/** @brief A floor or ceiling as the file gives it: its height at a place. */
struct GivenSlab {
  Slab slab;
  Vec2 at = Vec2::Zero();
};

/** @brief Reads a plane: its height, or its height, slope and direction.
 * @param otherwise default of the place that has that height */
GivenSlab
readSlab(const JsonView& view, const Vec2& otherwise)
{
  if (!view.isObject())
    return {horizontalSlab(view.number())};
  const auto given = view.find("at");
  const Vec2 at = given ? given->point2() : otherwise;
  const double slope = view.at("slope").angle(0.0, kSteepest);
  const double towards = view.at("towards").angle();
  return {planeThrough(lifted(at, view.at("height").number()),
                       rotated({std::tan(slope), 0.0}, towards)),
          at};
}

/** @brief Reads a part of the floor or ceiling: its own plane, or parallel to @p whole.
 * @param offset key of the distance from @p whole
 * @param upwards direction of that distance: 1 or -1 */
PlanDetail
readDetail(const JsonView& view,
           const GivenSlab& whole,
           const char* offset,
           int upwards)
{
  const auto height = view.find("height");
  const auto distance = view.find(offset);
  if (height.has_value() == distance.has_value())
    view.fail(std::string("must have either \"height\" or \"") + offset + '"');
  return {readLoop(view.at("loop")),
          {},
          height ? readSlab(*height, whole.at).slab
                 : raised(whole.slab, upwards * distance->number())};
}

/** @brief Adds parallel ribs below a ceiling to its details.
 *
 * They extend over the bounds of the room: walls cut them, and so do details that come
 * after them in the room's list, as beams cut joists. A rib that would cross the wall
 * beside it at either end of the room is left out. */
void
readRibs(const JsonView& view, Room& room)
{
  const double spacing = view.at("spacing").number(kNarrowest);
  const double width = view.at("width").size();
  if (!(width < spacing))
    view.at("width").fail("is not less than the spacing of the ribs");
  const Slab underside = raised(room.ceiling, -view.at("depth").size());
  const Vec2 along = rotated({1.0, 0.0}, view.at("direction").angle());
  const Vec2 across = leftOf(along);
  Box2 bounds; // along and across
  for (const Vec2& place : room.boundary.polygon(kCurveTolerance))
    bounds.extend(Vec2(place.dot(along), place.dot(across)));
  const Vec2 start = bounds.min().x() * along;
  const Vec2 end = bounds.max().x() * along;
  // To the middle of the first rib, from the room's right end, seen along the ribs.
  const double first = view.numberOr("first", 0.5 * spacing);
  const std::size_t before = room.details.size();
  for (double low = bounds.min().y() + first - 0.5 * width;
       low + width <= bounds.max().y() + kSamePoint; low += spacing) {
    const Vec2 right = low * across;
    const Vec2 left = (low + width) * across;
    if (low >= bounds.min().y() - kSamePoint)
      room.details.push_back(
          {loopOf({start + right, end + right, end + left, start + left}),
           {},
           underside});
    if (room.details.size() - before > kMostRibs)
      view.fail("makes more than " + std::to_string(kMostRibs) + " ribs");
  }
}

/** @brief Reads a cap of a sphere, or of an ellipsoid with a vertical axis. */
PlanDetail
readDome(const JsonView& view)
{
  const double radius = view.at("radius").size();
  const double rim = view.at("rim").size();
  if (rim > radius)
    view.at("rim").fail("is more than the radius of the dome");
  Vec3 factors = Vec3::Ones(); // along, across, up
  if (const auto scale = view.find("scale")) {
    factors = scale->size3();
    if (factors.maxCoeff() > 1.0)
      scale->fail("must not be more than 1");
  }
  SlabCurve curve;
  curve.kind = CurveKind::Ellipsoid;
  curve.centre = view.at("at").point2();
  curve.base = view.at("height").number();
  curve.setDirection(view.numberOr("direction", 0.0) * pi / 180.0);
  curve.along = factors.x() * edgeRadius(radius);
  curve.across = factors.y() * edgeRadius(radius);
  curve.up = factors.z() * edgeRadius(radius);
  PlanDetail part;
  part.boundary = rimOf(curve, rim / edgeRadius(radius));
  part.slab.curve = std::make_shared<const SlabCurve>(curve);
  return part;
}

/** @brief Reads a barrel vault, or a segment of one. */
PlanDetail
readVault(const JsonView& view, const Loop& loop)
{
  const double radius = view.at("radius").size();
  SlabCurve curve;
  curve.centre = view.at("at").point2();
  curve.base = view.at("height").number();
  curve.setDirection(view.at("direction").angle());
  curve.across = curve.up = edgeRadius(radius);
  for (const Vec2& place : loop.polygon(kCurveTolerance))
    if (std::abs(leftOf(curve.axis).dot(place - curve.centre)) > radius + kSamePoint)
      view.fail("does not reach the sides of its loop");
  PlanDetail part;
  part.boundary = loop;
  part.slab.curve = std::make_shared<const SlabCurve>(curve);
  return part;
}

/** @brief Reads a part of a ceiling that is not level: a slope, a vault or a dome. */
PlanDetail
readFacet(const JsonView& view, const GivenSlab& ceiling)
{
  const auto dome = view.find("dome");
  const auto vault = view.find("vault");
  PlanDetail part = dome    ? readDome(*dome)
                    : vault ? readVault(*vault, readLoop(view.at("loop")))
                            : readDetail(view, ceiling, "drop", -1);
  part.is_facet = true;
  return part;
}

/** @brief Reads a hole in a ceiling; the names of all rooms must be known. */
CeilingVoid
readVoid(const JsonView& view, const Scene& scene)
{
  CeilingVoid hole{readLoop(view.at("loop"))};
  if (const auto target = view.find("leads_to"))
    hole.leads_to = roomNamed(*target, scene);
  return hole;
}

/** @brief Reads a room without its openings, voids and furniture. */
Room
readShell(const JsonView& view)
{
  Room room;
  room.name = view.at("name").text();
  room.boundary = readLoop(view.at("outline"));
  if (!(room.boundary.area() > 0.0)) // otherwise walls and their objects would be lost
    view.at("outline").fail("does not run counter-clockwise");
  const Vec2 corner = room.boundary.elements.front().start;
  const GivenSlab floor = readSlab(view.at("floor"), corner);
  const GivenSlab ceiling = readSlab(view.at("ceiling"), corner);
  room.floor = floor.slab;
  room.ceiling = ceiling.slab;
  if (const auto storey = view.find("storey"))
    room.storey = storey->count(1, kMostStoreys);
  room.plenum = view.numberOr("plenum", 0.0, JsonView::kSmallest);
  for (const JsonView& facet : view.itemsOf("facets"))
    room.details.push_back(readFacet(facet, ceiling));
  for (const JsonView& ribs : view.itemsOf("ribs"))
    readRibs(ribs, room);
  for (const JsonView& detail : view.itemsOf("floor_details"))
    room.floor_details.push_back(readDetail(detail, floor, "rise", 1));
  for (const JsonView& detail : view.itemsOf("ceiling_details"))
    room.details.push_back(readDetail(detail, ceiling, "drop", -1));
  for (const JsonView& column : view.itemsOf("columns"))
    room.columns.push_back(readLoop(column));
  auto& walls = room.boundary.elements;
  for (const JsonView& tilt : view.itemsOf("tilts"))
    walls[tilt.at("wall").count(0, walls.size() - 1)].tilt =
        tilt.at("tilt").angle(-kMostTilt, kMostTilt);
  for (const JsonView& niche : view.itemsOf("niches"))
    room.wall_niches.push_back(readGap(niche, room));
  return room;
}

} // namespace

void
readRooms(const JsonView& list, Scene& scene)
{
  const auto views = list.items(1);
  for (const JsonView& view : views) {
    Room room = readShell(view);
    const bool is_known =
        std::any_of(scene.rooms.begin(), scene.rooms.end(),
                    [&room](const Room& other) { return other.name == room.name; });
    if (is_known)
      view.at("name").fail("is that of another room, too");
    scene.rooms.push_back(std::move(room));
  }
  for (std::size_t i = 0; i < views.size(); ++i) {
    for (const JsonView& opening : views[i].itemsOf("openings"))
      readOpening(opening, i, scene);
    for (const JsonView& hole : views[i].itemsOf("voids"))
      scene.rooms[i].voids.push_back(readVoid(hole, scene));
    for (Object& object : readObjects(views[i].itemsOf("furniture"), &scene.rooms[i]))
      scene.furniture.push_back(std::move(object));
  }
}

} // namespace pcl::sedr::sim
