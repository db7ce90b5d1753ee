// SPDX-License-Identifier: BSD-3-Clause
#include "scene_surfaces.h"

#include "subdivision.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace pcl::sedr::sim {

namespace {

constexpr double kMatch = 1e-3; ///< how well the two faces of a partition must fit

[[noreturn]] void
reject(const Room& room, const Opening& opening, const char* reason)
{
  std::ostringstream text;
  text << "The opening in wall " << opening.wall << " of room '" << room.name << "' "
       << reason;
  throw std::invalid_argument(text.str());
}

/** @brief The part of the wall that the opening cuts, on the room's side. */
Element
roomSideOf(const Room& room, const Opening& opening)
{
  const Element wall = elementOf(room.outline, opening.wall);
  return pieceOf(wall, opening.from, opening.to);
}

/** @brief The opening as the room behind the wall sees it. */
Opening
otherSideOf(const Scene& scene, std::size_t room_index, const Opening& opening)
{
  const Room& room = scene.rooms[room_index];
  if (*opening.leads_to >= scene.rooms.size())
    reject(room, opening, "leads to a room that does not exist");
  const Element far = offsetRight(roomSideOf(room, opening), opening.depth);
  const Loop& outline = scene.rooms[*opening.leads_to].outline;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Element wall = elementOf(outline, i);
    const auto from = locate(wall, far.end, kMatch);
    const auto to = locate(wall, far.start, kMatch);
    if (!from || !to || !(*from < *to))
      continue;
    Opening other = opening;
    other.wall = i;
    other.from = *from;
    other.to = *to;
    other.leads_to = room_index;
    return other;
  }
  reject(room, opening, "leads to a room that has no wall behind it");
}

void
checkOpening(const Room& room, const Opening& opening)
{
  if (opening.wall >= room.outline.size())
    reject(room, opening, "lies on no wall");
  const double length = lengthOf(elementOf(room.outline, opening.wall));
  if (!(opening.from >= 0.0 && opening.from < opening.to && opening.to <= length))
    reject(room, opening, "does not lie within its wall");
  if (!(opening.sill < opening.head))
    reject(room, opening, "has no height");
}

/** @brief Collects the surfaces of a scene. */
class SurfaceBuilder {
public:
  explicit SurfaceBuilder(const Scene& scene)
      : scene_(scene)
  {}

  std::vector<Surface> run()
  {
    const auto openings = openingsByRoom(scene_);
    for (std::size_t i = 0; i < scene_.rooms.size(); ++i) {
      room_ = static_cast<std::uint32_t>(i + 1);
      addSlabs(scene_.rooms[i]);
      addVerticals(scene_.rooms[i], openings[i]);
      for (const Opening& opening : scene_.rooms[i].openings)
        addReveal(scene_.rooms[i], opening);
    }
    addObjects(scene_.furniture);
    addObjects(scene_.outside);
    return std::move(surfaces_);
  }

private:
  void add(Shape shape, Label label)
  {
    surfaces_.push_back({std::move(shape), label, room_, std::nullopt});
  }

  void addSlabs(const Room& room)
  {
    add(LevelPatch{room.floor.height, room.outline, room.columns}, Label::Floor);
    std::vector<Loop> holes = room.columns;
    for (auto detail = room.details.rbegin(); detail != room.details.rend(); ++detail) {
      add(LevelPatch{detail->slab.height, detail->loop, holes}, Label::Detail);
      holes.push_back(detail->loop);
    }
    add(LevelPatch{room.ceiling.height, room.outline, holes}, Label::Ceiling);
  }

  void addVerticals(const Room& room, const std::vector<Opening>& openings)
  {
    for (const PlanEdge& edge : subdivide(room).edges) {
      const VerticalFace face = verticalFaceOf(room, edge);
      if (face.low < face.high)
        add(verticalPatch(edge.element, face.low, face.high, holesIn(edge, openings)),
            face.label);
    }
  }

  static std::vector<WallRectangle> holesIn(const PlanEdge& edge,
                                            const std::vector<Opening>& openings)
  {
    std::vector<WallRectangle> holes;
    if (edge.source != EdgeSource::Outline)
      return holes;
    for (const Opening& opening : openings)
      if (opening.wall == edge.source_element)
        holes.push_back({opening.from - edge.source_offset,
                         opening.to - edge.source_offset, opening.sill, opening.head});
    return holes;
  }

  /** @brief Jambs, sill and head between the two faces of the wall, and the pane. */
  void addReveal(const Room& room, const Opening& opening)
  {
    const std::uint32_t room_number = std::exchange(room_, 0);
    const Element near = roomSideOf(room, opening);
    const Element far = offsetRight(near, opening.depth);
    const Loop footprint{{near.start, near.bulge},
                         {near.end},
                         {far.end, -far.bulge},
                         {far.start}};
    for (const double z : {opening.sill, opening.head})
      add(LevelPatch{z, footprint, {}}, Label::Other);
    for (const Element& jamb : {Element{near.start, far.start}, {near.end, far.end}})
      add(verticalPatch(jamb, opening.sill, opening.head), Label::Other);
    if (opening.glazing) {
      const Element pane = offsetRight(near, 0.5 * opening.depth);
      add(verticalPatch(pane, opening.sill, opening.head), Label::Other);
      surfaces_.back().glazing = opening.glazing;
    }
    room_ = room_number;
  }

  void addObjects(const std::vector<Object>& objects)
  {
    for (const Object& object : objects) {
      for (const Box& box : object.boxes) {
        room_ = roomAt(scene_, plan(box.center));
        add(box, Label::Other);
      }
      for (const Cylinder& cylinder : object.cylinders) {
        room_ = roomAt(scene_, plan(cylinder.base));
        add(cylinder, Label::Other);
      }
    }
  }

  const Scene& scene_;
  std::uint32_t room_ = 0; ///< number of the room that is being built
  std::vector<Surface> surfaces_;
};

} // namespace

std::vector<std::vector<Opening>>
openingsByRoom(const Scene& scene)
{
  std::vector<std::vector<Opening>> openings(scene.rooms.size());
  for (std::size_t i = 0; i < scene.rooms.size(); ++i)
    for (const Opening& opening : scene.rooms[i].openings) {
      checkOpening(scene.rooms[i], opening);
      openings[i].push_back(opening);
      if (opening.leads_to)
        openings[*opening.leads_to].push_back(otherSideOf(scene, i, opening));
    }
  return openings;
}

std::uint32_t
roomAt(const Scene& scene, Vec2 point)
{
  for (std::size_t i = 0; i < scene.rooms.size(); ++i)
    if (contains(scene.rooms[i].outline, point))
      return static_cast<std::uint32_t>(i + 1);
  return 0;
}

std::vector<Surface>
surfacesOf(const Scene& scene)
{
  return SurfaceBuilder(scene).run();
}

} // namespace pcl::sedr::sim
