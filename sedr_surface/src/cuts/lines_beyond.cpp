// SPDX-License-Identifier: BSD-3-Clause
#include "lines_beyond.h"

#include "../mesh/mesh_outlines.h"
#include "sedr_filters/src/plan/plan_segment.h"
#include "sedr_filters/src/walls/plan_walls.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace pcl::sedr {
namespace {

/** @brief Finds what a viewer at a vertical plane sees of a room. Places are along the
 * line, height, and depth behind the plane. */
class ViewOfRoom {
public:
  ViewOfRoom(const TriangleMesh& solid,
             const SectionLine& line,
             const std::vector<PlanLoop>& cut)
      : line_(line)
      , way_((line.to - line.from).normalized())
      , cut_(cut)
  {
    constexpr double no_area = 1e-9; // such faces are seen from their edge
    for (const Eigen::Vector3d& p : solid.vertices)
      places_.push_back(placeOf(p));
    for (std::size_t t = 0; t < solid.triangles.size(); ++t) {
      const Triangle& corners = solid.triangles[t];
      const Eigen::Vector3d& a = places_[corners[0]];
      const Eigen::Vector3d normal =
          (places_[corners[1]] - a).cross(places_[corners[2]] - a);
      const double nearest =
          std::min({a.z(), places_[corners[1]].z(), places_[corners[2]].z()});
      const double farthest =
          std::max({a.z(), places_[corners[1]].z(), places_[corners[2]].z()});
      if (farthest > 0 && std::abs(normal.z()) > no_area)
        faces_.push_back({corners, normal, nearest});
    }
    for (const Face& face : faces_) {
      const auto [low, high] =
          std::minmax({places_[face.corners[0]].x(), places_[face.corners[1]].x(),
                       places_[face.corners[2]].x()});
      for (long k = stripOf(low); k <= stripOf(high); ++k)
        strips_[k].push_back(&face);
    }
  }

  Eigen::Vector3d placeOf(const Eigen::Vector3d& p) const
  {
    const Eigen::Vector2d off = p.head<2>() - line_.from;
    return {way_.dot(off), p.z(), way_.x() * off.y() - way_.y() * off.x()};
  }

  /** @brief Adds what is seen of a straight edge behind the plane. */
  void addEdge(Eigen::Vector3d from,
               Eigen::Vector3d to,
               PlanLayer layer,
               std::vector<PlanLine>& lines) const
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
      return isWithinCut(p.head<2>()) && isSeen(p);
    };
    forEachPart(edge, isShown, [&](const PlanElement& part, bool is_shown) {
      if (is_shown && part.length() > shortest)
        lines.push_back({part, layer});
    });
  }

  /** @brief Adds the edges between elements, and those of curved walls where they turn
   * away. */
  void addEdges(const TriangleMesh& solid, std::vector<PlanLine>& lines) const
  {
    constexpr double flat = 0.985; // cosine of 10 degrees
    std::map<Edge, std::size_t> beside;
    for (std::size_t t = 0; t < solid.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto edge =
            std::minmax(solid.triangles[t][k], solid.triangles[t][(k + 1) % 3]);
        const auto [other, is_first] = beside.emplace(edge, t);
        if (is_first)
          continue;
        const Eigen::Vector3d normal = solid.scaledNormal(t).normalized();
        const Eigen::Vector3d beyond = solid.scaledNormal(other->second).normalized();
        const bool is_border = solid.elements[other->second] != solid.elements[t];
        const bool turns_away =
            isUpright(edge) && isTowards(normal) != isTowards(beyond);
        if (!turns_away && (!is_border || normal.dot(beyond) > flat))
          continue;
        addEdge(places_[edge.first], places_[edge.second], PlanLayer::Beyond, lines);
      }
  }

private:
  using Edge = std::pair<std::uint32_t, std::uint32_t>;

  bool isUpright(const Edge& edge) const
  {
    const Eigen::Vector3d way = places_[edge.second] - places_[edge.first];
    return std::abs(way.y()) > 0.99 * way.norm();
  }

  /** @brief Returns whether a face looks along the depth; one seen from its edge does
   * not. */
  bool isTowards(const Eigen::Vector3d& normal) const
  {
    return way_.x() * normal.y() - way_.y() * normal.x() > 1e-6;
  }

  struct Face {
    Triangle corners;
    Eigen::Vector3d normal;
    double nearest;
  };

  static long stripOf(double along)
  {
    constexpr double width = 0.25; // metres
    return static_cast<long>(std::floor(along / width));
  }

  /** @brief Returns whether a place is within the cut, off its outline. */
  bool isWithinCut(const Eigen::Vector2d& p) const
  {
    constexpr double on_cut = 0.005; // metres
    bool is_within = false;
    for (const PlanLoop& loop : cut_) {
      if (loop.distance(p) < on_cut)
        return false;
      is_within = is_within != loop.contains(p);
    }
    return is_within;
  }

  /** @brief Returns whether no face lies between a place and the plane. */
  bool isSeen(const Eigen::Vector3d& p) const
  {
    const auto strip = strips_.find(stripOf(p.x()));
    return strip == strips_.end() ||
           std::none_of(strip->second.begin(), strip->second.end(),
                        [&](const Face* face) { return hides(*face, p); });
  }

  bool hides(const Face& face, const Eigen::Vector3d& p) const
  {
    constexpr double before = 0.001; // metres
    if (face.nearest > p.z() - before)
      return false;
    const double sign = face.normal.z() < 0 ? -1 : 1;
    for (std::size_t k = 0; k < 3; ++k) {
      const Eigen::Vector3d& a = places_[face.corners[k]];
      const Eigen::Vector3d& b = places_[face.corners[(k + 1) % 3]];
      if (sign *
              ((b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x())) <
          0)
        return false;
    }
    const double off = face.normal.dot(p - places_[face.corners[0]]);
    const double depth = p.z() - off / face.normal.z();
    return depth > 0 && depth < p.z() - before;
  }

  SectionLine line_;
  Eigen::Vector2d way_;
  const std::vector<PlanLoop>& cut_;
  std::vector<Eigen::Vector3d> places_; ///< of vertices
  std::vector<Face> faces_;
  std::map<long, std::vector<const Face*>> strips_; ///< along the line
};

} // namespace

std::vector<PlanLine>
linesBeyond(const Floorplan& plan,
            const PlanRoom& room,
            const TriangleMesh& solid,
            const SectionLine& line,
            const std::vector<PlanLoop>& cut)
{
  constexpr double inside = 0.002; // metres
  const ViewOfRoom view(solid, line, cut);
  std::vector<PlanLine> lines;
  view.addEdges(solid, lines);
  for (const PlanOpening& opening : plan.openings)
    for (const OpeningWall& in : opening.walls) {
      if (in.room != room.id || in.element >= room.boundary.elements.size())
        continue;
      const PlanElement& wall = room.boundary.elements[in.element];
      std::vector<Eigen::Vector3d> corners;
      for (const auto& [end, z] : {std::pair(opening.start, opening.bottom),
                                   {opening.end, opening.bottom},
                                   {opening.end, opening.top},
                                   {opening.start, opening.top}}) {
        const auto [face, inward] = faceAt(wall, wall.project(end));
        const Eigen::Vector2d p = face + inside * inward;
        corners.push_back(view.placeOf({p.x(), p.y(), z}));
      }
      for (std::size_t k = 0; k < corners.size(); ++k)
        view.addEdge(corners[k], corners[(k + 1) % corners.size()],
                     opening.kind == OpeningKind::Window ? PlanLayer::Window
                                                         : PlanLayer::Door,
                     lines);
    }
  return lines;
}

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

} // namespace pcl::sedr
