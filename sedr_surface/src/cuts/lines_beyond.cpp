// SPDX-License-Identifier: BSD-3-Clause
#include "cut_drawing.h"

#include "../mesh/mesh_outlines.h"
#include "sedr_filters/src/plan/plan_geometry.h"
#include "sedr_filters/src/walls/plan_walls.h"

#include <pcl/sedr_surface/impl/floorplan_extrusion.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace pcl::sedr {
namespace {

/** @brief Adds the treads and risers of a flight, each an element of its own, the first
 * one behind `element`. */
void
addFlight(const PlanFlight& flight, TriangleMesh& mesh, std::uint32_t& element)
{
  auto v = static_cast<std::uint32_t>(mesh.vertices.size());
  for (std::size_t k = 0; k < flight.steps(); ++k)
    for (const std::size_t step : {k, k + 1})
      for (const Eigen::Vector2d& end : flight.risers[k])
        mesh.vertices.emplace_back(
            end.x(), end.y(), flight.bottom + flight.rise * static_cast<double>(step));
  for (; v + 3 < mesh.vertices.size(); v += 2) {
    mesh.triangles.insert(mesh.triangles.end(), {{v, v + 1, v + 3}, {v, v + 3, v + 2}});
    mesh.elements.resize(mesh.triangles.size(), ++element);
  }
}

/** @brief Returns the treads and risers of stairs that the plane cuts. */
std::vector<PlanLine>
stairsOn(const Floorplan& plan, const SectionLine& line)
{
  std::vector<PlanLine> lines;
  const Eigen::Vector2d way = (line.to - line.from).normalized();
  const auto add = [&](double x, double z, double to_x, double to_z) {
    lines.push_back({segment({x, z}, {to_x, to_z}), PlanLayer::Stair});
  };
  for (const PlanStair& stair : plan.stairs)
    for (const PlanFlight& flight : stair.flights)
      for (std::size_t k = 0; k + 1 < flight.steps(); ++k) {
        const auto& [a, b] = flight.risers[k];
        const auto& [c, d] = flight.risers[k + 1];
        const bool climbs = way.dot(flight.middle(k + 1) - flight.middle(k)) > 0;
        const double z = flight.bottom + flight.rise * static_cast<double>(k + 1);
        for (const auto& [from, to] : rangesIn(loopOf({a, b, d, c}), line)) {
          const double low = climbs ? from : to;
          const double high = climbs ? to : from;
          add(low, z - flight.rise, low, z);
          add(low, z, high, z);
          if (k + 2 == flight.steps())
            add(high, z, high, z + flight.rise);
        }
      }
  return lines;
}

/** @brief What a viewer at a vertical plane sees behind it of some surfaces. Places are
 * along the line, height, and depth behind the plane. */
class ViewBeyond {
public:
  ViewBeyond(const TriangleMesh& mesh,
             const SectionLine& line,
             const std::vector<PlanArea>& air,
             std::vector<PlanLine> drawn)
      : mesh_(mesh)
      , line_(line)
      , way_((line.to - line.from).normalized())
      , air_(air)
      , lines_(std::move(drawn))
  {
    constexpr double no_area = 1e-9; // such faces are seen from their edge
    for (const Eigen::Vector3d& p : mesh.vertices)
      places_.push_back(placeOf(p));
    for (const Triangle& corners : mesh.triangles) {
      Eigen::AlignedBox3d box;
      for (const std::uint32_t corner : corners)
        box.extend(places_[corner]);
      const Eigen::Vector3d& a = places_[corners[0]];
      const Eigen::Vector3d normal =
          (places_[corners[1]] - a).cross(places_[corners[2]] - a);
      if (box.max().z() > 0 && std::abs(normal.z()) > no_area)
        for (long k = tileOf(box.min().x()); k <= tileOf(box.max().x()); ++k)
          for (long l = tileOf(box.min().y()); l <= tileOf(box.max().y()); ++l)
            tiles_[{k, l}].push_back({corners, normal});
    }
  }

  Eigen::Vector3d placeOf(const Eigen::Vector3d& p) const
  {
    const Eigen::Vector2d off = p.head<2>() - line_.from;
    return {way_.dot(off), p.z(), depthOf(off)};
  }

  /** @brief Returns how far a way in plan leads away from the viewer. */
  double depthOf(const Eigen::Vector2d& way) const { return leftOf(way_).dot(way); }

  /** @brief Adds what is seen of a straight edge behind the plane. */
  void addEdge(Eigen::Vector3d from, Eigen::Vector3d to, PlanLayer layer)
  {
    constexpr double shortest = 0.01; // metres
    if (from.z() > to.z())
      std::swap(from, to);
    if (to.z() <= 0)
      return;
    if (from.z() < 0)
      from += from.z() / (from.z() - to.z()) * (to - from);
    const PlanElement edge = segment(from.head<2>(), to.head<2>());
    const double length = edge.length();
    if (length < shortest)
      return;
    const auto isShown = [&](double s) {
      const Eigen::Vector3d p = from + s / length * (to - from);
      return isInAir(p.head<2>()) && isSeen(p);
    };
    for (const PlanElement& part : partsWhere(edge, isShown))
      if (part.length() > shortest && !isDrawn(part))
        lines_.push_back({part, layer});
  }

  /** @brief Adds the edges between elements, the ends of open surfaces, and those of
   * curved walls where they turn away.
   * @param layer_of an element */
  template <typename LayerOf>
  void addEdges(const LayerOf& layer_of)
  {
    std::map<Edge, std::vector<std::size_t>> beside;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k)
        beside[std::minmax(mesh_.triangles[t][k], mesh_.triangles[t][(k + 1) % 3])]
            .push_back(t);
    for (const auto& [edge, triangles] : beside)
      if (isLine(edge, triangles))
        addEdge(places_[edge.first], places_[edge.second],
                layer_of(mesh_.elements[triangles[0]]));
  }

  std::vector<PlanLine> lines() && { return std::move(lines_); }

private:
  using Edge = std::pair<std::uint32_t, std::uint32_t>;

  struct Face {
    Triangle corners;
    Eigen::Vector3d normal;
  };

  bool isLine(const Edge& edge, const std::vector<std::size_t>& triangles) const
  {
    constexpr double flat = 0.985; // cosine of 10 degrees
    if (triangles.size() == 1)
      return true;
    const Eigen::Vector3d normal = mesh_.scaledNormal(triangles[0]).normalized();
    const Eigen::Vector3d beyond = mesh_.scaledNormal(triangles[1]).normalized();
    const bool is_border = mesh_.elements[triangles[0]] != mesh_.elements[triangles[1]];
    const bool turns_away = isUpright(edge) && isTowards(normal) != isTowards(beyond);
    return turns_away || (is_border && normal.dot(beyond) <= flat);
  }

  bool isUpright(const Edge& edge) const
  {
    const Eigen::Vector3d way = places_[edge.second] - places_[edge.first];
    return std::abs(way.y()) > 0.99 * way.norm();
  }

  /** @brief Returns whether a face looks along the depth; one seen from its edge does
   * not. */
  bool isTowards(const Eigen::Vector3d& normal) const
  {
    return depthOf(normal.head<2>()) > 1e-6;
  }

  static long tileOf(double along)
  {
    constexpr double width = 0.25; // metres
    return static_cast<long>(std::floor(along / width));
  }

  /** @brief Returns whether a line before this one covers it, as those of both sides of
   * a stair do. */
  bool isDrawn(const PlanElement& part) const
  {
    constexpr double same = 0.001; // metres
    return std::any_of(lines_.begin(), lines_.end(), [&](const PlanLine& line) {
      return line.element.distance(part.start) < same &&
             line.element.distance(part.end) < same;
    });
  }

  /** @brief Returns whether a place is within the air that is cut, off its outline. */
  bool isInAir(const Eigen::Vector2d& p) const
  {
    constexpr double on_cut = 0.005; // metres
    return std::any_of(air_.begin(), air_.end(), [&](const PlanArea& area) {
      return area.boundary.contains(p) && area.boundary.distance(p) >= on_cut;
    });
  }

  /** @brief Returns whether no face lies between a place and the plane. */
  bool isSeen(const Eigen::Vector3d& p) const
  {
    const auto tile = tiles_.find({tileOf(p.x()), tileOf(p.y())});
    return tile == tiles_.end() ||
           std::none_of(tile->second.begin(), tile->second.end(),
                        [&](const Face& face) { return hides(face, p); });
  }

  bool hides(const Face& face, const Eigen::Vector3d& p) const
  {
    constexpr double before = 0.001; // metres
    const double sign = face.normal.z() < 0 ? -1 : 1;
    for (std::size_t k = 0; k < 3; ++k) {
      const Eigen::Vector3d& a = places_[face.corners[k]];
      const Eigen::Vector3d& b = places_[face.corners[(k + 1) % 3]];
      if (sign * cross((b - a).head<2>(), (p - a).head<2>()) < 0)
        return false;
    }
    const double off = face.normal.dot(p - places_[face.corners[0]]);
    const double depth = p.z() - off / face.normal.z();
    return depth > 0 && depth < p.z() - before;
  }

  const TriangleMesh& mesh_;
  SectionLine line_;
  Eigen::Vector2d way_;
  const std::vector<PlanArea>& air_;
  std::vector<Eigen::Vector3d> places_; ///< of vertices
  std::map<std::pair<long, long>, std::vector<Face>> tiles_;
  std::vector<PlanLine> lines_;
};

/** @brief Adds the outline of an opening as a wall beside it is seen, from either side;
 * that of a passage only from its room: one looks through it. */
void
addOpening(const PlanOpening& opening, const PlanElement& wall, ViewBeyond& view)
{
  constexpr double before = 0.002; // metres, the face of the wall
  std::vector<Eigen::Vector3d> corners;
  for (const auto& [end, z] : {std::pair(opening.start, opening.bottom),
                               {opening.end, opening.bottom},
                               {opening.end, opening.top},
                               {opening.start, opening.top}}) {
    const auto [face, inward] = faceAt(wall, wall.project(end));
    const bool is_outside = view.depthOf(inward) > 0;
    if (is_outside && opening.kind == OpeningKind::Passage)
      return;
    const Eigen::Vector2d p = face + (is_outside ? -before : before) * inward;
    corners.push_back(view.placeOf({p.x(), p.y(), z}));
  }
  for (std::size_t k = 0; k < corners.size(); ++k)
    view.addEdge(corners[k], corners[(k + 1) % corners.size()],
                 opening.kind == OpeningKind::Window ? PlanLayer::Window
                                                     : PlanLayer::Door);
}

} // namespace

std::vector<PlanLine>
linesBeyond(const Floorplan& plan,
            const SectionLine& line,
            const std::vector<PlanArea>& air)
{
  Floorplan open = plan;
  open.openings.clear();
  for (const PlanOpening& opening : plan.openings)
    if (opening.kind == OpeningKind::Passage)
      open.openings.push_back(opening);
  TriangleMesh mesh;
  std::vector<SolidElement> elements;
  std::vector<RoomSolidReport> reports;
  std::vector<PlanWarning> warnings;
  SolidParameters parameters;
  parameters.cut_openings = true;
  extrudePlan(&open, parameters, {mesh, elements, reports, warnings});
  if (mesh.empty())
    return {};
  auto element = static_cast<std::uint32_t>(elements.size());
  for (const PlanStair& stair : plan.stairs)
    for (const PlanFlight& flight : stair.flights)
      addFlight(flight, mesh, element);
  ViewBeyond view(mesh, line, air, stairsOn(plan, line));
  for (const PlanOpening& opening : plan.openings)
    for (const OpeningWall& in : opening.walls)
      if (const PlanRoom* const room = findRoom(plan, in.room);
          room && in.element < room->boundary.elements.size())
        addOpening(opening, room->boundary.elements[in.element], view);
  view.addEdges([&](std::uint32_t element) {
    return element > elements.size() ? PlanLayer::Stair : PlanLayer::Beyond;
  });
  return std::move(view).lines();
}

} // namespace pcl::sedr
