// SPDX-License-Identifier: BSD-3-Clause
#include "truth_mesh.h"

#include "subdivision.h"
#include "triangulation.h"

#include <algorithm>
#include <map>
#include <set>

namespace pcl::sedr::sim {

namespace {

/** @brief Points along @p element, both ends included, that keep the tolerance. */
std::vector<Vec2>
tessellate(const Element& element, double tolerance)
{
  std::vector<Vec2> points{element.start};
  if (element.bulge != 0.0) {
    const Arc arc = arcOf(element);
    const double cosine = std::max(0.0, 1.0 - tolerance / arc.radius);
    const double step = 2.0 * std::acos(cosine);
    const auto count = static_cast<std::size_t>(std::ceil(std::abs(arc.sweep) / step));
    const double end = lengthOf(element);
    for (std::size_t i = 1; i < count; ++i)
      points.push_back(pointAt(element, end * i / count));
  }
  points.push_back(element.end);
  return points;
}

/** @brief Builds the closed mesh of one room. */
class RoomMesher {
public:
  RoomMesher(const Room& room, std::uint32_t number, double tolerance, Mesh& mesh)
      : room_(room)
      , number_(number)
      , mesh_(mesh)
      , plan_(subdivide(room))
  {
    points_ = plan_.nodes;
    for (const PlanEdge& edge : plan_.edges)
      tessellateEdge(edge, tolerance);
  }

  void run()
  {
    collectLevels();
    addFloor();
    for (Region region = kMain; region < regionCount(); ++region)
      addCeiling(region);
    for (std::size_t edge = 0; edge < plan_.edges.size(); ++edge)
      addVerticalFaces(edge);
  }

private:
  Region regionCount() const { return static_cast<Region>(room_.details.size()) + 1; }

  /** @brief Gives the edge its plan points; the two regions beside it share them. */
  void tessellateEdge(const PlanEdge& edge, double tolerance)
  {
    const std::vector<Vec2> points = tessellate(edge.element, tolerance);
    Ring ring{edge.start};
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      ring.push_back(points_.size());
      points_.push_back(points[i]);
    }
    ring.push_back(edge.end);
    edge_points_.push_back(ring);
  }

  /** @brief Every height at which a plan point has a vertex. */
  void collectLevels()
  {
    levels_.resize(points_.size());
    for (std::size_t i = 0; i < plan_.edges.size(); ++i) {
      const VerticalFace face = verticalFaceOf(room_, plan_.edges[i]);
      for (const std::size_t point : edge_points_[i]) {
        levels_[point].insert(face.low);
        levels_[point].insert(face.high);
      }
    }
  }

  std::vector<Ring> ringsOf(const std::vector<bool>& member) const
  {
    std::vector<Ring> rings;
    for (const Cycle& cycle : boundariesOf(plan_, member)) {
      Ring ring;
      for (const DirectedEdge& walk : cycle) {
        Ring points = edge_points_[walk.edge];
        if (!walk.forward)
          std::reverse(points.begin(), points.end());
        ring.insert(ring.end(), points.begin(), points.end() - 1);
      }
      rings.push_back(std::move(ring));
    }
    return rings;
  }

  void addFloor()
  {
    std::vector<bool> inside(regionCount() + 1, true);
    inside[kVoid + 1] = false;
    addLevel(inside, room_.floor.height, Label::Floor, false);
  }

  void addCeiling(Region region)
  {
    std::vector<bool> member(regionCount() + 1, false);
    member[region + 1] = true;
    const Label label = region == kMain ? Label::Ceiling : Label::Detail;
    addLevel(member, ceilingHeight(room_, region), label, true);
  }

  void addLevel(const std::vector<bool>& member, double z, Label label, bool upwards)
  {
    for (const Polygon& polygon : polygonsOf(points_, ringsOf(member)))
      for (Triangle t : triangulate(points_, polygon)) {
        if (!upwards)
          std::swap(t[1], t[2]);
        addFace({vertex(t[0], z), vertex(t[1], z), vertex(t[2], z)}, label);
      }
  }

  void addVerticalFaces(std::size_t i)
  {
    const VerticalFace face = verticalFaceOf(room_, plan_.edges[i]);
    Ring points = edge_points_[i];
    if (!face.room_is_left)
      std::reverse(points.begin(), points.end());
    for (std::size_t k = 0; k + 1 < points.size(); ++k)
      addStrip(points[k], points[k + 1], face);
  }

  /** @brief Adds the part of @p face over a..b, the room to the left.
   *
   * Its sides take up all vertices above a and b, or neighbours would not fit.
   */
  void addStrip(std::size_t a, std::size_t b, const VerticalFace& face)
  {
    const std::vector<double> za = levelsWithin(a, face);
    const std::vector<double> zb = levelsWithin(b, face);
    std::size_t i = 0;
    std::size_t j = 0;
    while (i + 1 < za.size() || j + 1 < zb.size()) {
      const bool climb_b =
          i + 1 == za.size() || (j + 1 < zb.size() && zb[j + 1] <= za[i + 1]);
      const auto low_a = vertex(a, za[i]);
      const auto low_b = vertex(b, zb[j]);
      const auto next = climb_b ? vertex(b, zb[++j]) : vertex(a, za[++i]);
      addFace({low_a, low_b, next}, face.label);
    }
  }

  std::vector<double> levelsWithin(std::size_t point, const VerticalFace& face) const
  {
    const std::set<double>& levels = levels_[point];
    return {levels.lower_bound(face.low), levels.upper_bound(face.high)};
  }

  std::uint32_t vertex(std::size_t point, double z)
  {
    const auto next = static_cast<std::uint32_t>(mesh_.vertices.size());
    const auto [known, is_new] = vertices_.emplace(std::make_pair(point, z), next);
    if (is_new)
      mesh_.vertices.push_back(lifted(points_[point], z));
    return known->second;
  }

  void addFace(const std::array<std::uint32_t, 3>& vertices, Label label)
  {
    mesh_.faces.push_back({vertices, label, number_});
  }

  const Room& room_;
  const std::uint32_t number_;
  Mesh& mesh_;
  const Subdivision plan_;
  std::vector<Vec2> points_;      ///< nodes first, then the points within arcs
  std::vector<Ring> edge_points_; ///< the points of each edge, from start to end
  std::vector<std::set<double>> levels_;
  std::map<std::pair<std::size_t, double>, std::uint32_t> vertices_;
};

} // namespace

Mesh
truthMesh(const Scene& scene, double chord_tolerance)
{
  Mesh mesh;
  for (std::size_t i = 0; i < scene.rooms.size(); ++i) {
    const auto number = static_cast<std::uint32_t>(i + 1);
    RoomMesher(scene.rooms[i], number, chord_tolerance, mesh).run();
  }
  return mesh;
}

} // namespace pcl::sedr::sim
