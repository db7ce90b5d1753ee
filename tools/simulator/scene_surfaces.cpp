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
reject(std::size_t room, std::size_t opening, const std::string& reason)
{
  throw std::invalid_argument("rooms[" + std::to_string(room) + "].openings[" +
                              std::to_string(opening) + "] " + reason);
}

void
checkOpening(const Scene& scene, std::size_t room, std::size_t index)
{
  const Opening& opening = scene.rooms[room].openings[index];
  const Loop& outline = scene.rooms[room].outline;
  if (opening.wall >= outline.size())
    reject(room, index, "lies on no wall");
  const double length = lengthOf(elementOf(outline, opening.wall));
  if (!(opening.from >= 0.0 && opening.from < opening.to && opening.to <= length))
    reject(room, index, "does not lie within its wall");
  if (!(opening.sill < opening.head && opening.depth > 0.0))
    reject(room, index, "has no height or depth");
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
      for (const Niche& niche : scene_.rooms[i].niches)
        addNiche(scene_.rooms[i], niche);
    }
    addObjects(scene_.furniture);
    addObjects(scene_.outside);
    return std::move(surfaces_);
  }

private:
  void add(Shape shape, Label label, Side front)
  {
    surfaces_.push_back({std::move(shape), label, room_, std::nullopt, front});
  }

  void addSlabs(const Room& room)
  {
    addSlabs(room, Layer::Floor, Label::Floor, Side::AboveOrLeft);
    addSlabs(room, Layer::Ceiling, Label::Ceiling, Side::BelowOrRight);
  }

  /** @brief Adds a floor or ceiling, its details cut out of what they overlap. */
  void addSlabs(const Room& room, Layer layer, Label label, Side front)
  {
    std::vector<Loop> holes = room.columns;
    const auto& details = detailsOf(room, layer);
    for (auto detail = details.rbegin(); detail != details.rend(); ++detail) {
      add(SlabPatch{detail->slab, detail->loop, holes}, Label::Detail, front);
      holes.push_back(detail->loop);
    }
    add(SlabPatch{slabOf(room, kMain, layer), room.outline, holes}, label, front);
  }

  void addVerticals(const Room& room, const std::vector<Opening>& openings)
  {
    for (const PlanEdge& edge : subdivide(room).edges)
      for (const VerticalFace& face : verticalFacesOf(room, edge))
        add(verticalPatch(edge.element, face.low, face.high,
                          holesIn(edge, room, openings)),
            face.label, face.room_is_left ? Side::AboveOrLeft : Side::BelowOrRight);
  }

  static std::vector<WallRectangle>
  holesIn(const PlanEdge& edge, const Room& room, const std::vector<Opening>& openings)
  {
    std::vector<WallRectangle> holes;
    if (edge.source != EdgeSource::Outline)
      return holes;
    const auto add_holes = [&](const auto& gaps) {
      for (const auto& gap : gaps)
        if (gap.wall == edge.source_element)
          holes.push_back({gap.from - edge.source_offset, gap.to - edge.source_offset,
                           gap.sill, gap.head});
    };
    add_holes(openings);
    add_holes(room.niches);
    return holes;
  }

  /** @brief Jambs, sill and head between the two faces of the wall, and the pane. */
  void addReveal(const Room& room, const Opening& opening)
  {
    const std::uint32_t room_number = std::exchange(room_, 0);
    const Element near = wallPartOf(room, opening);
    addRecess(near, opening, Label::Other);
    if (opening.glazing) {
      const Element pane = offsetRight(near, 0.5 * opening.depth);
      add(verticalPatch(pane, {opening.sill}, {opening.head}), Label::Other,
          Side::None);
      surfaces_.back().glazing = opening.glazing;
    }
    room_ = room_number;
  }

  void addNiche(const Room& room, const Niche& niche)
  {
    const Element near = wallPartOf(room, niche);
    addRecess(near, niche, Label::Detail);
    add(verticalPatch(offsetRight(near, niche.depth), {niche.sill}, {niche.head}),
        Label::Detail, Side::AboveOrLeft);
  }

  /** @brief The part of the wall that an opening or niche cuts, on the room's side. */
  template <typename Gap>
  static Element wallPartOf(const Room& room, const Gap& gap)
  {
    return pieceOf(elementOf(room.outline, gap.wall), gap.from, gap.to);
  }

  /** @brief Bottom, lid and sides behind a part of a wall. */
  template <typename Gap>
  void addRecess(const Element& near, const Gap& gap, Label label)
  {
    const Element far = offsetRight(near, gap.depth);
    const Loop footprint = recessFootprint(near, gap.depth);
    const Slab low{gap.sill};
    const Slab high{gap.head};
    add(SlabPatch{low, footprint, {}}, label, Side::AboveOrLeft);
    add(SlabPatch{high, footprint, {}}, label, Side::BelowOrRight);
    add(verticalPatch({near.start, far.start}, low, high), label, Side::AboveOrLeft);
    add(verticalPatch({near.end, far.end}, low, high), label, Side::BelowOrRight);
  }

  void addObjects(const std::vector<Object>& objects)
  {
    for (const Object& object : objects) {
      for (const Box& box : object.boxes) {
        room_ = roomAt(scene_, plan(box.center));
        add(box, Label::Other, Side::None);
      }
      for (const Cylinder& cylinder : object.cylinders) {
        room_ = roomAt(scene_, plan(cylinder.base));
        add(cylinder, Label::Other, Side::None);
      }
    }
  }

  const Scene& scene_;
  std::uint32_t room_ = 0; ///< number of the room that is being built
  std::vector<Surface> surfaces_;
};

} // namespace

Opening
otherSideOf(const Scene& scene, std::size_t room, std::size_t index)
{
  const Opening& opening = scene.rooms[room].openings[index];
  if (*opening.leads_to >= scene.rooms.size())
    reject(room, index, "leads to a room that does not exist");
  const Element wall = elementOf(scene.rooms[room].outline, opening.wall);
  const Element far =
      offsetRight(pieceOf(wall, opening.from, opening.to), opening.depth);
  const Room& target = scene.rooms[*opening.leads_to];
  for (std::size_t i = 0; i < target.outline.size(); ++i) {
    const Element behind = elementOf(target.outline, i);
    const auto from = locate(behind, far.end, kMatch);
    const auto to = locate(behind, far.start, kMatch);
    if (!from || !to || !(*from < *to))
      continue;
    Opening other = opening;
    other.wall = i;
    other.from = *from;
    other.to = *to;
    other.leads_to = room;
    return other;
  }
  std::ostringstream reason;
  reason << "leads to room '" << target.name << "', which has no wall there, "
         << opening.depth << " m behind this one";
  reject(room, index, reason.str());
}

std::vector<std::vector<Opening>>
openingsByRoom(const Scene& scene)
{
  std::vector<std::vector<Opening>> openings(scene.rooms.size());
  for (std::size_t i = 0; i < scene.rooms.size(); ++i)
    for (std::size_t k = 0; k < scene.rooms[i].openings.size(); ++k) {
      const Opening& opening = scene.rooms[i].openings[k];
      checkOpening(scene, i, k);
      openings[i].push_back(opening);
      if (opening.leads_to) {
        const Opening other = otherSideOf(scene, i, k);
        openings[*opening.leads_to].push_back(other);
      }
    }
  return openings;
}

Loop
recessFootprint(const Element& near, double depth)
{
  const Element far = offsetRight(near, depth);
  return {{near.start, near.bulge}, {near.end}, {far.end, -far.bulge}, {far.start}};
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
