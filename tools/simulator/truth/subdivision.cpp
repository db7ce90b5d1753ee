// SPDX-License-Identifier: BSD-3-Clause
#include "subdivision.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace pcl::sedr::sim {

namespace {

constexpr double kTolerance = 1e-6; ///< metres; points closer than this are one node
constexpr double kSideProbe = 1e-5; ///< metres beside an edge to look up its regions

/** @brief Builds the edges between all loops of a room. */
class Subdivider {
public:
  explicit Subdivider(const Room& room)
      : room_(room)
  {}

  Subdivision run()
  {
    collectNodes();
    addLoop(room_.outline, EdgeSource::Outline);
    for (const Loop& column : room_.columns)
      addLoop(column, EdgeSource::Column);
    for (const Layer layer : {Layer::Ceiling, Layer::Floor})
      for (const SlabDetail& detail : detailsOf(room_, layer))
        addLoop(detail.loop, EdgeSource::Detail);
    return std::move(plan_);
  }

private:
  void collectNodes()
  {
    addNodes(room_.outline);
    for (const Loop& column : room_.columns)
      addNodes(column);
    for (const Layer layer : {Layer::Ceiling, Layer::Floor})
      for (const SlabDetail& detail : detailsOf(room_, layer))
        addNodes(detail.loop);
    for (const Niche& niche : room_.niches)
      addNodes(niche);
  }

  void addNodes(const Niche& niche)
  {
    if (niche.wall >= room_.outline.size())
      throw std::invalid_argument("A niche of room '" + room_.name +
                                  "' lies on no wall");
    const Element wall = elementOf(room_.outline, niche.wall);
    if (!(niche.from >= 0.0 && niche.from < niche.to && niche.to <= lengthOf(wall)))
      throw std::invalid_argument("A niche of room '" + room_.name +
                                  "' does not lie within its wall");
    addNode(pointAt(wall, niche.from));
    addNode(pointAt(wall, niche.to));
  }

  void addNodes(const Loop& loop)
  {
    for (const LoopVertex& vertex : loop)
      addNode(vertex.position);
  }

  void addNode(Vec2 point)
  {
    if (findNode(point) == plan_.nodes.size())
      plan_.nodes.push_back(point);
  }

  std::size_t findNode(Vec2 point) const
  {
    const auto isHere = [point](Vec2 node) {
      return dot(node - point, node - point) <= kTolerance * kTolerance;
    };
    const auto node = std::find_if(plan_.nodes.begin(), plan_.nodes.end(), isHere);
    return static_cast<std::size_t>(node - plan_.nodes.begin());
  }

  void addLoop(const Loop& loop, EdgeSource source)
  {
    for (std::size_t i = 0; i < loop.size(); ++i)
      addElement(elementOf(loop, i), source, i);
  }

  /** @brief Adds @p element, cut at every node on it. */
  void addElement(const Element& element, EdgeSource source, std::size_t index)
  {
    std::map<double, std::size_t> cuts; // metres along the element -> node
    for (std::size_t node = 0; node < plan_.nodes.size(); ++node)
      if (const auto s = locate(element, plan_.nodes[node], kTolerance))
        cuts[*s] = node;
    // The start and end of a closed arc coincide.
    cuts[0.0] = findNode(element.start);
    cuts[lengthOf(element)] = findNode(element.end);
    for (auto cut = cuts.begin(); std::next(cut) != cuts.end(); ++cut) {
      const auto next = std::next(cut);
      PlanEdge edge;
      edge.element = pieceOf(element, cut->first, next->first);
      edge.start = cut->second;
      edge.end = next->second;
      edge.source = source;
      edge.source_element = index;
      edge.source_offset = cut->first;
      addEdge(edge);
    }
  }

  /** @brief Adds @p edge if it separates two regions and is new. */
  void addEdge(PlanEdge edge)
  {
    if (edge.start == edge.end || isKnown(edge))
      return;
    const double middle = 0.5 * lengthOf(edge.element);
    const Vec2 point = pointAt(edge.element, middle);
    const Vec2 aside = kSideProbe * rightNormalAt(edge.element, middle);
    edge.floor = sidesAt(point, aside, Layer::Floor);
    edge.ceiling = sidesAt(point, aside, Layer::Ceiling);
    if (edge.floor.left != edge.floor.right || edge.ceiling.left != edge.ceiling.right)
      plan_.edges.push_back(edge);
  }

  Sides sidesAt(Vec2 point, Vec2 aside, Layer layer) const
  {
    return {regionAt(room_, point - aside, layer),
            regionAt(room_, point + aside, layer)};
  }

  bool isKnown(const PlanEdge& edge) const
  {
    const Vec2 middle = pointAt(edge.element, 0.5 * lengthOf(edge.element));
    return std::any_of(
        plan_.edges.begin(), plan_.edges.end(), [&](const PlanEdge& other) {
          const bool same = other.start == edge.start && other.end == edge.end;
          const bool reverse = other.start == edge.end && other.end == edge.start;
          return (same || reverse) && locate(other.element, middle, kTolerance);
        });
  }

  const Room& room_;
  Subdivision plan_;
};

[[noreturn]] void
throwAt(Vec2 point, const char* reason)
{
  std::ostringstream text;
  text << reason << " at (" << point.x << ", " << point.y << ")";
  throw std::invalid_argument(text.str());
}

std::size_t
firstNode(const Subdivision& plan, DirectedEdge walk)
{
  const PlanEdge& edge = plan.edges[walk.edge];
  return walk.forward ? edge.start : edge.end;
}

std::size_t
lastNode(const Subdivision& plan, DirectedEdge walk)
{
  return firstNode(plan, {walk.edge, !walk.forward});
}

/** @brief Returns the boundary edge that leaves each node, members to its left. */
std::map<std::size_t, DirectedEdge>
leavingEdges(const Subdivision& plan, Layer layer, const std::vector<bool>& member)
{
  std::map<std::size_t, DirectedEdge> leaving;
  for (std::size_t i = 0; i < plan.edges.size(); ++i) {
    const Sides& sides = plan.edges[i].sides(layer);
    const bool left = member[sides.left + 1];
    if (left == member[sides.right + 1])
      continue;
    const DirectedEdge walk{i, left};
    const std::size_t node = firstNode(plan, walk);
    if (!leaving.emplace(node, walk).second)
      throwAt(plan.nodes[node],
              "Regions of a floor or ceiling touch in a single point");
  }
  return leaving;
}

/** @brief Returns the face of a wall or column, from floor to ceiling. */
VerticalFace
wallFaceOf(const Room& room, const PlanEdge& edge)
{
  const bool room_is_left = edge.ceiling.right == kVoid;
  const auto slab = [&](Layer layer) {
    const Sides& sides = edge.sides(layer);
    return slabOf(room, room_is_left ? sides.left : sides.right, layer);
  };
  return {slab(Layer::Floor), slab(Layer::Ceiling), room_is_left,
          edge.source == EdgeSource::Column ? Label::Column : Label::Wall};
}

/** @brief Returns minimum and maximum of @p a's height above @p b along the element. */
std::pair<double, double>
differenceAlong(const Element& element, const Slab& a, const Slab& b)
{
  constexpr int steps = 16;
  const double end = lengthOf(element);
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (int i = 0; i <= steps; ++i) {
    const Vec2 point = pointAt(element, end * i / steps);
    const double difference = heightAt(a, point) - heightAt(b, point);
    least = std::min(least, difference);
    most = std::max(most, difference);
  }
  return {least, most};
}

/** @brief Returns the riser between two parts of the floor or ceiling, if any. */
std::optional<VerticalFace>
riserOf(const Room& room, const PlanEdge& edge, Layer layer)
{
  const Sides& sides = edge.sides(layer);
  const Slab& left = slabOf(room, sides.left, layer);
  const Slab& right = slabOf(room, sides.right, layer);
  const auto [least, most] = differenceAlong(edge.element, left, right);
  if (least > -kSameHeight && most < kSameHeight)
    return std::nullopt;
  if (least < -kSameHeight && most > kSameHeight)
    throwAt(edge.element.start, "Two parts of a floor or ceiling cross beside a riser");
  const bool left_is_higher = most >= kSameHeight;
  const bool room_is_left = left_is_higher == (layer == Layer::Ceiling);
  return VerticalFace{left_is_higher ? right : left, left_is_higher ? left : right,
                      room_is_left, Label::Detail};
}

} // namespace

std::vector<VerticalFace>
verticalFacesOf(const Room& room, const PlanEdge& edge)
{
  if (edge.ceiling.left == kVoid || edge.ceiling.right == kVoid)
    return {wallFaceOf(room, edge)};
  std::vector<VerticalFace> faces;
  for (const Layer layer : {Layer::Ceiling, Layer::Floor})
    if (auto riser = riserOf(room, edge, layer))
      faces.push_back(*riser);
  return faces;
}

Subdivision
subdivide(const Room& room)
{
  return Subdivider(room).run();
}

std::vector<Cycle>
boundariesOf(const Subdivision& subdivision,
             Layer layer,
             const std::vector<bool>& member)
{
  auto leaving = leavingEdges(subdivision, layer, member);
  std::vector<Cycle> cycles;
  while (!leaving.empty()) {
    const std::size_t first = leaving.begin()->first;
    std::size_t node = first;
    Cycle cycle;
    do {
      const auto next = leaving.find(node);
      if (next == leaving.end())
        throwAt(subdivision.nodes[node], "Outlines of a room cross");
      cycle.push_back(next->second);
      node = lastNode(subdivision, next->second);
      leaving.erase(next);
    } while (node != first);
    cycles.push_back(std::move(cycle));
  }
  return cycles;
}

} // namespace pcl::sedr::sim
