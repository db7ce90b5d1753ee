// SPDX-License-Identifier: BSD-3-Clause
#include "../triangulation/constrained_triangulation.h"
#include "plan_subdivision.h"
#include "sedr_filters/src/plan/plan_check.h"
#include "sedr_surface/src/solid/room_layers.h"
#include "vertex_levels.h"

#include <pcl/sedr_filters/straightening.h>
#include <pcl/sedr_surface/room_solid.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <Eigen/QR>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace pcl::sedr {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

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
    double out = 0;
    if (element->isArc()) {
      const double sign = element->counter_clockwise ? -1 : 1;
      const Eigen::Vector2d from = p.head<2>() - element->centre;
      across = sign * from.normalized();
      out = sign * (from.norm() - element->radius);
    }
    else {
      across = element->normalAt(0);
      out = (p.head<2>() - element->start).dot(across);
    }
    way << across, -run;
    return out - run * (p.z() - head) - off;
  }
};

class TiltedSolid {
public:
  TiltedSolid(const RoomLayers& layers,
              const std::vector<double>& runs,
              double head,
              TriangleMesh& solid)
      : layers_(layers)
      , runs_(runs)
      , head_(head)
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
      return {nullptr, &loop.loop->elements[i], is_wall ? runs_[i] : 0};
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
    std::set<Edge> rim; // directed
    for (std::size_t t = 0; t < solid_.triangles.size(); ++t)
      for (std::size_t i = 0; solid_.elements[t] == element && i < 3; ++i) {
        const Edge edge(solid_.triangles[t][i], solid_.triangles[t][(i + 1) % 3]);
        if (rim.erase({edge.second, edge.first}) == 0)
          rim.insert(edge);
      }
    Eigen::AlignedBox2d box;
    for (const Edge& edge : rim)
      box.extend(solid_.vertices[edge.first].head<2>().eval());
    const PlanGrid grid(box);
    std::map<std::uint32_t, std::uint32_t> number;
    std::vector<std::uint32_t> vertices;
    std::vector<GridPoint> points;
    for (const Edge& edge : rim)
      if (number.emplace(edge.first, points.size()).second) {
        vertices.push_back(edge.first);
        points.push_back(grid.toGrid(solid_.vertices[edge.first].head<2>()));
      }
    std::vector<Edge> edges;
    for (const Edge& edge : rim)
      edges.push_back(std::minmax(number[edge.first], number[edge.second]));
    PlanTriangulation faces;
    if (!triangulateConstrained(points, edges, faces))
      return false;
    const std::vector<bool> is_inside = insideOf(faces, edges);
    std::vector<Triangle> inside;
    for (std::size_t f = 0; f < faces.triangles.size(); ++f) {
      if (!is_inside[f])
        continue;
      Triangle triangle;
      for (std::size_t i = 0; i < 3; ++i)
        triangle[i] = vertices[faces.triangles[f][faces_up ? i : 2 - i]];
      inside.push_back(triangle);
    }
    std::size_t next = 0;
    for (std::size_t t = 0; t < solid_.triangles.size(); ++t)
      if (solid_.elements[t] == element) {
        if (next == inside.size())
          return false; // only if the rim crosses itself
        solid_.triangles[t] = inside[next++];
      }
    return next == inside.size();
  }

  const RoomLayers& layers_;
  const std::vector<double>& runs_;
  const double head_;
  TriangleMesh& solid_;
};

/** @brief Tilts walls of a solid that was built with vertical ones. Every vertex moves
 * to the intersection of its surfaces (walls, ceilings, floors, risers) by Newton's
 * method. Floors and ceilings that would fold are triangulated again. The adjacency of
 * surfaces does not change.
 * @param layers of the room with vertical walls, which are exact at height `head`
 * @param runs of each wall: metres into the room per metre of height
 * @param[in,out] solid with indices into layers.elements
 * @return an empty string, or what cannot be built, as the end of a sentence */
std::string
tiltWalls(const RoomLayers& layers,
          const std::vector<double>& runs,
          double head,
          TriangleMesh& solid)
{
  return TiltedSolid(layers, runs, head, solid).run();
}

/** @brief Builds the surface of a room from the subdivision of its plan: a face per
 * slab and region, and vertical strips on the edges. */
class SolidBuilder {
public:
  SolidBuilder(const RoomLayers& layers, const PlanSubdivision& plan)
      : layers_(layers)
      , plan_(plan)
  {
    const auto spokes = spokesOf(plan);
    for (std::uint32_t v = 0; v < spokes.size(); ++v)
      levels_.emplace_back(layers, plan, v, spokes[v]);
  }

  /** @brief Fills `mesh` with triangles that have label and, from 0, element.
   * @return an empty string, or why there is no solid */
  std::string build(TriangleMesh& mesh)
  {
    for (std::size_t slab = 0; slab < layers_.slabs.size(); ++slab)
      if (!addSlab(static_cast<int>(slab)))
        return layers_.elements[layers_.slabs[slab].element].name +
               " could not be triangulated";
    for (const SubdivisionEdge& edge : plan_.edges)
      addVertical(edge);
    mesh = std::move(mesh_);
    return {};
  }

private:
  /** @brief A possible vertex of the solid. */
  using Corner = std::pair<std::uint32_t, std::int64_t>; ///< plan vertex, level

  /** @brief Adds the face of a slab.
   * @return false if it could not be triangulated */
  bool addSlab(int slab)
  {
    // The rim of the slab's regions, with renumbered vertices.
    std::vector<std::uint32_t> number(plan_.vertices.size(), PlanTriangulation::none);
    std::vector<std::uint32_t> vertices;
    std::vector<GridPoint> points;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> rim;
    bool faces_up = false;
    const auto numberOf = [&](std::uint32_t v) {
      if (number[v] == PlanTriangulation::none) {
        number[v] = static_cast<std::uint32_t>(points.size());
        points.push_back(plan_.vertices[v]);
        vertices.push_back(v);
      }
      return number[v];
    };
    for (const SubdivisionEdge& edge : plan_.edges) {
      if (edge.left.has(slab) == edge.right.has(slab))
        continue;
      faces_up = edge.left.ceiling == slab || edge.right.ceiling == slab;
      const std::uint32_t a = numberOf(edge.a);
      const std::uint32_t b = numberOf(edge.b);
      rim.push_back(std::minmax(a, b));
    }
    std::sort(rim.begin(), rim.end());
    std::vector<std::pair<std::uint32_t, std::uint32_t>> folds = rim;
    for (const SubdivisionCrease& crease : plan_.creases)
      if (crease.slab == slab) {
        const std::uint32_t a = numberOf(crease.a);
        const std::uint32_t b = numberOf(crease.b);
        folds.push_back(std::minmax(a, b));
      }
    std::sort(folds.begin(), folds.end());
    PlanTriangulation faces;
    // A corner that was cut off may lie on a crease; then the curve has no creases.
    if (!triangulateConstrained(points, folds, faces) &&
        !triangulateConstrained(points, rim, faces))
      return false;
    const std::vector<bool> is_inside = insideOf(faces, rim);
    for (std::size_t t = 0; t < faces.triangles.size(); ++t) {
      if (!is_inside[t])
        continue;
      std::array<Corner, 3> corners;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t v = vertices[faces.triangles[t][faces_up ? i : 2 - i]];
        corners[i] = {v, levelOf(slab, v)};
      }
      addTriangle(corners, layers_.slabs[static_cast<std::size_t>(slab)].element);
    }
    return true;
  }

  /** @brief Returns the level of a slab at a vertex, which may be inside the slab. */
  std::int64_t levelOf(int slab, std::uint32_t vertex) const
  {
    if (levels_[vertex].has(slab))
      return levels_[vertex].levelOf(slab);
    const PlanSlab& own = layers_.slabs[static_cast<std::size_t>(slab)].slab;
    return std::llround(own.heightAt(plan_.placeOf(vertex)) / plan_.grid.unit());
  }

  /** @brief Adds the vertical strips on an edge, where exactly one side is solid. */
  void addVertical(const SubdivisionEdge& edge)
  {
    // Slabs do not cross along an edge, so the sum of both heights orders them.
    const auto heightOf = [&](int slab) {
      return levels_[edge.a].levelOf(slab) + levels_[edge.b].levelOf(slab);
    };
    std::vector<std::pair<std::int64_t, int>> slabs;
    for (const PlanRegion* side : {&edge.left, &edge.right})
      for (const int slab : {side->floor, side->ceiling})
        if (slab != PlanRegion::nothing)
          slabs.emplace_back(heightOf(slab), slab);
    std::sort(slabs.begin(), slabs.end());
    const auto isSolid = [&](const PlanRegion& side, std::int64_t above) {
      return side.isRoom() && heightOf(side.floor) <= above &&
             above < heightOf(side.ceiling);
    };
    for (std::size_t k = 0; k + 1 < slabs.size(); ++k) {
      const std::int64_t height = slabs[k].first;
      const bool on_left = isSolid(edge.left, height);
      if (slabs[k + 1].first == height || on_left == isSolid(edge.right, height))
        continue;
      const PlanRegion& solid = on_left ? edge.left : edge.right;
      const PlanRegion& other = on_left ? edge.right : edge.left;
      const bool is_above = other.isRoom() && height >= heightOf(other.ceiling);
      addStrip(on_left ? edge.a : edge.b, on_left ? edge.b : edge.a, slabs[k].second,
               slabs[k + 1].second, elementOn(edge, rolesOn(solid, other, is_above)));
    }
  }

  /** @brief Adds the strip over the line from a to b between two slabs, with the solid
   * on its left. Its ends include all levels there, like the adjacent strips. */
  void addStrip(std::uint32_t a,
                std::uint32_t b,
                int low_slab,
                int high_slab,
                std::size_t element)
  {
    const auto at_a = levelsBetween(a, low_slab, high_slab);
    const auto at_b = levelsBetween(b, low_slab, high_slab);
    std::size_t i = 0;
    std::size_t j = 0;
    while (i + 1 < at_a.size() || j + 1 < at_b.size()) {
      const bool climbs_b =
          i + 1 == at_a.size() || (j + 1 < at_b.size() && at_b[j + 1] <= at_a[i + 1]);
      const Corner low_a{a, at_a[i]};
      const Corner low_b{b, at_b[j]};
      const Corner next = climbs_b ? Corner{b, at_b[++j]} : Corner{a, at_a[++i]};
      addTriangle({low_a, low_b, next}, element);
    }
  }

  std::vector<std::int64_t>
  levelsBetween(std::uint32_t vertex, int low_slab, int high_slab) const
  {
    const auto& levels = levels_[vertex].levels();
    return {std::lower_bound(levels.begin(), levels.end(),
                             levels_[vertex].levelOf(low_slab)),
            std::upper_bound(levels.begin(), levels.end(),
                             levels_[vertex].levelOf(high_slab))};
  }

  /** @brief Returns the possible roles of a strip that separates solid from empty
   * space.
   * @param above whether it reaches up from the other side's ceiling */
  std::vector<LoopRole>
  rolesOn(const PlanRegion& solid, const PlanRegion& other, bool above) const
  {
    if (layers_.isNiche(solid))
      return {LoopRole::NicheSide};
    if (!other.isRoom())
      return {LoopRole::Wall, LoopRole::ColumnFace};
    if (layers_.isNiche(other)) // above or below the niche
      return {LoopRole::Wall};
    return {above ? LoopRole::CeilingRiser : LoopRole::FloorRiser};
  }

  /** @brief Returns the element on an edge with one of the roles. If there is none,
   * because a sliver was merged, returns the nearest. */
  std::size_t elementOn(const SubdivisionEdge& edge,
                        const std::vector<LoopRole>& roles) const
  {
    // The last, because the later of two details counts.
    for (const LoopRole role : roles)
      for (auto e = edge.elements.rbegin(); e != edge.elements.rend(); ++e)
        if (layers_.roleOf(*e) == role)
          return *e;
    const Eigen::Vector2d middle = (plan_.placeOf(edge.a) + plan_.placeOf(edge.b)) / 2;
    std::size_t nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (const auto& loop : layers_.loops) {
      if (std::find(roles.begin(), roles.end(), loop.role) == roles.end())
        continue;
      for (std::size_t i = 0; i < loop.loop->elements.size(); ++i) {
        const double d = loop.loop->elements[i].distance(middle);
        if (d >= least)
          continue;
        least = d;
        nearest = loop.first_element + i;
      }
    }
    return nearest;
  }

  void addTriangle(const std::array<Corner, 3>& corners, std::size_t element)
  {
    Triangle triangle;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto next = static_cast<std::uint32_t>(mesh_.vertices.size());
      const auto [known, is_new] = vertex_.emplace(corners[i], next);
      if (is_new) {
        const Eigen::Vector2d place = plan_.placeOf(corners[i].first);
        mesh_.vertices.emplace_back(place.x(), place.y(),
                                    plan_.grid.unit() *
                                        static_cast<double>(corners[i].second));
      }
      triangle[i] = known->second;
    }
    mesh_.triangles.push_back(triangle);
    mesh_.labels.push_back(static_cast<std::uint32_t>(layers_.elements[element].label));
    mesh_.elements.push_back(static_cast<std::uint32_t>(element));
  }

  const RoomLayers& layers_;
  const PlanSubdivision& plan_;
  std::vector<VertexLevels> levels_;
  std::map<Corner, std::uint32_t> vertex_;
  TriangleMesh mesh_;
};

/** @brief Sums the areas of triangles by label and orientation. */
void
measure(const TriangleMesh& solid, RoomSolidReport& report)
{
  for (std::size_t t = 0; t < solid.triangles.size(); ++t) {
    const Eigen::Vector3d normal = solid.scaledNormal(t);
    const double area = normal.norm() / 2;
    const auto label = static_cast<StructureLabel>(solid.labels[t]);
    report.area += area;
    if (label == StructureLabel::Wall || label == StructureLabel::Column)
      report.wall_area += area;
    else if (label == StructureLabel::Detail && std::abs(normal.z()) < area) // vertical
      report.riser_area += area;
    else
      (normal.z() < 0 ? report.floor_area : report.ceiling_area) += area;
  }
  report.triangles = solid.triangles.size();
  report.volume = solid.signedVolume();
  report.topology = checkTopology(solid);
  report.closed = report.topology.isClosedManifold();
  if (!report.closed)
    report.problem = "its solid is not closed: " + report.topology.problem();
}

} // namespace

RoomSolidReport
extrudeRoom(const PlanRoom& room,
            const SolidParameters& parameters,
            TriangleMesh& solid,
            std::vector<SolidElement>& elements,
            const WallTilts& tilts)
{
  solid = TriangleMesh();
  RoomSolidReport report;
  report.room = room.id;
  report.problem = roomProblem(room);
  if (!report.problem.empty())
    return report;
  const bool is_tilted = isTilted(room, tilts);
  const PlanRoom straight =
      is_tilted ? straightened(Floorplan{{room}}, tilts).rooms.front() : PlanRoom();
  const RoomLayers layers(is_tilted ? straight : room);
  PlanSubdivision subdivision;
  report.problem = subdivideRoom(layers, parameters, subdivision, report.warnings);
  if (report.problem.empty())
    report.problem = SolidBuilder(layers, subdivision).build(solid);
  if (report.problem.empty() && is_tilted) {
    const std::string folded =
        tiltWalls(layers, wallRuns(room, tilts), headOf(room, tilts), solid);
    if (!folded.empty()) {
      report = extrudeRoom(room, parameters, solid, elements);
      report.warnings.push_back({WarningKind::Contradiction,
                                 {},
                                 0,
                                 0,
                                 "its walls stand vertical in the solid: " + folded});
      return report;
    }
  }
  if (!report.problem.empty()) {
    solid = TriangleMesh();
    return report;
  }
  const auto first = static_cast<std::uint32_t>(elements.size()) + 1;
  for (auto& element : solid.elements)
    element += first;
  solid.rooms.assign(solid.triangles.size(), room.id);
  elements.insert(elements.end(), layers.elements.begin(), layers.elements.end());
  measure(solid, report);
  return report;
}

} // namespace pcl::sedr
