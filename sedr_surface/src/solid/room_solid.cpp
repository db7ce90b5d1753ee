// SPDX-License-Identifier: BSD-3-Clause
#include "../triangulation/triangulation.h"
#include "plan_subdivision.h"
#include "room_layers.h"
#include "sedr_filters/src/plan/plan_check.h"
#include "sedr_filters/src/walls/plan_walls.h"

#include <pcl/sedr_surface/floorplan_extrusion.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace pcl::sedr {
namespace {

/** @brief Builds the surface of a room from the subdivision of its plan: a face per
 * slab and region, and vertical strips on the edges. */
class SolidBuilder {
public:
  SolidBuilder(const RoomLayers& layers, const PlanSubdivision& plan)
      : layers_(layers)
      , plan_(plan)
      , levels_(levelsOf(layers, plan))
  {}

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
    PlanEdges rim; // of the slab's regions
    bool faces_up = false;
    for (const SubdivisionEdge& edge : plan_.edges) {
      if (edge.left.has(slab) == edge.right.has(slab))
        continue;
      faces_up = edge.left.ceiling == slab || edge.right.ceiling == slab;
      rim.emplace_back(edge.a, edge.b);
    }
    PlanEdges folds;
    for (const SubdivisionCrease& crease : plan_.creases)
      if (crease.slab == slab)
        folds.emplace_back(crease.a, crease.b);
    // A corner that was cut off may lie on a crease; then the curve has no creases.
    const auto faces = trianglesWithin(plan_.vertices, rim, folds);
    if (!faces)
      return false;
    for (const auto& face : *faces) {
      std::array<Corner, 3> corners;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t v = face[faces_up ? i : 2 - i];
        corners[i] = {v, levelOf(slab, v)};
      }
      addTriangle(corners, layers_.slabs[static_cast<std::size_t>(slab)].element);
    }
    return true;
  }

  /** @brief Returns the level of a slab at a vertex, which may be inside the slab. */
  std::int64_t levelOf(int slab, std::uint32_t vertex) const
  {
    const PlanSlab& own = layers_.slabs[static_cast<std::size_t>(slab)].slab;
    return levels_[vertex].levelOf(
        slab, std::llround(own.heightAt(plan_.placeOf(vertex)) / plan_.grid.unit()));
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
    if (at_a.empty() || at_b.empty()) // its slabs cross: the solid stays open there
      return;
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
    const auto low = std::lower_bound(levels.begin(), levels.end(),
                                      levels_[vertex].levelOf(low_slab));
    return {low, std::max(low, std::upper_bound(levels.begin(), levels.end(),
                                                levels_[vertex].levelOf(high_slab)))};
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

/** @brief Sums the areas of triangles by label and orientation.
 * @param first number of the first element of the layers */
void
measure(const TriangleMesh& solid,
        const RoomLayers& layers,
        std::uint32_t first,
        RoomSolidReport& report)
{
  std::size_t flat = 0;
  for (std::size_t t = 0; t < solid.triangles.size(); ++t) {
    const Eigen::Vector3d normal = solid.scaledNormal(t);
    const double area = normal.norm() / 2;
    const auto label = static_cast<StructureLabel>(solid.labels[t]);
    report.area += area;
    flat += area > 0 ? 0 : 1;
    if (label == StructureLabel::Wall || label == StructureLabel::Column ||
        layers.roleOf(solid.elements[t] - first) == LoopRole::NicheSide)
      report.wall_area += area;
    else if (label == StructureLabel::Detail && std::abs(normal.z()) < area) // vertical
      report.riser_area += area;
    else
      (normal.z() < 0 ? report.floor_area : report.ceiling_area) += area;
  }
  report.triangles = solid.triangles.size();
  report.volume = solid.signedVolume();
  report.topology = checkTopology(solid);
  report.closed = report.topology.isClosedManifold() && flat == 0;
  if (!report.topology.isClosedManifold())
    report.problem = "its solid is not closed: " + report.topology.problem();
  else if (flat > 0)
    report.problem = "its solid has triangles without area: " + std::to_string(flat);
}

} // namespace

RoomSolidReport
extrudeRoom(const PlanRoom& room,
            const SolidParameters& parameters,
            TriangleMesh& solid,
            std::vector<SolidElement>& elements)
{
  solid = TriangleMesh();
  RoomSolidReport report;
  report.room = room.id;
  report.problem = roomProblem(room);
  if (!report.problem.empty())
    return report;
  const bool is_tilted = isTilted(room);
  const PlanRoom straight = is_tilted ? verticalAtHead(room) : PlanRoom();
  const RoomLayers layers(is_tilted ? straight : room);
  PlanSubdivision subdivision;
  report.problem = subdivideRoom(layers, parameters, subdivision, report.warnings);
  if (report.problem.empty())
    report.problem = SolidBuilder(layers, subdivision).build(solid);
  if (report.problem.empty() && is_tilted) {
    const std::string folded = tiltSolid(layers, room, solid);
    if (!folded.empty()) {
      report = extrudeRoom(withVerticalWalls(room), parameters, solid, elements);
      report.warnings.push_back(
          warningOf(WarningKind::Contradiction,
                    "its walls stand vertical in the solid: " + folded));
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
  measure(solid, layers, first, report);
  return report;
}

} // namespace pcl::sedr
