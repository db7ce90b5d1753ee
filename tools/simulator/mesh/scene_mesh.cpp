// SPDX-License-Identifier: BSD-3-Clause
#include "scene_mesh.h"

#include "room_cells.h"

#include <algorithm>
#include <stdexcept>

namespace pcl::sedr::sim {

namespace {

/** @brief Adds an upright rectangle over a line in plan. */
void
addUpright(const Vec2& a,
           const Vec2& b,
           double low,
           double high,
           const FaceLook& look,
           SceneMesh& scene)
{
  const std::uint32_t first = scene.addVertex(lifted(a, low));
  scene.addVertex(lifted(b, low));
  scene.addVertex(lifted(b, high));
  scene.addVertex(lifted(a, high));
  scene.addFace({first, first + 1, first + 2}, look);
  scene.addFace({first, first + 2, first + 3}, look);
}

/** @brief Adds the pane of an opening, in the middle of its reveal. */
void
addPane(const Room& room, const Opening& opening, SceneMesh& scene)
{
  scene.panes.resize(std::max<std::size_t>(scene.panes.size(), opening.number));
  if (!opening.glazing)
    return;
  const Element face = faceOf(room, opening);
  scene.panes[opening.number - 1] = {*opening.glazing, !face.isArc()};
  const std::vector<double> ends = chordEnds(face);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    addUpright(pointBeside(face, ends[i], 0.5 * opening.depth),
               pointBeside(face, ends[i + 1], 0.5 * opening.depth), opening.sill,
               opening.head, {Surface::Pane, Label::Other, 0, opening.number}, scene);
}

void
addPrism(const Prism& prism, std::uint32_t room, SceneMesh& scene)
{
  const FaceLook look{Surface::Object, Label::Other, room};
  const auto& [corners, low, high] = prism;
  for (std::size_t i = 0; i < corners.size(); ++i)
    addUpright(corners[i], corners[(i + 1) % corners.size()], low, high, look, scene);
  for (const double z : {low, high}) {
    const std::uint32_t first = scene.addVertex(lifted(corners[0], z));
    for (std::size_t i = 1; i < corners.size(); ++i) {
      const std::uint32_t next = scene.addVertex(lifted(corners[i], z));
      if (i > 1)
        scene.addFace({first, next - 1, next}, look);
    }
  }
}

void
addObject(const Object& object, const Scene& scene, SceneMesh& mesh)
{
  for (const Prism& part : object.parts) {
    Vec2 middle = Vec2::Zero();
    for (const Vec2& corner : part.corners)
      middle += corner / static_cast<double>(part.corners.size());
    addPrism(part, roomAt(scene, lifted(middle, 0.5 * (part.low + part.high))), mesh);
  }
}

} // namespace

std::uint32_t
SceneMesh::addVertex(const Vec3& position)
{
  mesh.vertices.push_back(position);
  return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
}

void
SceneMesh::addFace(const Triangle& corners, const FaceLook& look)
{
  mesh.triangles.push_back(corners);
  mesh.labels.push_back(static_cast<std::uint32_t>(look.label));
  mesh.rooms.push_back(look.room);
  mesh.elements.push_back(look.opening);
  surfaces.push_back(look.surface);
}

SceneMesh
meshOf(const Scene& scene)
{
  SceneMesh result;
  for (std::size_t i = 0; i < scene.rooms.size(); ++i) {
    try {
      addRoom(scene, i, result);
    }
    catch (const std::invalid_argument& error) {
      fail(placeOf("rooms", i), " cannot be built: ", error.what());
    }
    for (const Opening& opening : scene.rooms[i].openings)
      addPane(scene.rooms[i], opening, result);
  }
  for (const auto* objects : {&scene.furniture, &scene.outside})
    for (const Object& object : *objects)
      addObject(object, scene, result);
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
