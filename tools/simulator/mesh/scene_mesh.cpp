// SPDX-License-Identifier: BSD-3-Clause
#include "scene_mesh.h"

#include "room_cells.h"
#include "simulator/scene/queries.h"

#include <algorithm>
#include <stdexcept>

namespace pcl::sedr::sim {

namespace {

/** @brief Adds what is neither structure nor open to it: panes, furniture, and the
 * world outside. */
class SurroundingsMesher {
public:
  SurroundingsMesher(const Scene& scene, SceneMesh& result)
      : scene_(scene)
      , result_(result)
  {}

  /** @brief Adds the pane of an opening, in the middle of its reveal. */
  void addPane(const Room& room, const Opening& opening)
  {
    result_.panes.resize(std::max<std::size_t>(result_.panes.size(), opening.number));
    if (!opening.glazing)
      return;
    const Element face = faceOf(room, opening);
    result_.panes[opening.number - 1] = {*opening.glazing, !face.isArc()};
    const std::vector<double> ends = chordEnds(face);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      const Vec2 a = pointBeside(face, ends[i], 0.5 * opening.depth);
      const Vec2 b = pointBeside(face, ends[i + 1], 0.5 * opening.depth);
      addQuad({lifted(a, opening.sill), lifted(b, opening.sill),
               lifted(b, opening.head), lifted(a, opening.head)},
              Surface::Pane, opening.number);
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
  const auto floor_voids = floorVoidsOf(scene);
  SceneMesh result;
  SurroundingsMesher surroundings(scene, result);
  for (std::size_t i = 0; i < scene.rooms.size(); ++i) {
    const Room& room = scene.rooms[i];
    try {
      addRoom(room, static_cast<std::uint32_t>(i + 1),
              cellsOf(scene, i, floor_voids[i]), result);
    }
    catch (const std::invalid_argument& error) {
      fail(placeOf("rooms", i), " cannot be built: ", error.what());
    }
    for (const Opening& opening : room.openings)
      surroundings.addPane(room, opening);
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
