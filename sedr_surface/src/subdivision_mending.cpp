// SPDX-License-Identifier: BSD-3-Clause
#include "subdivision_mending.h"

#include <pcl/sedr_surface/vertex_levels.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace pcl {
namespace sedr {

namespace {

Eigen::Vector2d
wayOf(const PlanSubdivision& plan, std::uint32_t from, std::uint32_t to)
{
  const GridPoint& a = plan.vertices[from];
  const GridPoint& b = plan.vertices[to];
  return Eigen::Vector2d(b.x, b.y) - Eigen::Vector2d(a.x, a.y);
}

/** @brief Elements that lie on both of two edges. */
std::vector<std::size_t>
commonElements(const SubdivisionEdge& e, const SubdivisionEdge& f)
{
  std::vector<std::size_t> common;
  std::set_intersection(e.elements.begin(), e.elements.end(), f.elements.begin(),
                        f.elements.end(), std::back_inserter(common));
  return common;
}

void
dropEdges(PlanSubdivision& plan, const std::vector<bool>& is_dropped)
{
  std::size_t kept = 0;
  for (std::size_t e = 0; e < plan.edges.size(); ++e)
    if (!is_dropped[e])
      plan.edges[kept++] = plan.edges[e];
  plan.edges.resize(kept);
}

} // namespace

void
dropNeedlessVertices(PlanSubdivision& plan)
{
  constexpr double straight = 4; // grid units: what rounding leaves
  auto spokes = spokesOf(plan);
  std::vector<bool> is_dropped(plan.edges.size(), false);
  for (std::uint32_t v = 0; v < plan.vertices.size(); ++v) {
    if (spokes[v].size() != 2)
      continue;
    const Spoke in = spokes[v][0];
    const Spoke out = spokes[v][1];
    const auto common = commonElements(plan.edges[in.edge], plan.edges[out.edge]);
    const double length = distance(plan.vertices[in.end], plan.vertices[out.end]);
    const auto off = static_cast<double>(
        turn(plan.vertices[in.end], plan.vertices[out.end], plan.vertices[v]));
    const bool is_between =
        wayOf(plan, v, in.end).dot(wayOf(plan, v, out.end)) < 0;
    if (common.empty() || !is_between || std::abs(off) > straight * length)
      continue;
    // The first edge goes on to where the second ends; what was on the left of the way
    // to v stays there.
    plan.edges[in.edge] = {in.end, out.end, in.right, in.left, common};
    is_dropped[out.edge] = true;
    for (const auto& [vertex, other] : {std::make_pair(in.end, out.end),
                                        std::make_pair(out.end, in.end)})
      for (Spoke& spoke : spokes[vertex])
        if (spoke.edge == in.edge || spoke.edge == out.edge) {
          spoke.edge = in.edge;
          spoke.forward = vertex == in.end;
          spoke.end = other;
        }
  }
  dropEdges(plan, is_dropped);
}

namespace {

/** @brief Where along an edge, from 0 to 1, two slabs have one height; negative if they
 * have not or do at an end. */
double
crossingOf(const RoomLayers& layers,
           const PlanSubdivision& plan,
           const SubdivisionEdge& edge,
           int slab,
           int other)
{
  if (slab == other || slab == PlanRegion::nothing || other == PlanRegion::nothing)
    return -1;
  const auto heightOver = [&](std::uint32_t v) {
    const Eigen::Vector2d p = plan.placeOf(v);
    return layers.slabs[static_cast<std::size_t>(slab)].slab.heightAt(p) -
           layers.slabs[static_cast<std::size_t>(other)].slab.heightAt(p);
  };
  const double at_a = heightOver(edge.a);
  const double at_b = heightOver(edge.b);
  const double same = solidSeparation(plan.grid);
  const bool crosses = std::min(at_a, at_b) < -same && std::max(at_a, at_b) > same;
  return crosses ? at_a / (at_a - at_b) : -1;
}

/** @brief Cuts an edge at a share of its length; the second part is added.
 * @return whether there is a grid point between its ends */
bool
cutEdge(PlanSubdivision& plan, std::size_t e, double share)
{
  SubdivisionEdge& first = plan.edges[e];
  const GridPoint middle = plan.grid.toGrid(plan.placeOf(first.a) * (1 - share) +
                                            plan.placeOf(first.b) * share);
  if (middle == plan.vertices[first.a] || middle == plan.vertices[first.b])
    return false;
  SubdivisionEdge second = first;
  first.b = second.a = static_cast<std::uint32_t>(plan.vertices.size());
  plan.vertices.push_back(middle);
  plan.edges.push_back(std::move(second));
  return true;
}

} // namespace

void
splitWhereHeightsCross(const RoomLayers& layers, PlanSubdivision& plan)
{
  for (std::size_t e = 0; e < plan.edges.size(); ++e) {
    bool is_cut = true;
    while (is_cut) {
      is_cut = false;
      const SubdivisionEdge edge = plan.edges[e];
      for (const int slab : {edge.left.floor, edge.left.ceiling})
        for (const int other : {edge.right.floor, edge.right.ceiling}) {
          const double share = crossingOf(layers, plan, edge, slab, other);
          if (!is_cut && share > 0)
            is_cut = cutEdge(plan, e, share);
        }
    }
  }
}

namespace {

/** @brief What stands above the sectors of a vertex; `changed` of them, if below their
 * number, as if its region were another one about the vertex. */
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

/** @brief A corner to cut off: a sector of a vertex, and the region it goes to. */
struct CornerCut {
  std::size_t sector = 0;
  PlanRegion region;
  double angle = std::numeric_limits<double>::infinity();
  bool heals = false; ///< whether the solid then touches itself no more

  bool isBetterThan(const CornerCut& o) const
  {
    return heals != o.heals ? heals : angle < o.angle;
  }
};

/** @brief The sharpest corner that heals a vertex, or else the sharpest. */
CornerCut
chooseCut(const RoomLayers& layers,
          const PlanSubdivision& plan,
          std::uint32_t v,
          const std::vector<Spoke>& spokes)
{
  const VertexLevels levels(layers, plan, v, spokes);
  CornerCut best;
  for (std::size_t s = 0; s < spokes.size(); ++s) {
    const Spoke& next = spokes[(s + 1) % spokes.size()];
    const Eigen::Vector2d a = wayOf(plan, v, spokes[s].end);
    const Eigen::Vector2d b = wayOf(plan, v, next.end);
    CornerCut cut;
    cut.sector = s;
    cut.angle = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
    if (cut.angle <= 0)
      continue; // 180 degrees or more
    for (const PlanRegion& region : {spokes[s].right, next.left}) {
      cut.region = region;
      cut.heals = !touchesItself(spansAt(levels, spokes, s, region));
      if (cut.isBetterThan(best))
        best = cut;
    }
  }
  return best;
}

bool
segmentsMeet(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& d)
{
  const auto apart = [](std::int64_t s, std::int64_t t) {
    return (s > 0 && t > 0) || (s < 0 && t < 0);
  };
  return !apart(turn(a, b, c), turn(a, b, d)) && !apart(turn(c, d, a), turn(c, d, b));
}

/** @brief Whether nothing but the two edges at v is met by the segment p to q, which
 * cuts off their corner. */
bool
isFree(const PlanSubdivision& plan, std::uint32_t v, const GridPoint& p, const GridPoint& q)
{
  return std::none_of(plan.edges.begin(), plan.edges.end(), [&](const auto& edge) {
    return edge.a != v && edge.b != v &&
           segmentsMeet(p, q, plan.vertices[edge.a], plan.vertices[edge.b]);
  });
}

/** @brief The place on a spoke at a distance from its vertex, metres. */
GridPoint
placeOn(const PlanSubdivision& plan, std::uint32_t v, const Spoke& spoke, double distance)
{
  const Eigen::Vector2d from = plan.placeOf(v);
  const Eigen::Vector2d way = (plan.placeOf(spoke.end) - from).normalized();
  return plan.grid.toGrid(from + distance * way);
}

/** @brief Cuts a spoke in two at a place; the part at the vertex gets other regions, or
 * goes where both are the same.
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
  constexpr double largest = 0.001; // metres
  const Spoke& first = spokes[cut.sector];
  const Spoke& second = spokes[(cut.sector + 1) % spokes.size()];
  const double unit = plan.grid.unit();
  double size = std::min({largest, 0.3 * unit * wayOf(plan, v, first.end).norm(),
                          0.3 * unit * wayOf(plan, v, second.end).norm()});
  GridPoint p;
  GridPoint q;
  do {
    p = placeOn(plan, v, first, size);
    q = placeOn(plan, v, second, size);
    size /= 2;
  } while (size > 4 * unit && !isFree(plan, v, p, q));
  if (turn(plan.vertices[v], p, q) <= 0 || !isFree(plan, v, p, q))
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
  dropEdges(plan, is_dropped);
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
      const CornerCut cut = chooseCut(layers, plan, v, spokes[v]);
      if (std::isinf(cut.angle) || !applyCut(plan, v, spokes[v], cut))
        break;
      ++cuts;
      spokes = spokesOf(plan);
    }
  return cuts;
}

} // namespace sedr
} // namespace pcl
