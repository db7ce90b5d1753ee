// SPDX-License-Identifier: BSD-3-Clause
#include "truth_mesh.h"

#include "room_regions.h"
#include "subdivision.h"
#include "triangulation.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <stdexcept>

namespace pcl::sedr::sim {

namespace {

/** @brief The heights at which a plan point has a vertex; equal up to rounding means
 * one. */
class VertexLevels {
public:
  void insert(double z)
  {
    const auto next = firstFrom(z);
    if (next == levels_.end() || *next > z + kSameHeight)
      levels_.insert(next, z);
  }

  /** @brief Returns the level equal to @p z, which was inserted before. */
  double at(double z) const
  {
    const auto level = firstFrom(z);
    if (level == levels_.end() || *level > z + kSameHeight)
      throw std::logic_error("A vertex has a height that is none of its point's");
    return *level;
  }

  /** @brief Returns all levels from @p low to @p high, which were inserted before. */
  std::vector<double> within(double low, double high) const
  {
    return {firstFrom(low), std::next(firstFrom(high))};
  }

private:
  std::vector<double>::const_iterator firstFrom(double z) const
  {
    return std::lower_bound(levels_.begin(), levels_.end(), z - kSameHeight);
  }

  std::vector<double> levels_; ///< ascending
};

/** @brief Returns points along @p element within the tolerance, both ends included. */
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
      , tolerance_(tolerance)
      , mesh_(mesh)
      , plan_(subdivide(room))
  {
    points_ = plan_.nodes;
    for (const PlanEdge& edge : plan_.edges)
      tessellateEdge(edge);
  }

  void run()
  {
    for (const Niche& niche : room_.niches)
      niche_points_.push_back(pointsOf(niche));
    collectLevels();
    addSlabs(Layer::Floor);
    addSlabs(Layer::Ceiling);
    for (std::size_t edge = 0; edge < plan_.edges.size(); ++edge)
      addVerticalFaces(edge);
    for (std::size_t i = 0; i < room_.niches.size(); ++i)
      addNiche(room_.niches[i], niche_points_[i]);
  }

private:
  /** @brief The plan points of a niche, along the wall and along its back. */
  struct NichePoints {
    Ring near;
    Ring far;
  };

  /** @brief Creates the plan points of an edge, shared by the regions on both sides. */
  void tessellateEdge(const PlanEdge& edge)
  {
    const std::vector<Vec2> points = tessellate(edge.element, tolerance_);
    Ring ring{edge.start};
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      ring.push_back(points_.size());
      points_.push_back(points[i]);
    }
    ring.push_back(edge.end);
    edge_points_.push_back(ring);
  }

  bool isBeside(const PlanEdge& edge, const Niche& niche) const
  {
    const double middle = edge.source_offset + 0.5 * lengthOf(edge.element);
    return edge.source == EdgeSource::Outline && edge.source_element == niche.wall &&
           middle > niche.from && middle < niche.to;
  }

  /** @brief Collects the points in front of a niche and creates those of its back. */
  NichePoints pointsOf(const Niche& niche)
  {
    NichePoints points;
    for (std::size_t i = 0; i < plan_.edges.size(); ++i)
      if (isBeside(plan_.edges[i], niche)) {
        if (!points.near.empty())
          points.near.pop_back(); // end of the previous edge
        points.near.insert(points.near.end(), edge_points_[i].begin(),
                           edge_points_[i].end());
      }
    const Element wall = elementOf(room_.outline, niche.wall);
    const Element back = offsetRight(pieceOf(wall, niche.from, niche.to), niche.depth);
    for (const Vec2 point : tessellate(back, tolerance_)) {
      points.far.push_back(points_.size());
      points_.push_back(point);
    }
    return points;
  }

  /** @brief Collects all heights at which a plan point has a vertex. */
  void collectLevels()
  {
    levels_.resize(points_.size());
    for (std::size_t i = 0; i < plan_.edges.size(); ++i)
      for (const Layer layer : {Layer::Floor, Layer::Ceiling}) {
        const Sides& sides = plan_.edges[i].sides(layer);
        for (const Region region : {sides.left, sides.right})
          if (region != kVoid)
            insertLevels(edge_points_[i], slabOf(room_, region, layer));
      }
    for (std::size_t i = 0; i < room_.niches.size(); ++i)
      for (const double z : {room_.niches[i].sill, room_.niches[i].head}) {
        insertLevels(niche_points_[i].near, {z});
        insertLevels(niche_points_[i].far, {z});
      }
  }

  void insertLevels(const Ring& points, const Slab& slab)
  {
    for (const std::size_t point : points)
      levels_[point].insert(heightAt(slab, points_[point]));
  }

  std::vector<Ring> ringsOf(Layer layer, const std::vector<bool>& member) const
  {
    std::vector<Ring> rings;
    for (const Cycle& cycle : boundariesOf(plan_, layer, member)) {
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

  /** @brief Adds a floor or ceiling, region by region. */
  void addSlabs(Layer layer)
  {
    const Region count = regionCount(room_, layer);
    for (Region region = kMain; region < count; ++region) {
      std::vector<bool> member(count + 1, false);
      member[region + 1] = true;
      addAreas(ringsOf(layer, member), slabOf(room_, region, layer), layer,
               labelOf(room_, region, layer));
    }
  }

  void
  addAreas(const std::vector<Ring>& rings, const Slab& slab, Layer layer, Label label)
  {
    for (Triangle t : triangulate(points_, rings)) {
      if (layer == Layer::Floor)
        std::swap(t[1], t[2]);
      addFace({vertex(t[0], slab), vertex(t[1], slab), vertex(t[2], slab)}, label);
    }
  }

  void addVerticalFaces(std::size_t i)
  {
    for (const VerticalFace& face : verticalFacesOf(room_, plan_.edges[i])) {
      Ring points = edge_points_[i];
      if (!face.room_is_left)
        std::reverse(points.begin(), points.end());
      Slab low = face.low;
      for (const Niche& niche : nichesBeside(plan_.edges[i])) {
        addStrips(points, low, {niche.sill}, face.label);
        low = {niche.head};
      }
      addStrips(points, low, face.high, face.label);
    }
  }

  /** @brief Returns the niches behind an edge in ascending order. */
  std::vector<Niche> nichesBeside(const PlanEdge& edge) const
  {
    std::vector<Niche> niches;
    std::copy_if(room_.niches.begin(), room_.niches.end(), std::back_inserter(niches),
                 [&](const Niche& niche) { return isBeside(edge, niche); });
    std::sort(niches.begin(), niches.end(),
              [](const Niche& a, const Niche& b) { return a.sill < b.sill; });
    return niches;
  }

  /** @brief Adds bottom, lid, back and sides of a niche. */
  void addNiche(const Niche& niche, const NichePoints& points)
  {
    const Slab low{niche.sill};
    const Slab high{niche.head};
    Ring footprint = points.far;
    footprint.insert(footprint.end(), points.near.rbegin(), points.near.rend());
    addAreas({footprint}, low, Layer::Floor, Label::Detail);
    addAreas({footprint}, high, Layer::Ceiling, Label::Detail);
    addStrips({points.near.front(), points.far.front()}, low, high, Label::Detail);
    addStrips(points.far, low, high, Label::Detail);
    addStrips({points.far.back(), points.near.back()}, low, high, Label::Detail);
  }

  /** @brief Adds the vertical faces over a polyline, with the room to its left. */
  void addStrips(const Ring& points, const Slab& low, const Slab& high, Label label)
  {
    for (std::size_t k = 0; k + 1 < points.size(); ++k)
      addStrip(points[k], points[k + 1], low, high, label);
  }

  /** @brief Adds the vertical face over a..b, with the room to the left.
   *
   * Its sides include all vertices above a and b, so that it fits its neighbours.
   */
  void
  addStrip(std::size_t a, std::size_t b, const Slab& low, const Slab& high, Label label)
  {
    const std::vector<double> za = levelsBetween(a, low, high);
    const std::vector<double> zb = levelsBetween(b, low, high);
    std::size_t i = 0;
    std::size_t j = 0;
    while (i + 1 < za.size() || j + 1 < zb.size()) {
      const bool climb_b =
          i + 1 == za.size() || (j + 1 < zb.size() && zb[j + 1] <= za[i + 1]);
      const auto low_a = vertex(a, {za[i]});
      const auto low_b = vertex(b, {zb[j]});
      const auto next = climb_b ? vertex(b, {zb[++j]}) : vertex(a, {za[++i]});
      addFace({low_a, low_b, next}, label);
    }
  }

  std::vector<double>
  levelsBetween(std::size_t point, const Slab& low, const Slab& high) const
  {
    return levels_[point].within(heightAt(low, points_[point]),
                                 heightAt(high, points_[point]));
  }

  std::uint32_t vertex(std::size_t point, const Slab& slab)
  {
    const double z = levels_[point].at(heightAt(slab, points_[point]));
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
  const double tolerance_;
  Mesh& mesh_;
  const Subdivision plan_;
  std::vector<Vec2> points_;         ///< nodes first, then the points within arcs
  std::vector<Ring> edge_points_;    ///< the points of each edge, from start to end
  std::vector<VertexLevels> levels_; ///< per point
  std::vector<NichePoints> niche_points_;
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
