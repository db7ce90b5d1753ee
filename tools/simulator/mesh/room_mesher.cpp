// SPDX-License-Identifier: BSD-3-Clause
#include "room_plan.h"

#include <algorithm>
#include <map>
#include <stdexcept>

namespace pcl::sedr::sim {

namespace {

constexpr double kSameHeight = 1e-5; ///< metres; heights closer than this are equal

/** @brief The heights at which a point of the plan has a vertex, ascending. Heights
 * that are equal up to rounding are one. */
class VertexLevels {
public:
  void insert(double z)
  {
    const auto next = std::lower_bound(levels_.begin(), levels_.end(), z - kSameHeight);
    if (next == levels_.end() || *next > z + kSameHeight)
      levels_.insert(next, z);
  }

  /** @brief Returns the index of the level equal to @p z, which was inserted before. */
  std::size_t indexOf(double z) const
  {
    const auto next = std::lower_bound(levels_.begin(), levels_.end(), z - kSameHeight);
    const auto nearer = [z](double a, double b) {
      return std::abs(a - z) < std::abs(b - z);
    };
    const auto level = std::min_element(next, std::min(next + 2, levels_.end()),
                                        nearer); // two at most are as near
    if (level == levels_.end() || std::abs(*level - z) > kSameHeight)
      throw std::logic_error("A vertex has a height that is none of its point's");
    return static_cast<std::size_t>(level - levels_.begin());
  }

  std::size_t size() const { return levels_.size(); }
  double operator[](std::size_t i) const { return levels_[i]; }

private:
  std::vector<double> levels_;
};

/** @brief Builds the mesh of one room. */
class RoomMesher {
public:
  RoomMesher(const Room& room,
             std::uint32_t number,
             const std::vector<Opening>& openings,
             const RoomPlan& plan,
             SceneMesh& scene)
      : room_(room)
      , number_(number)
      , openings_(openings)
      , plan_(plan)
      , scene_(scene)
      , points_(plan.points)
  {}

  void run()
  {
    addNicheFootprints();
    collectLevels();
    const std::size_t first = scene_.mesh.triangles.size();
    addSlabs();
    for (const PlanSide& side : plan_.sides)
      if (side.beyond) {
        addRiser(side, Layer::Floor);
        addRiser(side, Layer::Ceiling);
      }
      else {
        addWall(side);
      }
    for (std::size_t i = 0; i < niches_.size(); ++i)
      addNiche(room_.wall_niches[i], niches_[i]);
    expectClosed(first);
  }

private:
  /** @brief The points of a niche, along the wall and along its back. */
  struct NicheFootprint {
    std::vector<std::uint32_t> near;
    std::vector<std::uint32_t> far;
  };

  /** @brief A vertical face over a side of the plan, with the room to its left. */
  struct Strip {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    Label label = Label::Wall;
    Surface surface = Surface::Structure;
    std::uint32_t opening = 0;
  };

  void addNicheFootprints()
  {
    for (const WallGap& niche : room_.wall_niches) {
      const Element& wall = room_.boundary.elements[niche.wall];
      std::map<double, std::uint32_t> along;
      for (const PlanSide& side : plan_.sides)
        if (side.isWithin(niche)) {
          along.emplace(side.from, side.a);
          along[side.to] = side.b; // the end of the niche at the end of a wall
        }
      NicheFootprint footprint;
      for (const auto& [s, point] : along) {
        if (!footprint.near.empty() && footprint.near.back() == point)
          continue; // the same place, computed along two sides
        footprint.near.push_back(point);
        footprint.far.push_back(static_cast<std::uint32_t>(points_.size()));
        points_.push_back(pointBeside(wall, s, niche.depth));
      }
      niches_.push_back(std::move(footprint));
    }
  }

  void collectLevels()
  {
    levels_.resize(points_.size());
    for (const PlanTriangle& triangle : plan_.triangles)
      for (const std::uint32_t corner : triangle.corners) {
        const Vec2& point = points_[corner];
        const double low = room_.floorSlab(triangle.floor).heightAt(point);
        const double high = room_.ceilingSlab(triangle.ceiling).heightAt(point);
        // At the edge of a tilted wall floor and ceiling may meet.
        if (high - low < (room_.foot.elements.empty() ? kSameHeight : -kSameHeight))
          fail("the ceiling is not above the floor", placeText(point));
        levels_[corner].insert(low);
        levels_[corner].insert(high);
      }
    const auto insert = [this](std::uint32_t point, const WallGap& gap) {
      levels_[point].insert(gap.sill);
      levels_[point].insert(gap.head);
    };
    for (const PlanSide& side : plan_.sides)
      for (const Opening& opening : openings_)
        if (side.isWithin(opening)) {
          insert(side.a, opening);
          insert(side.b, opening);
        }
    for (std::size_t i = 0; i < niches_.size(); ++i)
      for (const auto* points : {&niches_[i].near, &niches_[i].far})
        for (const std::uint32_t point : *points)
          insert(point, room_.wall_niches[i]);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      first_vertex_.push_back(static_cast<std::uint32_t>(scene_.mesh.vertices.size()));
      for (std::size_t k = 0; k < levels_[i].size(); ++k)
        scene_.addVertex(lifted(points_[i], levels_[i][k]));
    }
  }

  void addSlabs()
  {
    for (const PlanTriangle& triangle : plan_.triangles) {
      addSlabFace(triangle, Layer::Floor);
      addSlabFace(triangle, Layer::Ceiling);
    }
  }

  void addSlabFace(const PlanTriangle& triangle, Layer layer)
  {
    const bool is_floor = layer == Layer::Floor;
    const int region = is_floor ? triangle.floor : triangle.ceiling;
    const Slab& slab = slabOf(room_, region, layer);
    Triangle corners{};
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] =
          vertexAt(triangle.corners[k], slab.heightAt(points_[triangle.corners[k]]));
    if (is_floor)
      std::swap(corners[1], corners[2]);
    const bool is_open =
        is_floor ? triangle.floor_is_open : triangle.hole_above.has_value();
    scene_.addFace(corners, is_open ? Surface::Gap : Surface::Structure,
                   labelOf(room_, region, layer), number_);
  }

  void addWall(const PlanSide& side)
  {
    const PlanTriangle& triangle = plan_.triangles[side.triangle];
    Strip strip{side.a, side.b};
    strip.label = side.wall ? Label::Wall : Label::Column;
    std::vector<std::pair<const WallGap*, std::uint32_t>> gaps;
    for (const Opening& opening : openings_)
      if (side.isWithin(opening))
        gaps.emplace_back(&opening, opening.number);
    for (const WallGap& niche : room_.wall_niches)
      if (side.isWithin(niche))
        gaps.emplace_back(&niche, 0);
    std::sort(gaps.begin(), gaps.end(), [](const auto& a, const auto& b) {
      return a.first->sill < b.first->sill;
    });
    Slab low = room_.floorSlab(triangle.floor);
    for (const auto& [gap, opening] : gaps) {
      addStrip(strip, low, horizontalSlab(gap->sill));
      if (opening > 0) {
        Strip closed = strip;
        closed.surface = Surface::Gap;
        closed.opening = opening;
        addStrip(closed, horizontalSlab(gap->sill), horizontalSlab(gap->head));
      }
      low = horizontalSlab(gap->head);
    }
    addStrip(strip, low, room_.ceilingSlab(triangle.ceiling));
  }

  void addRiser(const PlanSide& side, Layer layer)
  {
    const auto slab = [&](std::size_t t) -> const Slab& {
      const PlanTriangle& triangle = plan_.triangles[t];
      return slabOf(room_, layer == Layer::Floor ? triangle.floor : triangle.ceiling,
                    layer);
    };
    const Slab& left = slab(side.triangle);
    const Slab& right = slab(*side.beyond);
    const auto rise = [&](std::uint32_t point) {
      return left.heightAt(points_[point]) - right.heightAt(points_[point]);
    };
    const auto [least, most] = std::minmax({rise(side.a), rise(side.b)});
    if (least > -kSameHeight && most < kSameHeight)
      return;
    if (least < -kSameHeight && most > kSameHeight)
      fail("two parts of a floor or ceiling cross beside a riser",
           placeText(points_[side.a]));
    const bool left_is_higher = most >= kSameHeight;
    const bool room_is_left = left_is_higher == (layer == Layer::Ceiling);
    Strip strip{side.a, side.b, Label::Detail};
    if (!room_is_left)
      std::swap(strip.a, strip.b);
    addStrip(strip, left_is_higher ? right : left, left_is_higher ? left : right);
  }

  void addNiche(const WallGap& niche, const NicheFootprint& footprint)
  {
    const auto& [near, far] = footprint;
    const Slab low = horizontalSlab(niche.sill);
    const Slab high = horizontalSlab(niche.head);
    const auto add_flat = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      scene_.addFace(
          {vertexAt(a, niche.head), vertexAt(b, niche.head), vertexAt(c, niche.head)},
          Surface::Structure, Label::Detail, number_);
      scene_.addFace(
          {vertexAt(a, niche.sill), vertexAt(c, niche.sill), vertexAt(b, niche.sill)},
          Surface::Structure, Label::Detail, number_);
    };
    for (std::size_t k = 0; k + 1 < near.size(); ++k) {
      add_flat(near[k], far[k], far[k + 1]);
      add_flat(near[k], far[k + 1], near[k + 1]);
      addStrip({far[k], far[k + 1], Label::Detail}, low, high);
    }
    addStrip({near.front(), far.front(), Label::Detail}, low, high);
    addStrip({far.back(), near.back(), Label::Detail}, low, high);
  }

  void addStrip(const Strip& strip, const Slab& low, const Slab& high)
  {
    const auto level = [this](std::uint32_t point, const Slab& slab) {
      return levels_[point].indexOf(slab.heightAt(points_[point]));
    };
    const VertexLevels& za = levels_[strip.a];
    const VertexLevels& zb = levels_[strip.b];
    std::size_t i = level(strip.a, low);
    std::size_t j = level(strip.b, low);
    const std::size_t last_i = level(strip.a, high);
    const std::size_t last_j = level(strip.b, high);
    if (i > last_i || j > last_j)
      fail("an opening or niche reaches beyond floor or ceiling, or over another",
           placeText(points_[strip.a]));
    while (i < last_i || j < last_j) {
      const bool climb_b = i == last_i || (j < last_j && zb[j + 1] <= za[i + 1]);
      const auto at_a = static_cast<std::uint32_t>(first_vertex_[strip.a] + i);
      const auto at_b = static_cast<std::uint32_t>(first_vertex_[strip.b] + j);
      scene_.addFace({at_a, at_b, climb_b ? at_b + 1 : at_a + 1}, strip.surface,
                     strip.label, number_, strip.opening);
      ++(climb_b ? j : i);
    }
  }

  std::uint32_t vertexAt(std::uint32_t point, double z) const
  {
    return static_cast<std::uint32_t>(first_vertex_[point] + levels_[point].indexOf(z));
  }

  void expectClosed(std::size_t first) const
  {
    const auto& triangles = scene_.mesh.triangles;
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
    for (std::size_t t = first; t < triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k)
        ++uses[{triangles[t][k], triangles[t][(k + 1) % 3]}];
    for (const auto& [edge, count] : uses)
      if (count != 1 || uses.count({edge.second, edge.first}) == 0)
        fail("parts of the floor, the ceiling or the walls touch in a single point",
             placeText(sim::plan(scene_.mesh.vertices[edge.first])));
  }

  const Room& room_;
  const std::uint32_t number_;
  const std::vector<Opening>& openings_;
  const RoomPlan& plan_;
  SceneMesh& scene_;
  std::vector<Vec2> points_; ///< those of the plan, then those of the niches' backs
  std::vector<NicheFootprint> niches_;
  std::vector<VertexLevels> levels_;        ///< of each point
  std::vector<std::uint32_t> first_vertex_; ///< of each point, at its lowest level
};

} // namespace

RoomPlan
addRoom(const Room& room,
        std::uint32_t number,
        const std::vector<Opening>& openings,
        const std::vector<Loop>& floor_voids,
        SceneMesh& scene)
{
  RoomPlan plan = planOf(room, openings, floor_voids);
  RoomMesher(room, number, openings, plan, scene).run();
  return plan;
}

} // namespace pcl::sedr::sim
