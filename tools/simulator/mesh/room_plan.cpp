// SPDX-License-Identifier: BSD-3-Clause
#include "room_plan.h"

#include "sedr_filters/src/plan/room_lookup.h"
#include "sedr_surface/src/triangulation/triangulation.h"

#include <algorithm>
#include <map>
#include <utility>

namespace pcl::sedr::sim {

namespace {

constexpr auto kNone = PlanTriangulation::none;

/** @brief A chord of a loop and, of walls, where it lies along them. */
struct Chord {
  Vec2 start;
  Vec2 end;
  std::optional<std::size_t> wall = std::nullopt;
  double from = 0.0;
  double to = 0.0;
};

using Ends = std::pair<std::uint32_t, std::uint32_t>; ///< lower point first

/** @brief Builds the plan of one room. */
class PlanBuilder {
public:
  PlanBuilder(const Room& room,
              const std::vector<Opening>& openings,
              const std::vector<Loop>& floor_voids)
      : room_(room)
      , lookup_(room)
      , openings_(openings)
      , floor_voids_(floor_voids)
  {}

  RoomPlan run()
  {
    collectChords();
    triangulate();
    findRegions();
    collectSides();
    return std::move(plan_);
  }

private:
  void collectChords()
  {
    std::vector<const Loop*> loops;
    for (const Loop& column : room_.columns)
      loops.push_back(&column);
    for (const Layer layer : {Layer::Ceiling, Layer::Floor})
      for (const PlanDetail& detail : detailsOf(room_, layer))
        loops.push_back(&detail.boundary);
    for (const CeilingVoid& hole : room_.voids)
      loops.push_back(&hole.loop);
    for (const Loop& hole : floor_voids_)
      loops.push_back(&hole);
    for (const Loop* loop : loops)
      for (const Element& element : loop->elements)
        corners_.push_back(element.start);
    for (std::size_t wall = 0; wall < room_.boundary.elements.size(); ++wall)
      addChords(room_.boundary.elements[wall], cutsOf(wall), wall);
    for (const Loop* loop : loops)
      for (const Element& element : loop->elements)
        addChords(element, {}, std::nullopt);
  }

  /** @brief Returns the ends of all gaps along a wall. */
  std::vector<double> cutsOf(std::size_t wall) const
  {
    std::vector<double> cuts;
    const auto add = [&](const WallGap& gap) {
      if (gap.wall == wall)
        cuts.insert(cuts.end(), {gap.from, gap.to});
    };
    std::for_each(openings_.begin(), openings_.end(), add);
    std::for_each(room_.wall_niches.begin(), room_.wall_niches.end(), add);
    return cuts;
  }

  void addChords(const Element& element,
                 std::vector<double> cuts,
                 std::optional<std::size_t> wall)
  {
    if (element.isArc()) // corners of other loops on the arc are ends of
                         // chords, too
      for (const Vec2& corner : corners_)
        if (const auto s = locate(element, corner))
          cuts.push_back(*s);
    const std::vector<double> ends = chordEnds(element, std::move(cuts));
    const auto place = [&](std::size_t i) {
      return i == 0                 ? element.start
             : i + 1 == ends.size() ? element.end
                                    : element.pointAt(ends[i]);
    };
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
      chords_.push_back({place(i), place(i + 1), wall, ends[i], ends[i + 1]});
  }

  void triangulate()
  {
    Box2 bounds;
    for (const Chord& chord : chords_)
      bounds.extend(chord.start).extend(chord.end);
    const PlanGrid grid(bounds);
    std::map<GridPoint, Vec2> places; // without the rounding to the grid
    std::vector<GridSegment> segments;
    for (const Chord& chord : chords_) {
      segments.push_back({grid.toGrid(chord.start), grid.toGrid(chord.end)});
      places.emplace(segments.back().from, chord.start);
      places.emplace(segments.back().to, chord.end);
    }
    arrangeSegments(segments, kSamePoint / grid.unit(), arrangement_);
    for (const GridPoint& vertex : arrangement_.vertices) {
      const auto known = places.find(vertex);
      plan_.points.push_back(known == places.end() ? grid.toPlan(vertex)
                                                   : known->second);
    }
    std::vector<Ends> edges;
    for (std::size_t i = 0; i < arrangement_.edges.size(); ++i) {
      edges.emplace_back(arrangement_.edges[i].a, arrangement_.edges[i].b);
      edge_of_[edges.back()] = i;
    }
    if (!triangulateConstrained(arrangement_.vertices, edges, all_))
      fail("outlines cannot be told apart");
  }

  Ends sideOf(std::size_t t, std::size_t k) const
  {
    const auto& corners = all_.triangles[t];
    return std::minmax(corners[k], corners[(k + 1) % 3]);
  }

  /** @brief Finds what is above and below the triangles; those that no outline parts
   * have the same. */
  void findRegions()
  {
    number_.assign(all_.triangles.size(), std::nullopt);
    std::vector<bool> is_known(all_.triangles.size(), false);
    for (std::size_t first = 0; first < is_known.size(); ++first) {
      if (is_known[first])
        continue;
      std::vector<std::size_t> part{first};
      is_known[first] = true;
      bool is_outside = false; // reaches the convex hull between its corners
      for (std::size_t i = 0; i < part.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) {
          const std::uint32_t next = all_.neighbours[part[i]][k];
          if (edge_of_.count(sideOf(part[i], k)) > 0)
            continue;
          is_outside = is_outside || next == kNone;
          if (next == kNone || is_known[next])
            continue;
          is_known[next] = true;
          part.push_back(next);
        }
      if (!is_outside)
        addPart(part);
    }
  }

  void addPart(const std::vector<std::size_t>& part)
  {
    const std::size_t largest = *std::max_element(
        part.begin(), part.end(),
        [this](std::size_t a, std::size_t b) { return areaOf(a) < areaOf(b); });
    const auto& corners = all_.triangles[largest];
    const Vec2 middle = (plan_.points[corners[0]] + plan_.points[corners[1]] +
                         plan_.points[corners[2]]) /
                        3.0;
    PlanTriangle triangle;
    if (!lookup_.contains(middle))
      return;
    triangle.floor = lookup_.floorDetailAt(middle);
    triangle.ceiling = lookup_.detailAt(middle);
    triangle.floor_is_open =
        std::any_of(floor_voids_.begin(), floor_voids_.end(),
                    [&](const Loop& hole) { return hole.contains(middle); });
    for (std::size_t i = 0; i < room_.voids.size(); ++i)
      if (room_.voids[i].loop.contains(middle))
        triangle.hole_above = i;
    for (const std::size_t t : part) {
      number_[t] = plan_.triangles.size();
      triangle.corners = all_.triangles[t];
      plan_.triangles.push_back(triangle);
    }
  }

  double areaOf(std::size_t t) const
  {
    const auto& corners = all_.triangles[t];
    const Vec2 a = plan_.points[corners[0]];
    return cross(plan_.points[corners[1]] - a, plan_.points[corners[2]] - a);
  }

  void collectSides()
  {
    for (std::size_t t = 0; t < number_.size(); ++t)
      for (std::size_t k = 0; number_[t] && k < 3; ++k) {
        const std::uint32_t next = all_.neighbours[t][k];
        PlanSide side;
        side.a = all_.triangles[t][k];
        side.b = all_.triangles[t][(k + 1) % 3];
        side.triangle = *number_[t];
        if (next != kNone)
          side.beyond = number_[next];
        if (!side.beyond)
          findWall(side, sideOf(t, k));
        else if (*side.beyond < side.triangle || !changes(side))
          continue;
        plan_.sides.push_back(side);
      }
  }

  bool changes(const PlanSide& side) const
  {
    const PlanTriangle& left = plan_.triangles[side.triangle];
    const PlanTriangle& right = plan_.triangles[*side.beyond];
    return left.floor != right.floor || left.ceiling != right.ceiling;
  }

  /** @brief Finds the wall that a side of the room is a part of; none for columns. */
  void findWall(PlanSide& side, const Ends& ends) const
  {
    const auto edge = edge_of_.find(ends);
    if (edge == edge_of_.end())
      return;
    for (const SegmentUse& use : arrangement_.edges[edge->second].uses) {
      const Chord& chord = chords_[use.segment];
      if (!chord.wall)
        continue;
      const Vec2 along = chord.end - chord.start;
      const auto at = [&](const Vec2& point) {
        const double t = along.dot(point - chord.start) / along.squaredNorm();
        return chord.from + t * (chord.to - chord.from);
      };
      side.wall = chord.wall;
      side.from = at(plan_.points[side.a]);
      side.to = at(plan_.points[side.b]);
      return;
    }
  }

  const Room& room_;
  const RoomLookup lookup_;
  const std::vector<Opening>& openings_;
  const std::vector<Loop>& floor_voids_;
  std::vector<Vec2> corners_; ///< of all loops but the outline
  std::vector<Chord> chords_;
  Arrangement arrangement_;
  std::map<Ends, std::size_t> edge_of_; ///< edge of the arrangement between points
  PlanTriangulation all_;               ///< of the convex hull of the room
  std::vector<std::optional<std::size_t>> number_; ///< in the plan, of each of `all_`
  RoomPlan plan_;
};

} // namespace

RoomPlan
planOf(const Room& room,
       const std::vector<Opening>& openings,
       const std::vector<Loop>& floor_voids)
{
  return PlanBuilder(room, openings, floor_voids).run();
}

} // namespace pcl::sedr::sim
