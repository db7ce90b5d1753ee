// SPDX-License-Identifier: BSD-3-Clause
#include "room_cells.h"
#include "scene_mesh.h"

#include "sedr_filters/src/walls/plan_walls.h"

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

/** @brief Builds the mesh of one room and of the other spaces that it gives. */
class RoomMesher {
public:
  RoomMesher(const Scene& scene, std::size_t index, SceneMesh& mesh)
      : room_(scene.rooms[index])
      , number_(static_cast<std::uint32_t>(index + 1))
      , plan_(cellsOf(scene, index))
      , scene_(mesh)
      , levels_(plan_.points.size())
  {}

  void run()
  {
    collectLevels();
    const std::size_t first = scene_.mesh.triangles.size();
    addFaces(true);
    expectClosed(first);
    addFaces(false);
  }

private:
  /** @brief The levels at which a slab meets the start and the end of a side. */
  struct Border {
    std::size_t a = 0;
    std::size_t b = 0;

    bool isAtMost(const Border& other) const { return a <= other.a && b <= other.b; }
  };

  void collectLevels()
  {
    for (const PlanTriangle& triangle : plan_.triangles)
      for (const std::uint32_t corner : triangle.corners) {
        const Vec2& point = plan_.points[corner];
        const Space* below = nullptr;
        for (const Space& space : plan_.cells[triangle.cell]) {
          const double low = space.low.heightAt(point);
          const double high = space.high.heightAt(point);
          // At the edge of a tilted wall floor and ceiling may meet.
          if (high - low < (isTilted(room_) ? -kSameHeight : kSameHeight))
            fail(space.kind == Space::Inside
                     ? "the ceiling is not above the floor"
                     : "an opening, niche, void or plenum has no height",
                 placeText(point));
          if (below && (below->isRoom() || space.isRoom()) &&
              low < below->high.heightAt(point) - kSameHeight)
            fail("an opening or niche reaches over another", placeText(point));
          levels_[corner].insert(low);
          levels_[corner].insert(high);
          below = &space;
        }
      }
    for (std::size_t i = 0; i < plan_.points.size(); ++i) {
      first_vertex_.push_back(static_cast<std::uint32_t>(scene_.mesh.vertices.size()));
      for (std::size_t k = 0; k < levels_[i].size(); ++k)
        scene_.addVertex(lifted(plan_.points[i], levels_[i][k]));
    }
  }

  /** @brief Adds the faces of the room, or those of other spaces. */
  void addFaces(bool of_room)
  {
    const auto is_meant = [of_room](const Space& space) {
      return space.isRoom() == of_room && space.is_given;
    };
    for (const PlanTriangle& triangle : plan_.triangles)
      for (const Space& space : plan_.cells[triangle.cell])
        if (is_meant(space))
          addSlabs(triangle, space);
    for (const PlanSide& side : plan_.sides)
      for (const Space& space : plan_.cells[side.cell])
        if (is_meant(space))
          addSide(side, space);
  }

  /** @brief Adds floor and ceiling of a space; what it shares with the room is the
   * room's. */
  void addSlabs(const PlanTriangle& triangle, const Space& space)
  {
    const auto add = [&](const Slab& slab, bool is_floor, bool is_open, Label label) {
      Triangle corners{};
      for (std::size_t k = 0; k < 3; ++k)
        corners[k] = vertexAt(triangle.corners[k],
                              slab.heightAt(plan_.points[triangle.corners[k]]));
      if (is_floor)
        std::swap(corners[1], corners[2]);
      const Surface surface = is_open ? Surface::Gap : Surface::Structure;
      scene_.addFace(corners, space.isRoom() ? FaceLook{surface, label, number_}
                                             : FaceLook{Surface::Object});
    };
    if (space.isRoom() || space.kind == Space::Reveal)
      add(space.low, true, space.floor_is_open, space.floor);
    if (space.kind != Space::Shaft)
      add(space.high, false, space.ceiling_is_open, space.ceiling);
  }

  /** @brief Adds what of a space ends at a side: all but what the spaces beyond go on
   * with. */
  void addSide(const PlanSide& side, const Space& space)
  {
    if (space.kind == Space::Reveal && side.is_far_side)
      return;
    const FaceLook look = lookOf(space, side);
    const Border floor = borderOf(side, space.low);
    const Border ceiling = borderOf(side, space.high);
    Border low = floor;
    for (const Space& other : plan_.cells[side.beyond]) {
      const bool is_opening = space.isRoom() && other.kind == Space::Reveal;
      const bool goes_on = other.kind == space.kind && other.opening == space.opening;
      if (!other.isRoom() && !is_opening && !goes_on)
        continue;
      const Border sill = borderOf(side, other.low);
      const Border head = borderOf(side, other.high);
      if (space.kind == Space::Inside && other.kind != Space::Inside &&
          !(floor.isAtMost(sill) && head.isAtMost(ceiling)))
        fail("an opening or niche reaches beyond floor or ceiling",
             placeText(plan_.points[side.a]));
      const Border from = higher(low, sill, side);
      const Border to = higher(head, ceiling, side).isAtMost(head) ? ceiling : head;
      if (to.isAtMost(from))
        continue;
      addStrip(side, low, from, look);
      if (is_opening)
        addStrip(side, from, to, {Surface::Gap, Label::Wall, number_, other.opening});
      low = to;
    }
    addStrip(side, low, ceiling, look);
  }

  FaceLook lookOf(const Space& space, const PlanSide& side) const
  {
    if (!space.isRoom())
      return {Surface::Object, Label::Other, 0, space.opening};
    const Spaces& beyond = plan_.cells[side.beyond];
    const bool is_riser =
        space.kind == Space::Niche ||
        std::any_of(beyond.begin(), beyond.end(),
                    [](const Space& other) { return other.kind == Space::Inside; });
    return {Surface::Structure,
            is_riser       ? Label::Detail
            : side.is_wall ? Label::Wall
                           : Label::Column,
            number_};
  }

  Border borderOf(const PlanSide& side, const Slab& slab) const
  {
    const auto level = [&](std::uint32_t point) {
      return levels_[point].indexOf(slab.heightAt(plan_.points[point]));
    };
    return {level(side.a), level(side.b)};
  }

  /** @brief Returns the higher one of two borders. */
  Border higher(const Border& one, const Border& two, const PlanSide& side) const
  {
    if (!one.isAtMost(two) && !two.isAtMost(one))
      fail("two parts of a floor or ceiling cross beside a riser",
           placeText(plan_.points[side.a]));
    return one.isAtMost(two) ? two : one;
  }

  void addStrip(const PlanSide& side,
                const Border& low,
                const Border& high,
                const FaceLook& look)
  {
    const VertexLevels& za = levels_[side.a];
    const VertexLevels& zb = levels_[side.b];
    auto [i, j] = low;
    while (i < high.a || j < high.b) {
      const bool climb_b = i == high.a || (j < high.b && zb[j + 1] <= za[i + 1]);
      const auto at_a = static_cast<std::uint32_t>(first_vertex_[side.a] + i);
      const auto at_b = static_cast<std::uint32_t>(first_vertex_[side.b] + j);
      scene_.addFace({at_a, at_b, climb_b ? at_b + 1 : at_a + 1}, look);
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
  const RoomCells plan_;
  SceneMesh& scene_;
  std::vector<VertexLevels> levels_;        ///< of each point
  std::vector<std::uint32_t> first_vertex_; ///< of each point, at its lowest level
};

} // namespace

void
addRoom(const Scene& scene, std::size_t index, SceneMesh& mesh)
{
  RoomMesher(scene, index, mesh).run();
}

} // namespace pcl::sedr::sim
