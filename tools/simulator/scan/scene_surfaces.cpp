// SPDX-License-Identifier: BSD-3-Clause
#include "scene_surfaces.h"

#include "simulator/truth/subdivision.h"

#include <algorithm>
#include <utility>

namespace pcl::sedr::sim {

namespace {

constexpr double kBelow = 1e-3; ///< metres by which a detail hides what is behind

/** @brief Collects the surfaces of a scene. */
class SurfaceBuilder {
public:
  explicit SurfaceBuilder(const Scene& scene)
      : scene_(scene)
  {}

  std::vector<Surface> run()
  {
    const auto openings = openingsByRoom(scene_);
    const auto floor_voids = floorVoidsOf(scene_);
    for (std::size_t i = 0; i < scene_.rooms.size(); ++i) {
      room_ = static_cast<std::uint32_t>(i + 1);
      addSlabs(scene_.rooms[i], floor_voids[i]);
      addVerticals(scene_.rooms[i], openings[i]);
      for (const Opening& opening : scene_.rooms[i].openings)
        addReveal(scene_.rooms[i], opening);
      for (const Niche& niche : scene_.rooms[i].niches)
        addNiche(scene_.rooms[i], niche);
      room_ = 0; // the surfaces that follow belong to no room
      for (const CeilingVoid& hole : scene_.rooms[i].voids)
        addShaft(scene_.rooms[i], hole);
      if (scene_.rooms[i].plenum > 0.0)
        addPlenum(scene_.rooms[i]);
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

  void addSlabs(const Room& room, const std::vector<Loop>& floor_voids)
  {
    std::vector<Loop> ceiling_voids;
    for (const CeilingVoid& hole : room.voids)
      ceiling_voids.push_back(hole.loop);
    addSlabs(room, Layer::Floor, Side::AboveOrLeft, floor_voids);
    addSlabs(room, Layer::Ceiling, Side::BelowOrRight, ceiling_voids);
  }

  /** @brief Adds a floor or ceiling; details are cut out of what they overlap. */
  void
  addSlabs(const Room& room, Layer layer, Side front, const std::vector<Loop>& voids)
  {
    std::vector<Loop> holes = room.columns;
    holes.insert(holes.end(), voids.begin(), voids.end());
    const auto& details = detailsOf(room, layer);
    for (std::size_t i = details.size(); i > 0; --i)
      add(SlabPatch{details[i - 1].slab, details[i - 1].loop,
                    withDetails(holes, room, layer, static_cast<Region>(i))},
          labelOf(room, static_cast<Region>(i), layer), front);
    add(SlabPatch{slabOf(room, kMain, layer), room.outline,
                  withDetails(holes, room, layer, kMain)},
        labelOf(room, kMain, layer), front);
  }

  /** @brief Adds the details that cut a region to @p holes.
   *
   * A detail that hangs below the ceiling or stands on the floor hides it and need not
   * be cut out. This matters for decks with hundreds of ribs.
   */
  static std::vector<Loop>
  withDetails(std::vector<Loop> holes, const Room& room, Layer layer, Region region)
  {
    const Slab& slab = slabOf(room, region, layer);
    const auto& details = detailsOf(room, layer);
    for (auto detail = details.begin() + region; detail != details.end(); ++detail)
      if (!hides(*detail, slab, layer))
        holes.push_back(detail->loop);
    return holes;
  }

  static bool hides(const SlabDetail& detail, const Slab& slab, Layer layer)
  {
    const double way = layer == Layer::Ceiling ? -1.0 : 1.0;
    return std::all_of(detail.loop.begin(), detail.loop.end(),
                       [&](const LoopVertex& vertex) {
                         const double rise = heightAt(detail.slab, vertex.position) -
                                             heightAt(slab, vertex.position);
                         return vertex.bulge == 0.0 && way * rise > kBelow;
                       });
  }

  /** @brief Adds the sides of a void, from the ceiling to the floor above. */
  void addShaft(const Room& room, const CeilingVoid& hole)
  {
    if (!hole.leads_to)
      return;
    const Room& above = scene_.rooms[*hole.leads_to];
    const Vec2 inside = pointInside(hole.loop);
    const Slab& low = slabOf(
        room, std::max(kMain, regionAt(room, inside, Layer::Ceiling)), Layer::Ceiling);
    const Slab& high = slabOf(
        above, std::max(kMain, regionAt(above, inside, Layer::Floor)), Layer::Floor);
    addSides(hole.loop, low, high);
  }

  /** @brief Adds the sides and the top of the space above a suspended ceiling. */
  void addPlenum(const Room& room)
  {
    Slab top = room.ceiling;
    top.height += room.plenum;
    std::vector<Loop> holes = room.columns;
    for (const CeilingVoid& hole : room.voids)
      if (hole.leads_to)
        holes.push_back(hole.loop);
    addSides(room.outline, room.ceiling, top);
    for (const Loop& column : room.columns)
      addSides(column, room.ceiling, top);
    add(SlabPatch{top, room.outline, std::move(holes)}, Label::Other, Side::None);
  }

  void addSides(const Loop& loop, const Slab& low, const Slab& high)
  {
    for (std::size_t i = 0; i < loop.size(); ++i)
      add(verticalPatch(elementOf(loop, i), low, high), Label::Other, Side::None);
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

  /** @brief Adds jambs, sill and head between the two faces of the wall, and pane. */
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

  /** @brief Returns the part of the wall's face that an opening or niche cuts. */
  template <typename Gap>
  static Element wallPartOf(const Room& room, const Gap& gap)
  {
    return pieceOf(elementOf(room.outline, gap.wall), gap.from, gap.to);
  }

  /** @brief Adds bottom, lid and sides behind a part of a wall. */
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
        room_ = roomAt(scene_, box.center);
        add(box, Label::Other, Side::None);
      }
      for (const Cylinder& cylinder : object.cylinders) {
        room_ = roomAt(scene_, cylinder.base + Vec3{0.0, 0.0, 0.5 * cylinder.height});
        add(cylinder, Label::Other, Side::None);
      }
    }
  }

  const Scene& scene_;
  std::uint32_t room_ = 0; ///< number of the current room
  std::vector<Surface> surfaces_;
};

} // namespace

std::vector<Surface>
surfacesOf(const Scene& scene)
{
  return SurfaceBuilder(scene).run();
}

} // namespace pcl::sedr::sim
