// SPDX-License-Identifier: BSD-3-Clause
#include "scene_mesh.h"

#include "room_plan.h"

#include <algorithm>
#include <stdexcept>

namespace pcl::sedr::sim {

namespace {

/** @brief Adds what is no structure of a room: reveals and panes of openings, shafts
 * and plenums between storeys, furniture, and the world outside. */
class SurroundingsMesher {
public:
  SurroundingsMesher(const Scene& scene, SceneMesh& result)
      : scene_(scene)
      , result_(result)
  {}

  /** @brief Adds jambs, sill, head and pane of an opening that a room gives. */
  void addReveal(const Room& room, const RoomPlan& plan, const Opening& opening)
  {
    const Element& wall = room.boundary.elements[opening.wall];
    const Vec3 low(0.0, 0.0, opening.sill);
    const Vec3 high(0.0, 0.0, opening.head);
    const auto at = [&](double s, double depth) {
      return lifted(pointBeside(wall, s, depth), 0.0);
    };
    const auto add_upright = [&](const Vec3& a, const Vec3& b, Surface surface) {
      addQuad({a + low, b + low, b + high, a + high}, surface, opening.number);
    };
    for (const PlanSide& side : plan.sides) {
      if (!side.isWithin(opening))
        continue;
      for (const Vec3& z : {low, high})
        addQuad({at(side.from, 0.0) + z, at(side.to, 0.0) + z,
                 at(side.to, opening.depth) + z, at(side.from, opening.depth) + z});
      if (opening.glazing)
        add_upright(at(side.from, 0.5 * opening.depth),
                    at(side.to, 0.5 * opening.depth), Surface::Pane);
    }
    for (const double s : {opening.from, opening.to})
      add_upright(at(s, 0.0), at(s, opening.depth), Surface::Object);
    result_.panes.resize(std::max<std::size_t>(result_.panes.size(), opening.number));
    if (opening.glazing)
      result_.panes[opening.number - 1] = {*opening.glazing, !wall.isArc()};
  }

  /** @brief Adds the sides of a void, from the ceiling to the floor above. */
  void addShaft(const Room& room, const CeilingVoid& hole)
  {
    const Room& above = scene_.rooms[*hole.leads_to];
    const Vec2 inside = pointInside(hole.loop);
    addSides(hole.loop, room.ceilingSlab(room.detailAt(inside)),
             above.floorSlab(above.floorDetailAt(inside)));
  }

  /** @brief Adds sides and top of the space above a suspended ceiling. */
  void addPlenum(const Room& room, const RoomPlan& plan)
  {
    const Slab top = raised(room.ceiling, room.plenum);
    addSides(room.boundary, room.ceiling, top);
    for (const Loop& column : room.columns)
      addSides(column, room.ceiling, top);
    for (const PlanTriangle& triangle : plan.triangles) {
      if (triangle.hole_above && room.voids[*triangle.hole_above].leads_to)
        continue;
      Triangle corners{};
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec2& point = plan.points[triangle.corners[k]];
        corners[k] = result_.addVertex(lifted(point, top.heightAt(point)));
      }
      result_.addFace(corners, Surface::Object);
    }
  }

  void addObjects(const std::vector<Object>& objects)
  {
    for (const Object& object : objects)
      for (const Prism& part : object.parts)
        addPrism(part);
  }

private:
  void addQuad(const std::array<Vec3, 4>& corners,
               Surface surface = Surface::Object,
               std::uint32_t opening = 0,
               std::uint32_t room = 0)
  {
    const std::uint32_t first = result_.addVertex(corners[0]);
    for (std::size_t k = 1; k < 4; ++k)
      result_.addVertex(corners[k]);
    result_.addFace({first, first + 1, first + 2}, surface, Label::Other, room,
                    opening);
    result_.addFace({first, first + 2, first + 3}, surface, Label::Other, room,
                    opening);
  }

  /** @brief Adds the vertical faces over a loop, between two planes. */
  void addSides(const Loop& loop, const Slab& low, const Slab& high)
  {
    const auto raised = [](const Vec2& point, const Slab& slab) {
      return lifted(point, slab.heightAt(point));
    };
    for (const Element& element : loop.elements) {
      const std::vector<double> ends = chordEnds(element);
      for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const Vec2 a = element.pointAt(ends[i]);
        const Vec2 b = element.pointAt(ends[i + 1]);
        addQuad({raised(a, low), raised(b, low), raised(b, high), raised(a, high)});
      }
    }
  }

  void addPrism(const Prism& prism)
  {
    const auto& [corners, low, high] = prism;
    Vec2 middle = Vec2::Zero();
    for (const Vec2& corner : corners)
      middle += corner / static_cast<double>(corners.size());
    const std::uint32_t room = roomAt(scene_, lifted(middle, 0.5 * (low + high)));
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec2& a = corners[i];
      const Vec2& b = corners[(i + 1) % corners.size()];
      addQuad({lifted(a, low), lifted(b, low), lifted(b, high), lifted(a, high)},
              Surface::Object, 0, room);
    }
    for (const double z : {low, high}) {
      const std::uint32_t first = result_.addVertex(lifted(corners[0], z));
      for (std::size_t i = 1; i < corners.size(); ++i) {
        const std::uint32_t next = result_.addVertex(lifted(corners[i], z));
        if (i > 1)
          result_.addFace({first, next - 1, next}, Surface::Object, Label::Other, room);
      }
    }
  }

  const Scene& scene_;
  SceneMesh& result_;
};

} // namespace

std::uint32_t
SceneMesh::addVertex(const Vec3& position)
{
  mesh.vertices.push_back(position);
  return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
}

void
SceneMesh::addFace(const Triangle& corners,
                   Surface surface,
                   Label label,
                   std::uint32_t room,
                   std::uint32_t opening)
{
  mesh.triangles.push_back(corners);
  mesh.labels.push_back(static_cast<std::uint32_t>(label));
  mesh.rooms.push_back(room);
  mesh.elements.push_back(opening);
  surfaces.push_back(surface);
}

SceneMesh
meshOf(const Scene& scene)
{
  const auto openings = openingsByRoom(scene);
  const auto floor_voids = floorVoidsOf(scene);
  SceneMesh result;
  SurroundingsMesher surroundings(scene, result);
  for (std::size_t i = 0; i < scene.rooms.size(); ++i) {
    const Room& room = scene.rooms[i];
    RoomPlan plan;
    try {
      plan = addRoom(room, static_cast<std::uint32_t>(i + 1), openings[i],
                     floor_voids[i], result);
    }
    catch (const std::invalid_argument& error) {
      fail(placeOf("rooms", i), " cannot be built: ", error.what());
    }
    for (std::size_t k = 0; k < room.openings.size(); ++k)
      surroundings.addReveal(room, plan, openings[i][k]);
    for (const CeilingVoid& hole : room.voids)
      if (hole.leads_to)
        surroundings.addShaft(room, hole);
    if (room.plenum > 0.0)
      surroundings.addPlenum(room, plan);
  }
  surroundings.addObjects(scene.furniture);
  surroundings.addObjects(scene.outside);
  return result;
}

TriangleMesh
truthOf(const SceneMesh& scene)
{
  std::vector<bool> keep;
  for (const Surface surface : scene.surfaces)
    keep.push_back(surface == Surface::Structure || surface == Surface::Gap);
  TriangleMesh truth = scene.mesh;
  truth.keepTriangles(keep);
  truth.removeUnusedVertices();
  return truth;
}

} // namespace pcl::sedr::sim
