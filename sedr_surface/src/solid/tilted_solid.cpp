// SPDX-License-Identifier: BSD-3-Clause
#include "room_layers.h"

#include "../mesh/mesh_repair.h"
#include "../triangulation/triangulation.h"
#include "sedr_filters/src/plan/plan_geometry.h"
#include "sedr_filters/src/walls/plan_walls.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace pcl::sedr {
namespace {

/** @brief A surface that a vertex lies on. */
struct Surface {
  const PlanSlab* slab = nullptr;       ///< a floor or ceiling
  const PlanElement* element = nullptr; ///< else an element of a loop
  double run = 0; ///< tilt of a wall, metres into the room per metre of height
  double off = 0; ///< initial offset of the vertex, from rounding of the plan

  /** @brief Returns the offset of a place, and its gradient. */
  double offset(const Eigen::Vector3d& p, double head, Eigen::Vector3d& way) const
  {
    if (slab) {
      const Eigen::Vector3d normal = slab->normalAt(p.head<2>());
      way = normal;
      return (p.z() - slab->heightAt(p.head<2>())) * normal.z() - off;
    }
    Eigen::Vector2d across;
    const double out = offLine(*element, p.head<2>(), across);
    way << across, -run;
    return out - run * (p.z() - head) - off;
  }
};

class TiltedSolid {
public:
  TiltedSolid(const RoomLayers& layers, const PlanRoom& room, TriangleMesh& solid)
      : layers_(layers)
      , room_(room)
      , head_(headOf(room))
      , solid_(solid)
  {}

  std::string run()
  {
    const std::vector<bool> faced_up = facingUp();
    std::vector<std::set<std::uint32_t>> elements(solid_.vertices.size());
    for (std::size_t t = 0; t < solid_.triangles.size(); ++t)
      for (const std::uint32_t v : solid_.triangles[t])
        elements[v].insert(solid_.elements[t]);
    for (std::size_t v = 0; v < elements.size(); ++v)
      move(elements[v], solid_.vertices[v]);
    return unfold(faced_up);
  }

private:
  Surface surfaceOf(std::size_t element) const
  {
    for (const RoomLayers::Slab& slab : layers_.slabs)
      if (slab.element == element)
        return {&slab.slab};
    for (const RoomLayers::Loop& loop : layers_.loops) {
      const std::size_t n = loop.loop->elements.size();
      if (element < loop.first_element || element >= loop.first_element + n)
        continue;
      const std::size_t i = element - loop.first_element;
      const bool is_wall = &loop == &layers_.loops.front();
      return {nullptr, &loop.loop->elements[i],
              is_wall ? std::tan(room_.boundary.elements[i].tilt) : 0};
    }
    return {};
  }

  void move(const std::set<std::uint32_t>& elements, Eigen::Vector3d& vertex) const
  {
    constexpr int rounds = 30;
    std::vector<Surface> surfaces;
    bool is_tilted = false;
    for (const std::uint32_t element : elements) {
      surfaces.push_back(surfaceOf(element));
      is_tilted = is_tilted || surfaces.back().run != 0;
    }
    if (!is_tilted)
      return;
    Eigen::Vector3d way;
    for (Surface& surface : surfaces) {
      const double run = std::exchange(surface.run, 0);
      surface.off = surface.offset(vertex, head_, way);
      surface.run = run;
    }
    const auto count = static_cast<Eigen::Index>(surfaces.size());
    Eigen::MatrixXd ways(count, 3);
    Eigen::VectorXd offsets(count);
    for (int round = 0; round < rounds; ++round) {
      for (Eigen::Index k = 0; k < count; ++k) {
        offsets[k] = surfaces[static_cast<std::size_t>(k)].offset(vertex, head_, way);
        ways.row(k) = way;
      }
      // Nearly parallel surfaces do not determine the position along them.
      Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
      solver.setThreshold(1e-3);
      solver.compute(ways);
      const Eigen::Vector3d step = solver.solve(offsets);
      vertex -= step;
      if (step.norm() < 1e-13)
        break;
    }
  }

  std::vector<bool> facingUp() const
  {
    std::vector<bool> faces_up(solid_.triangles.size());
    for (std::size_t t = 0; t < faces_up.size(); ++t)
      faces_up[t] = solid_.scaledNormal(t).z() > 0;
    return faces_up;
  }

  /** @brief Triangulates the slabs again that have a triangle turned over. */
  std::string unfold(const std::vector<bool>& faced_up)
  {
    const std::vector<bool> faces_up = facingUp();
    for (const RoomLayers::Slab& slab : layers_.slabs) {
      bool is_folded = false;
      bool is_ceiling = false;
      for (std::size_t t = 0; t < faced_up.size(); ++t)
        if (solid_.elements[t] == slab.element) {
          is_folded = is_folded || faces_up[t] != faced_up[t];
          is_ceiling = faced_up[t];
        }
      const std::string& name = layers_.elements[slab.element].name;
      if (is_folded && (slab.slab.curve || !triangulate(slab.element, is_ceiling)))
        return name + " would be folded by tilted walls";
    }
    return {};
  }

  bool triangulate(std::size_t element, bool faces_up)
  {
    std::vector<Triangle> old;
    for (std::size_t t = 0; t < solid_.triangles.size(); ++t)
      if (solid_.elements[t] == element)
        old.push_back(solid_.triangles[t]);
    const std::set<MeshEdge> rim = rimOf(old);
    Eigen::AlignedBox2d box;
    for (const MeshEdge& edge : rim)
      box.extend(solid_.vertices[edge.first].head<2>().eval());
    const PlanGrid grid(box);
    std::vector<GridPoint> points(solid_.vertices.size());
    for (const MeshEdge& edge : rim)
      points[edge.first] = grid.toGrid(solid_.vertices[edge.first].head<2>());
    const auto faces = trianglesWithin(points, {rim.begin(), rim.end()});
    if (!faces || faces->size() != old.size())
      return false; // only if the rim crosses itself
    auto face = faces->begin();
    for (std::size_t t = 0; t < solid_.triangles.size(); ++t)
      if (solid_.elements[t] == element) {
        solid_.triangles[t] = *face++;
        if (!faces_up)
          std::swap(solid_.triangles[t][0], solid_.triangles[t][2]);
      }
    return true;
  }

  const RoomLayers& layers_;
  const PlanRoom& room_;
  const double head_;
  TriangleMesh& solid_;
};

/** @brief Returns the corners of a loop, and points between those of arcs. */
std::vector<Eigen::Vector2d>
cornersOf(const PlanLoop& loop)
{
  std::vector<Eigen::Vector2d> corners;
  for (const PlanElement& e : loop.elements)
    for (int k = 0, parts = e.isArc() ? 32 : 1; k < parts; ++k)
      corners.push_back(e.pointAt(e.length() * k / parts));
  return corners;
}

/** @brief Moves a place with the corners of a polygon, by mean value coordinates
 * (Hormann and Floater 2006): what is on an edge stays on it. */
Eigen::Vector2d
movedWith(const std::vector<Eigen::Vector2d>& from,
          const std::vector<Eigen::Vector2d>& to,
          const Eigen::Vector2d& p)
{
  const std::size_t n = from.size();
  std::vector<double> weights(n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    const Eigen::Vector2d a = from[i] - p;
    const Eigen::Vector2d b = from[j] - p;
    const double dot = a.norm() * b.norm() + a.dot(b);
    const double area = cross(a, b);
    if (dot < 1e-9 || a.norm() < 1e-9) // on the edge or its start
      return to[i] + a.norm() / std::max(1e-9, a.norm() + b.norm()) * (to[j] - to[i]);
    const double half = area / dot; // tangent of half of the angle
    weights[i] += half / a.norm();
    weights[j] += half / b.norm();
  }
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double all = 0;
  for (std::size_t i = 0; i < n; ++i) {
    sum += weights[i] * to[i];
    all += weights[i];
  }
  return std::abs(all) > 1e-12 ? Eigen::Vector2d(sum / all) : p;
}

} // namespace

PlanRoom
verticalAtHead(const PlanRoom& room)
{
  PlanRoom straight = room;
  straight.boundary = boundaryAt(room, headOf(room));
  straight = withVerticalWalls(std::move(straight));
  const std::vector<Eigen::Vector2d> head = cornersOf(straight.boundary);
  const auto move = [&](PlanLoop& loop, const PlanSlab& slab) {
    for (PlanElement& element : loop.elements)
      for (Eigen::Vector2d* end : {&element.start, &element.end})
        if (!element.isArc()) {
          const auto corners = cornersOf(boundaryAt(room, slab.heightAt(*end)));
          if (corners.size() == head.size()) // no cone ends below it
            *end = movedWith(corners, head, *end);
        }
  };
  for (auto* const details : {&straight.details, &straight.floor_details})
    for (PlanDetail& detail : *details) {
      move(detail.boundary, detail.slab);
      for (PlanLoop& hole : detail.holes)
        move(hole, detail.slab);
    }
  return straight;
}

std::string
tiltSolid(const RoomLayers& layers, const PlanRoom& room, TriangleMesh& solid)
{
  return TiltedSolid(layers, room, solid).run();
}

} // namespace pcl::sedr
