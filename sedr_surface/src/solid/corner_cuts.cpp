// SPDX-License-Identifier: BSD-3-Clause
#include "plan_subdivision.h"

#include "vertex_levels.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

namespace {

/** @brief Returns the solid spans above the sectors of a vertex. Sector `changed`, if
 * valid, is taken as `region`. */
std::vector<SolidSpan>
spansAt(const VertexLevels& levels,
        const std::vector<Spoke>& spokes,
        std::size_t changed,
        const PlanRegion& region)
{
  std::vector<SolidSpan> spans;
  for (std::size_t s = 0; s < spokes.size(); ++s) {
    const PlanRegion& here = s == changed ? region : spokes[s].left;
    if (here.isRoom())
      spans.push_back({levels.levelOf(here.floor), levels.levelOf(here.ceiling)});
    else
      spans.emplace_back();
  }
  return spans;
}

/** @brief A corner to cut off: a sector of a vertex and its new region. */
struct CornerCut {
  std::size_t sector = 0;
  PlanRegion region;
  double angle = 0;   ///< radians
  bool heals = false; ///< whether the solid then no longer touches itself

  bool isBetterThan(const CornerCut& o) const
  {
    return heals != o.heals ? heals : angle < o.angle;
  }
};

/** @brief Returns the candidate cuts, the best first: those that heal a vertex, then by
 * increasing angle. */
std::vector<CornerCut>
cutsAt(const RoomLayers& layers,
       const PlanSubdivision& plan,
       std::uint32_t v,
       const std::vector<Spoke>& spokes)
{
  const VertexLevels levels(layers, plan, v, spokes);
  std::vector<CornerCut> cuts;
  for (std::size_t s = 0; s < spokes.size(); ++s) {
    const Spoke& next = spokes[(s + 1) % spokes.size()];
    const Eigen::Vector2d a = plan.wayFrom(v, spokes[s].end);
    const Eigen::Vector2d b = plan.wayFrom(v, next.end);
    CornerCut cut;
    cut.sector = s;
    cut.angle = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
    if (cut.angle <= 0)
      continue; // 180 degrees or more
    for (const PlanRegion& region : {spokes[s].right, next.left}) {
      cut.region = region;
      cut.heals = !touchesItself(spansAt(levels, spokes, s, region));
      cuts.push_back(cut);
    }
  }
  std::stable_sort(
      cuts.begin(), cuts.end(),
      [](const CornerCut& c, const CornerCut& d) { return c.isBetterThan(d); });
  return cuts;
}

bool
segmentsMeet(const GridPoint& a,
             const GridPoint& b,
             const GridPoint& c,
             const GridPoint& d)
{
  const auto apart = [](std::int64_t s, std::int64_t t) {
    return (s > 0 && t > 0) || (s < 0 && t < 0);
  };
  return !apart(turn(a, b, c), turn(a, b, d)) && !apart(turn(c, d, a), turn(c, d, b));
}

/** @brief Returns whether the segment p to q, which cuts off the corner of two edges at
 * v, meets no other edge. */
bool
isFree(const PlanSubdivision& plan,
       std::uint32_t v,
       const GridPoint& p,
       const GridPoint& q)
{
  return std::none_of(plan.edges.begin(), plan.edges.end(), [&](const auto& edge) {
    return edge.a != v && edge.b != v &&
           segmentsMeet(p, q, plan.vertices[edge.a], plan.vertices[edge.b]);
  });
}

/** @brief Returns the place on a spoke at a distance from its vertex, metres. */
GridPoint
placeOn(const PlanSubdivision& plan,
        std::uint32_t v,
        const Spoke& spoke,
        double distance)
{
  const Eigen::Vector2d from = plan.placeOf(v);
  const Eigen::Vector2d way = (plan.placeOf(spoke.end) - from).normalized();
  return plan.grid.toGrid(from + distance * way);
}

/** @brief Finds where to cut off the corner of two spokes: a millimetre from it. Less
 * if something else is as near; more if the angle is so sharp or so blunt that the
 * triangle degenerates on the grid. */
bool
placeCut(const PlanSubdivision& plan,
         std::uint32_t v,
         const Spoke& first,
         const Spoke& second,
         GridPoint& p,
         GridPoint& q)
{
  const double unit = plan.grid.unit();
  const double most =
      0.3 * unit *
      std::min(plan.wayFrom(v, first.end).norm(), plan.wayFrom(v, second.end).norm());
  double size = std::min(20 * solidSeparation(plan.grid), most);
  const auto place = [&] {
    p = placeOn(plan, v, first, size);
    q = placeOn(plan, v, second, size);
    return turn(plan.vertices[v], p, q) > 0;
  };
  while (!place() && size < most)
    size = std::min(2 * size, most);
  while (place() && !isFree(plan, v, p, q) && size > 4 * unit)
    size /= 2;
  return place() && isFree(plan, v, p, q);
}

/** @brief Splits a spoke at a place. The part at the vertex gets other regions, or is
 * removed if both are equal.
 * @return the new vertex */
std::uint32_t
cutSpoke(PlanSubdivision& plan,
         const Spoke& spoke,
         const GridPoint& place,
         const PlanRegion& left,
         const PlanRegion& right,
         std::vector<bool>& is_dropped)
{
  const auto middle = static_cast<std::uint32_t>(plan.vertices.size());
  plan.vertices.push_back(place);
  SubdivisionEdge inner = plan.edges[spoke.edge];
  SubdivisionEdge& outer = plan.edges[spoke.edge];
  (spoke.forward ? outer.a : outer.b) = middle;
  (spoke.forward ? inner.b : inner.a) = middle;
  inner.left = spoke.forward ? left : right;
  inner.right = spoke.forward ? right : left;
  plan.edges.push_back(inner);
  is_dropped.push_back(left == right);
  return middle;
}

bool
applyCut(PlanSubdivision& plan,
         std::uint32_t v,
         const std::vector<Spoke>& spokes,
         const CornerCut& cut)
{
  const Spoke& first = spokes[cut.sector];
  const Spoke& second = spokes[(cut.sector + 1) % spokes.size()];
  GridPoint p;
  GridPoint q;
  if (!placeCut(plan, v, first, second, p, q))
    return false;
  std::vector<bool> is_dropped(plan.edges.size(), false);
  const bool joins_first = cut.region == first.right;
  SubdivisionEdge rim;
  rim.elements = plan.edges[joins_first ? first.edge : second.edge].elements;
  rim.a = cutSpoke(plan, first, p, cut.region, first.right, is_dropped);
  rim.b = cutSpoke(plan, second, q, second.left, cut.region, is_dropped);
  rim.left = cut.region;
  rim.right = first.left;
  plan.edges.push_back(rim);
  is_dropped.push_back(rim.left == rim.right);
  plan.dropEdges(is_dropped);
  return true;
}

} // namespace

std::size_t
cutTouchingCorners(const RoomLayers& layers, PlanSubdivision& plan)
{
  std::size_t cuts = 0;
  auto spokes = spokesOf(plan);
  const auto count = static_cast<std::uint32_t>(plan.vertices.size());
  for (std::uint32_t v = 0; v < count; ++v)
    for (int tries = 0; tries < 8 && spokes[v].size() > 2; ++tries) {
      const VertexLevels levels(layers, plan, v, spokes[v]);
      if (!touchesItself(spansAt(levels, spokes[v], spokes[v].size(), {})))
        break;
      const auto possible = cutsAt(layers, plan, v, spokes[v]);
      if (std::none_of(possible.begin(), possible.end(), [&](const CornerCut& cut) {
            return applyCut(plan, v, spokes[v], cut);
          }))
        break;
      ++cuts;
      spokes = spokesOf(plan);
    }
  return cuts;
}

} // namespace pcl::sedr
