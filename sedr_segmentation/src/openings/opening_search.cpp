// SPDX-License-Identifier: BSD-3-Clause
#include "opening_search.h"

#include "opening_gains.h"
#include "sedr_filters/src/base/parallel.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace pcl::sedr {
namespace {

/** @brief Whether two openings are the same one, seen from two sides or by two walls in
 * a line. */
bool
areSame(const PlanOpening& a, const PlanOpening& b, double max_depth)
{
  const Eigen::Vector2d way = (a.end - a.start).normalized();
  const Eigen::Vector2d left(-way.y(), way.x());
  if (std::abs(way.dot((b.end - b.start).normalized())) < opening_numbers.min_cosine ||
      std::abs(left.dot((b.start + b.end - a.start - a.end) / 2)) > max_depth)
    return false;
  const double s0 = way.dot(b.start - a.start);
  const double s1 = way.dot(b.end - a.start);
  const double along =
      std::min(a.width(), std::max(s0, s1)) - std::max(0.0, std::min(s0, s1));
  const double up = std::min(a.top, b.top) - std::max(a.bottom, b.bottom);
  return along > opening_numbers.same_share * std::min(a.width(), b.width()) &&
         up > opening_numbers.same_share * std::min(a.height(), b.height());
}

/** @brief Returns the id of the room at a place behind a wall; 0: none. */
std::uint32_t
roomBehind(const Floorplan& plan, const PlanOpening& opening, double depth)
{
  const Eigen::Vector2d way = (opening.end - opening.start).normalized();
  const Eigen::Vector2d place =
      (opening.start + opening.end) / 2 + depth * Eigen::Vector2d(way.y(), -way.x());
  const double height = (opening.bottom + opening.top) / 2;
  for (const PlanRoom& room : plan.rooms)
    if (room.contains(place) && room.floorAt(place) < height &&
        room.ceilingAt(place) > height)
      return room.id;
  return 0;
}

/** @brief Returns how deep the jambs and the head of an opening were seen behind the
 * face, metres, at least a thin wall; the depth of the map where they were not. */
double
revealDepth(const WallMap& map, const WallRectangle& at)
{
  const double reach = opening_numbers.on_face;
  const double deepest = map.depthAt((at.from + at.to) / 2, (at.bottom + at.top) / 2);
  std::vector<double> depths;
  for (const SidePoint& p : map.points())
    if (p.offset < -2 * map.tolerance() && p.along > at.from - reach &&
        p.along < at.to + reach && p.height > at.bottom + reach &&
        p.height < at.top + reach &&
        (p.along < at.from + reach || p.along > at.to - reach ||
         p.height > at.top - reach))
      depths.push_back(-p.offset);
  if (static_cast<double>(depths.size()) < opening_numbers.min_points)
    return deepest;
  constexpr double share = 0.95; // of them is seen before this share of the depth
  const auto deep =
      depths.begin() +
      static_cast<std::ptrdiff_t>(share * static_cast<double>(depths.size() - 1));
  std::nth_element(depths.begin(), deep, depths.end());
  return std::min(std::max(*deep / share, opening_numbers.usual_wall), deepest);
}

/** @brief Names the wall on which an opening was found, none of a column: of the
 * elements in line with its side that beside which most of the opening lies. */
void
addWall(const Floorplan& plan,
        const WallSide& side,
        double max_depth,
        PlanOpening& opening)
{
  if (!side.isWall())
    return;
  const PlanRoom& room = plan.rooms[side.room];
  const std::vector<PlanElement>& walls = room.boundary.elements;
  const auto lengthBeside = [&](const PlanElement& wall) {
    return std::abs(wall.project(opening.end) - wall.project(opening.start));
  };
  std::size_t best = side.element;
  for (std::size_t e = 0; e < walls.size() && !side.line.isArc(); ++e)
    if (const PlanElement& wall = walls[e];
        !wall.isArc() &&
        wall.normalAt(0).dot(side.line.normalAt(0)) >= opening_numbers.min_cosine &&
        std::abs(side.offset(wall.start)) <= max_depth &&
        lengthBeside(wall) > lengthBeside(walls[best]))
      best = e;
  opening.walls.push_back({room.id, best});
}

/** @brief Finds what may be openings on all sides. */
class OpeningFinder {
public:
  OpeningFinder(const Floorplan& plan,
                const OpeningParameters& parameters,
                OpeningSearch& search)
      : plan_(plan)
      , parameters_(parameters)
      , sizes_(parameters.sizes)
      , search_(search)
  {}

  void makeMaps(const PointView& points,
                const pcl::Indices* indices,
                const SightLines* sight)
  {
    const std::vector<WallSide>& sides = search_.sides;
    auto beside = pointsBeside(
        sides, points, indices, sizes_.before,
        std::max(sizes_.max_niche + 2 * Priors::run_gap, sizes_.max_depth));
    const std::vector<SightLine> rays =
        sight ? sight->lines() : std::vector<SightLine>();
    std::vector<std::optional<WallMap>> maps(sides.size());
    for (std::size_t k = 0; k < sides.size(); ++k) {
      backs_.emplace_back(sides, k, BehindKind::Opposite, sizes_.max_depth);
      bays_.emplace_back(sides, k, BehindKind::Own, sizes_.max_depth);
    }
    parallelFor(sides.size(), 1, parameters_.threads, [&](std::size_t k) {
      maps[k].emplace(plan_.rooms[sides[k].room], sides[k], std::move(beside[k]),
                      sizes_, rays, [&](double along, double height) {
                        const SideBehind* const face = backs_[k].at(along, height);
                        return face ? face->depth
                                    : std::numeric_limits<double>::infinity();
                      });
    });
    for (auto& map : maps)
      search_.maps.push_back(std::move(*map));
  }

  void find()
  {
    std::vector<std::vector<FoundOpening>> on_side(search_.sides.size());
    parallelFor(on_side.size(), 1, parameters_.threads, [&](std::size_t k) {
      if (search_.sides[k].may_have_openings)
        on_side[k] = openingsOn(k);
    });
    for (auto& list : on_side)
      search_.found.insert(search_.found.end(), list.begin(), list.end());
  }

private:
  std::vector<FoundOpening> openingsOn(std::size_t side) const
  {
    const WallMap& map = search_.maps[side];
    const double length = search_.sides[side].line.length();
    const auto along = [&](std::size_t c) {
      return std::min(map.cell() * static_cast<double>(c), length);
    };
    std::vector<FoundOpening> found;
    const CellGains gains = gainsOn(side);
    for (const CellRectangle& cells : allRectangles(gains)) {
      WallRectangle rectangle{along(cells.first_column), along(cells.last_column),
                              map.heightOf(cells.first_row),
                              map.heightOf(cells.last_row)};
      if (const CellArch arch = bestArch(gains, cells, parameters_.weights.arch);
          arch.rise > 0) {
        rectangle.top = map.heightOf(0) + map.cell() * arch.top;
        rectangle.rise = map.cell() * arch.rise;
      }
      addFound(side, rectangle, 0, found);
    }
    return found;
  }

  /** @brief Adds a rectangle, and its parts where its lower one only has a back. */
  void addFound(std::size_t side,
                const WallRectangle& rectangle,
                int part,
                std::vector<FoundOpening>& found) const
  {
    const WallMap& map = search_.maps[side];
    FoundOpening candidate;
    candidate.side = side;
    candidate.part = part;
    const SideBehind* const behind = backs_[side].at(
        (rectangle.from + rectangle.to) / 2, (rectangle.bottom + rectangle.top) / 2);
    candidate.behind = behind ? behind->side : search_.sides.size();
    candidate.around = seenAround(search_, candidate, rectangle, sizes_);
    if (candidate.around < sizes_.min_around)
      return;
    candidate.rectangle = fittedEdges(map, rectangle, sizes_);
    describe(candidate);
    const PlanOpening& o = candidate.opening;
    if (o.rooms[0] == o.rooms[1] &&
        (candidate.behind == search_.sides.size() ||
         plan_.rooms[search_.sides[side].room].contains((o.start + o.end) / 2)))
      return; // no wall with two faces is between a room and itself
    const WallRectangle& at = candidate.rectangle;
    countCells(search_, sizes_, candidate);
    candidate.back = backOf(map, at);
    const double head =
        part == 0 && rectangle.rise == 0 ? headOfBack(map, at, sizes_) : at.bottom;
    candidate.split = (head - at.bottom) / (at.top - at.bottom);
    found.push_back(candidate);
    if (candidate.split > 0) {
      WallRectangle below = rectangle;
      WallRectangle above = rectangle;
      below.top = above.bottom = head;
      addFound(side, above, 2, found);
      if (found.back().part == 2) // its sill is the head of the other
        below.top = found.back().rectangle.bottom;
      addFound(side, below, 1, found);
    }
  }

  CellGains gainsOn(std::size_t k) const
  {
    const std::vector<WallSide>& sides = search_.sides;
    const WallMap& map = search_.maps[k];
    std::vector<MapBehind> behind(map.columns() * map.rows());
    std::vector<bool> is_wall(map.columns(), true);
    for (std::size_t c = 0; c < map.columns(); ++c) {
      const double s = map.cell() * (static_cast<double>(c) + 0.5);
      const Eigen::Vector2d place = sides[k].line.pointAt(s);
      const auto seenOf = [&](const SideBehind& other) {
        return search_.maps[other.side].seenHeight(
            sides[other.side].line.project(place));
      };
      for (std::size_t r = 0; r < map.rows(); ++r)
        if (const SideBehind* const other =
                backs_[k].at(s, map.heightOf(r) + map.cell() / 2))
          behind[c * map.rows() + r] = {&search_.maps[other->side],
                                        sides[other->side].line.project(place)};
      const std::vector<SideBehind>& backs = backs_[k].at(s);
      if (const std::vector<SideBehind>& bay = bays_[k].at(s); !bay.empty())
        is_wall[c] =
            bay.front().depth < opening_numbers.reveal_strip || // a pane
            (!backs.empty() && // the bay ends within the wall
             std::all_of(backs.begin(), backs.end(),
                         [&](const SideBehind& back) {
                           return seenOf(back) < sizes_.on_floor;
                         })) ||
            (map.reachesCeiling(s, sizes_.usual_lintel) && // no furniture
             map.seenHeight(s) > std::max(sizes_.on_floor, opening_numbers.bay_share *
                                                               seenOf(bay.front())));
    }
    return openingGains(map, behind, is_wall, parameters_.weights, sizes_);
  }

  /** @brief Sets places and rooms of an opening from its rectangle. */
  void describe(FoundOpening& candidate) const
  {
    const WallSide& side = search_.sides[candidate.side];
    const WallMap& map = search_.maps[candidate.side];
    const PlanRoom& room = plan_.rooms[side.room];
    const WallRectangle& at = candidate.rectangle;
    const bool is_paired = candidate.behind < search_.sides.size();
    const Eigen::Vector2d place = side.line.pointAt((at.from + at.to) / 2);
    PlanOpening& o = candidate.opening;
    o.depth = is_paired ? -search_.sides[candidate.behind].offset(place)
                        : revealDepth(map, at);
    const auto onMiddleLine = [&](double s) {
      s = std::clamp(s, 0.0, side.line.length());
      return Eigen::Vector2d(side.line.pointAt(s) -
                             o.depth / 2 * side.line.normalAt(s));
    };
    o.start = onMiddleLine(at.from);
    o.end = onMiddleLine(at.to);
    addWall(plan_, side, sizes_.max_depth, o);
    if (is_paired)
      addWall(plan_, search_.sides[candidate.behind], sizes_.max_depth, o);
    o.bottom = at.bottom;
    o.top = at.top;
    o.rise = at.rise;
    o.edges = at.edges;
    o.deviation_95 = at.deviation;
    o.rooms[0] = room.id;
    o.rooms[1] =
        is_paired
            ? plan_.rooms[search_.sides[candidate.behind].room].id
            : roomBehind(plan_, o,
                         map.depthAt((at.from + at.to) / 2, (at.bottom + at.top) / 2) -
                             o.depth / 2 + 0.3);
    const double floor = highestFloor(plan_, o);
    const double step =
        std::max(sizes_.on_floor, 1.2 * map.cell()); // rows hold the floor's points
    if (at.bottom - floor < step &&
        map.shareOf(WallCell::Seen, at.from, at.to, at.bottom - map.cell(), at.bottom) <
            0.5) {
      o.bottom = floor;
      o.edges[2] = {EdgeSeen::Reveal, Priors().unevenness};
    }
    double squares = 0;
    for (const OpeningEdge& edge : o.edges)
      squares += edge.error * edge.error;
    o.residual = std::sqrt(squares / 4);
  }

  const Floorplan& plan_;
  const OpeningParameters& parameters_;
  const OpeningSizes& sizes_;
  OpeningSearch& search_;
  std::vector<Backs> backs_;
  std::vector<Backs> bays_;
};

} // namespace

double
highestFloor(const Floorplan& plan, const PlanOpening& opening)
{
  const Eigen::Vector2d way = (opening.end - opening.start).normalized();
  const Eigen::Vector2d left(-way.y(), way.x());
  double floor = -std::numeric_limits<double>::infinity();
  for (const PlanRoom& room : plan.rooms)
    for (const int k : {0, 1})
      if (room.id == opening.rooms[static_cast<std::size_t>(k)]) {
        const double at = room.floorAt(
            (opening.start + opening.end) / 2 +
            (k == 0 ? 1 : -1) * (opening.depth / 2 + opening_numbers.inside) * left);
        if (at < (opening.bottom + opening.top) / 2) // not of a storey above
          floor = std::max(floor, at);
      }
  return floor;
}

OpeningSearch::OpeningSearch(const Floorplan& plan,
                             const PointView& points,
                             const pcl::Indices* indices,
                             const SightLines* sight,
                             const OpeningParameters& parameters)
    : sides(wallSides(plan, parameters.sizes))
{
  OpeningFinder finder(plan, parameters, *this);
  finder.makeMaps(points, indices, sight);
  finder.find();
}

void
OpeningSearch::keepEachOnce(double max_depth)
{
  std::vector<FoundOpening> all = std::move(found);
  found.clear();
  std::stable_sort(
      all.begin(), all.end(),
      [](const FoundOpening& a, const FoundOpening& b) { return a.odds > b.odds; });
  for (const FoundOpening& candidate : all) {
    const auto same =
        std::find_if(found.begin(), found.end(), [&](const FoundOpening& other) {
          const bool are_back_to_back =
              other.isNiche() && candidate.isNiche() && other.side != candidate.side;
          return !are_back_to_back &&
                 areSame(other.opening, candidate.opening, max_depth);
        });
    if (same == found.end())
      found.push_back(candidate);
    // A leaf may be flush with one face: the other side shows the edges.
    else if (candidate.odds > 0.9 * same->odds && candidate.behind == same->side &&
             candidate.closed < same->closed)
      *same = candidate;
  }
}

} // namespace pcl::sedr
