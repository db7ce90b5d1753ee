// SPDX-License-Identifier: BSD-3-Clause
#include "room_cells.h"

#include "simulator/scene/shapes.h"

#include "sedr_filters/src/plan/room_lookup.h"
#include "sedr_surface/src/triangulation/triangulation.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace pcl::sedr::sim {

namespace {

constexpr auto kNone = PlanTriangulation::none;

/** @brief What a chord is a part of. */
enum class Part { Wall, FarSide, Other };

/** @brief A chord of a loop. */
struct Chord {
  Vec2 start;
  Vec2 end;
  Part part = Part::Other;
};

/** @brief A niche, or the reveal of an opening. */
struct Recess {
  Loop outline; ///< along the wall, to its back, along that, and to the start
  Space space;
};

/** @brief Returns the label of a detail of a floor or ceiling; -1: @p whole. */
Label
labelOf(const std::vector<PlanDetail>& details, int detail, Label whole)
{
  return detail < 0 || details[static_cast<std::size_t>(detail)].is_facet
             ? whole
             : Label::Detail;
}

/** @brief Returns a box around a room. */
Eigen::AlignedBox3d
boxAround(const Room& room)
{
  const Box2 plan = boundsOf(room.boundary);
  Eigen::AlignedBox3d box;
  const auto extend = [&](const Slab& slab, double above) {
    for (int k = 0; k < 4; ++k) {
      const Vec2 corner = plan.corner(static_cast<Box2::CornerType>(k));
      const double z = slab.curve ? slab.curve->highest() : slab.heightAt(corner);
      box.extend(lifted(corner, z + above));
    }
  };
  extend(room.floor, 0.0);
  extend(room.ceiling, room.plenum);
  for (const auto* details : {&room.floor_details, &room.details})
    for (const PlanDetail& detail : *details)
      extend(detail.slab, 0.0);
  return box;
}

using Ends = std::pair<std::uint32_t, std::uint32_t>; ///< lower point first

/** @brief Builds the cells of one room. */
class CellBuilder {
public:
  CellBuilder(const Scene& scene, std::size_t index)
      : scene_(scene)
      , room_(scene.rooms[index])
      , lookup_(room_)
      , tilted_(tiltedPartsOf(room_))
      , floor_voids_(floorVoidsOf(scene)[index])
  {
    for (const WallGap& niche : room_.wall_niches) {
      const Element back = offsetRight(faceOf(room_, niche), niche.depth);
      addRecess(faceOf(room_, niche), reversed(Loop{{back}}).elements[0],
                {Space::Niche, horizontalSlab(niche.sill), horizontalSlab(niche.head),
                 Label::Detail, Label::Detail});
    }
    for (const Room& room : scene.rooms)
      for (const Opening& opening : room.openings)
        if (&room == &room_ || opening.leads_to == index) {
          Space reveal{Space::Reveal, horizontalSlab(opening.sill),
                       horizontalSlab(opening.head)};
          reveal.opening = opening.number;
          reveal.is_given = &room == &room_;
          addRecess(faceOf(room, opening), backOf(scene, room, opening), reveal);
        }
    findNeighbours();
  }

  RoomCells run()
  {
    collectChords();
    triangulate();
    findCells();
    collectSides();
    return std::move(cells_);
  }

private:
  void addRecess(const Element& face, const Element& back, const Space& space)
  {
    recesses_.push_back(
        {{{face, segment(face.end, back.start), back, segment(back.end, face.start)}},
         space});
  }

  /** @brief Finds the rooms that the room or its recesses might reach into. */
  void findNeighbours()
  {
    Eigen::AlignedBox3d box = boxAround(room_);
    for (const Recess& recess : recesses_)
      for (const Element& side : recess.outline.elements)
        box.extend(lifted(side.start, box.center().z()));
    for (const Room& other : scene_.rooms)
      if (&other != &room_ && boxAround(other).intersects(box))
        neighbours_.push_back(&other);
  }

  void collectChords()
  {
    std::vector<const Loop*> loops;
    for (const Loop& column : room_.columns)
      loops.push_back(&column);
    for (const auto* details : {&room_.details, &room_.floor_details})
      for (const PlanDetail& detail : *details)
        loops.push_back(&detail.boundary);
    for (const CeilingVoid& hole : room_.voids) {
      loops.push_back(&hole.loop);
      if (hole.leads_to) // whose steps end its shaft
        for (const PlanDetail& step : scene_.rooms[*hole.leads_to].floor_details)
          loops.push_back(&step.boundary);
    }
    for (const Loop& hole : floor_voids_)
      loops.push_back(&hole);
    for (const Recess& recess : recesses_)
      loops.push_back(&recess.outline);
    for (const Room* other : neighbours_)
      loops.push_back(&other->boundary);
    for (const Loop* loop : loops)
      for (const Element& element : loop->elements)
        corners_.push_back(element.start);
    for (const Element& wall : room_.boundary.elements)
      addChords(wall, Part::Wall);
    for (const TiltedPart& part : tilted_)
      for (const Element& side : part.outline.elements)
        addChords(side, Part::Wall);
    for (const Loop* loop : loops)
      for (const Element& element : loop->elements)
        addChords(element, Part::Other);
    for (const PlanDetail& detail : room_.details)
      for (const Element& crease : creasesOf(detail))
        addChords(crease, Part::Other);
    for (const Recess& recess : recesses_)
      if (recess.space.kind == Space::Reveal)
        addChords(recess.outline.elements[2], Part::FarSide);
  }

  void addChords(const Element& element, Part part)
  {
    std::vector<double> cuts;
    if (element.isArc()) // corners on the arc are ends of chords, too
      for (const Vec2& corner : corners_)
        if (const auto s = locate(element, corner))
          cuts.push_back(*s);
    const std::vector<Vec2> ends = chordPoints(element, std::move(cuts));
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
      chords_.push_back({ends[i], ends[i + 1], part});
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
      cells_.points.push_back(known == places.end() ? grid.toPlan(vertex)
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

  /** @brief Joins triangles that no outline parts to cells. */
  void findCells()
  {
    cell_of_.assign(all_.triangles.size(), std::nullopt);
    cells_.cells.emplace_back(); // outside
    for (std::size_t first = 0; first < cell_of_.size(); ++first) {
      if (cell_of_[first])
        continue;
      std::vector<std::size_t> part{first};
      cell_of_[first] = cells_.cells.size();
      bool is_outside = false; // reaches the convex hull between its corners
      for (std::size_t i = 0; i < part.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) {
          const std::uint32_t next = all_.neighbours[part[i]][k];
          if (edge_of_.count(sideOf(part[i], k)) > 0)
            continue;
          is_outside = is_outside || next == kNone;
          if (next == kNone || cell_of_[next])
            continue;
          cell_of_[next] = cell_of_[first];
          part.push_back(next);
        }
      const Spaces spaces = is_outside ? Spaces() : spacesOf(part);
      for (const std::size_t t : part)
        if (spaces.empty())
          cell_of_[t] = 0;
        else
          cells_.triangles.push_back({all_.triangles[t], cells_.cells.size()});
      if (!spaces.empty())
        cells_.cells.push_back(spaces);
    }
  }

  /** @brief Returns the spaces over the largest of some triangles. */
  Spaces spacesOf(const std::vector<std::size_t>& part) const
  {
    const std::size_t largest = *std::max_element(
        part.begin(), part.end(),
        [this](std::size_t a, std::size_t b) { return areaOf(a) < areaOf(b); });
    const auto& corners = all_.triangles[largest];
    const auto& points = cells_.points;
    const Vec2 middle =
        (points[corners[0]] + points[corners[1]] + points[corners[2]]) / 3.0;
    Spaces spaces;
    if (lookup_.contains(middle) || slantAt(middle, true))
      addInside(middle, spaces);
    else if (isInVoid(middle))
      fail("a void reaches out of the room", placeText(middle));
    for (const Recess& recess : recesses_)
      if (recess.outline.contains(middle))
        spaces.push_back(recess.space);
    for (const Space& space : spaces)
      expectClear(space, middle);
    std::stable_sort(spaces.begin(), spaces.end(), [&](const Space& a, const Space& b) {
      return a.low.heightAt(middle) < b.low.heightAt(middle);
    });
    return spaces;
  }

  /** @brief Checks that a space is in no other room. */
  void expectClear(const Space& space, const Vec2& place) const
  {
    constexpr double contact = 1e-6; // metres
    for (const Room* other : neighbours_)
      if (other->boundary.contains(place) &&
          std::max(space.low.heightAt(place), other->floorAt(place)) + contact <
              std::min(space.high.heightAt(place),
                       other->ceilingAt(place) + other->plenum))
        fail(space.kind == Space::Inside
                 ? "it overlaps room '"
                 : "an opening, niche, void or plenum reaches into room '",
             other->name, "'", placeText(place));
  }

  bool isInVoid(const Vec2& place) const
  {
    return floorIsOpen(place) || std::any_of(room_.voids.begin(), room_.voids.end(),
                                             [&](const CeilingVoid& hole) {
                                               return hole.loop.contains(place);
                                             });
  }

  /** @brief Returns the wall at a place that is tilted outwards, or inwards; null if
   * there is none. */
  const TiltedPart* slantAt(const Vec2& place, bool outwards) const
  {
    for (const TiltedPart& part : tilted_)
      if (part.is_outwards == outwards && part.outline.contains(place))
        return &part;
    return nullptr;
  }

  bool floorIsOpen(const Vec2& place) const
  {
    return std::any_of(floor_voids_.begin(), floor_voids_.end(),
                       [&](const Loop& hole) { return hole.contains(place); });
  }

  /** @brief Adds the room at a place, and the shaft or plenum above it. */
  void addInside(const Vec2& place, Spaces& spaces) const
  {
    const int floor = lookup_.floorDetailAt(place);
    const int ceiling = lookup_.detailAt(place);
    Space inside{Space::Inside,
                 room_.floorSlab(floor),
                 room_.ceilingSlab(ceiling),
                 labelOf(room_.floor_details, floor, Label::Floor),
                 labelOf(room_.details, ceiling, Label::Ceiling),
                 floorIsOpen(place)};
    if (const TiltedPart* part = slantAt(place, true)) {
      inside.low = part->wall;
      inside.floor = Label::Wall;
    }
    if (const TiltedPart* part = slantAt(place, false)) {
      inside.high = part->wall;
      inside.ceiling = Label::Wall;
    }
    std::optional<Space> above;
    if (room_.plenum > 0.0)
      above = Space{Space::Plenum, inside.high, raised(room_.ceiling, room_.plenum)};
    for (const CeilingVoid& hole : room_.voids)
      if (hole.loop.contains(place)) {
        inside.ceiling_is_open = true;
        if (!hole.leads_to && !above)
          fail("a void leads to no room, and there is no plenum", placeText(place));
        if (!hole.leads_to)
          continue;
        const Room& next = scene_.rooms[*hole.leads_to];
        above =
            Space{Space::Shaft, inside.high, next.floorSlab(next.floorDetailAt(place))};
      }
    spaces.push_back(inside);
    if (above)
      spaces.push_back(*above);
  }

  double areaOf(std::size_t t) const
  {
    const auto& corners = all_.triangles[t];
    const Vec2 a = cells_.points[corners[0]];
    return cross(cells_.points[corners[1]] - a, cells_.points[corners[2]] - a);
  }

  void collectSides()
  {
    for (std::size_t t = 0; t < cell_of_.size(); ++t)
      for (std::size_t k = 0; *cell_of_[t] > 0 && k < 3; ++k) {
        const std::uint32_t next = all_.neighbours[t][k];
        PlanSide side{all_.triangles[t][k], all_.triangles[t][(k + 1) % 3],
                      *cell_of_[t], next == kNone ? 0 : *cell_of_[next]};
        if (side.beyond == side.cell)
          continue;
        for (const SegmentUse& use :
             arrangement_.edges[edge_of_.at(sideOf(t, k))].uses) {
          const Part part = chords_[use.segment].part;
          side.is_wall = side.is_wall || part == Part::Wall;
          side.is_far_side = side.is_far_side || part == Part::FarSide;
        }
        cells_.sides.push_back(side);
      }
  }

  const Scene& scene_;
  const Room& room_;
  const RoomLookup lookup_;
  const std::vector<TiltedPart> tilted_;
  const std::vector<Loop> floor_voids_;
  std::vector<Recess> recesses_;
  std::vector<const Room*> neighbours_;
  std::vector<Vec2> corners_; ///< of all loops but the outline
  std::vector<Chord> chords_;
  Arrangement arrangement_;
  std::map<Ends, std::size_t> edge_of_; ///< edge of the arrangement between points
  PlanTriangulation all_;               ///< of the convex hull of the room
  std::vector<std::optional<std::size_t>> cell_of_; ///< of each of `all_`
  RoomCells cells_;
};

} // namespace

RoomCells
cellsOf(const Scene& scene, std::size_t index)
{
  return CellBuilder(scene, index).run();
}

} // namespace pcl::sedr::sim
