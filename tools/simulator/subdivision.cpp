// SPDX-License-Identifier: BSD-3-Clause
#include "subdivision.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace pcl::sedr::sim {

namespace {

constexpr double kTolerance = 1e-6; ///< points closer than this are one node
constexpr double kSideProbe = 1e-5; ///< how far beside an edge its regions are asked

/** @brief Edges between all loops of a room. */
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
    for (const CeilingDetail& detail : room_.details)
      addLoop(detail.loop, EdgeSource::Detail);
    return std::move(plan_);
  }

private:
  void collectNodes()
  {
    addNodes(room_.outline);
    for (const Loop& column : room_.columns)
      addNodes(column);
    for (const CeilingDetail& detail : room_.details)
      addNodes(detail.loop);
  }

  void addNodes(const Loop& loop)
  {
    for (const LoopVertex& vertex : loop)
      if (findNode(vertex.position) == plan_.nodes.size())
        plan_.nodes.push_back(vertex.position);
  }

  std::size_t findNode(Vec2 point) const
  {
    std::size_t i = 0;
    while (i < plan_.nodes.size() && length(plan_.nodes[i] - point) > kTolerance)
      ++i;
    return i;
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
    // A closed arc would meet its start again at its end.
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

  /** @brief Adds @p edge if it separates two regions and is not there yet. */
  void addEdge(PlanEdge edge)
  {
    if (edge.start == edge.end || isKnown(edge))
      return;
    const double middle = 0.5 * lengthOf(edge.element);
    const Vec2 point = pointAt(edge.element, middle);
    const Vec2 aside = kSideProbe * rightNormalAt(edge.element, middle);
    edge.left = regionAt(room_, point - aside);
    edge.right = regionAt(room_, point + aside);
    if (edge.left != edge.right)
      plan_.edges.push_back(edge);
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

/** @brief The boundary edges that leave each node, members to the left. */
std::map<std::size_t, DirectedEdge>
leavingEdges(const Subdivision& plan, const std::vector<bool>& member)
{
  std::map<std::size_t, DirectedEdge> leaving;
  for (std::size_t i = 0; i < plan.edges.size(); ++i) {
    const PlanEdge& edge = plan.edges[i];
    const bool left = member[edge.left + 1];
    if (left == member[edge.right + 1])
      continue;
    const DirectedEdge walk{i, left};
    const std::size_t node = firstNode(plan, walk);
    if (!leaving.emplace(node, walk).second)
      throwAt(plan.nodes[node], "Regions of a ceiling touch in a single point");
  }
  return leaving;
}

} // namespace

Region
regionAt(const Room& room, Vec2 point)
{
  if (!contains(room.outline, point))
    return kVoid;
  for (const Loop& column : room.columns)
    if (contains(column, point))
      return kVoid;
  for (std::size_t i = room.details.size(); i > 0; --i)
    if (contains(room.details[i - 1].loop, point))
      return static_cast<Region>(i);
  return kMain;
}

double
ceilingHeight(const Room& room, Region region)
{
  return region == kMain ? room.ceiling.height : room.details[region - 1].slab.height;
}

VerticalFace
verticalFaceOf(const Room& room, const PlanEdge& edge)
{
  const auto top = [&room](Region region) {
    return region == kVoid ? room.floor.height : ceilingHeight(room, region);
  };
  const double left = top(edge.left);
  const double right = top(edge.right);
  VerticalFace face{std::min(left, right), std::max(left, right), left > right};
  if (edge.left != kVoid && edge.right != kVoid)
    face.label = Label::Detail;
  else if (edge.source == EdgeSource::Column)
    face.label = Label::Column;
  return face;
}

Subdivision
subdivide(const Room& room)
{
  return Subdivider(room).run();
}

std::vector<Cycle>
boundariesOf(const Subdivision& subdivision, const std::vector<bool>& member)
{
  auto leaving = leavingEdges(subdivision, member);
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
