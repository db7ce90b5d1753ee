// SPDX-License-Identifier: BSD-3-Clause
#include "ceiling_borders.h"

#include "line_pieces.h"

#include "sedr_filters/src/plan/room_lookup.h"
#include <pcl/sedr_surface/room_solid.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace pcl::sedr {
namespace {

constexpr double min_width = 2; ///< of a part between two lines, millimetres
constexpr double min_end = 30;  ///< of a line that leads nowhere, millimetres
constexpr double max_end = 1;   ///< which is no more than this, metres

} // namespace

CeilingBorders::CeilingBorders(const PlanRoom& room, double finest)
    : room_(room)
    , finest_(finest)
    , layers_(room)
    , shown_(room.details.size() + 1)
    , parts_(layers_.slabs.size())
{
  std::iota(shown_.begin(), shown_.end(), -1);
  std::vector<std::string> warnings;
  if (!subdivideRoom(layers_, {}, plan_, warnings).empty())
    plan_ = {}; // its solid says why
  for (const SubdivisionEdge& edge : plan_.edges)
    edges_.push_back(borderOf(edge));
  joinWhereUnseen();
  joinSmallParts();
  while (dropShortEnds()) {
  }
  lookFromAfar();
  findSteps();
  moveVertices();
}

double
CeilingBorders::roughnessAt(const SubdivisionEdge& edge) const
{
  return std::hypot(slab(edge.left.ceiling).residual,
                    slab(edge.right.ceiling).residual);
}

bool
CeilingBorders::isFacet(const PlanRegion& region) const
{
  return region.isRoom() && !layers_.isNiche(region) &&
         layers_.slabs[static_cast<std::size_t>(region.ceiling)].is_facet;
}

CeilingBorders::Border
CeilingBorders::borderOf(const SubdivisionEdge& edge) const
{
  Border border;
  const Eigen::Vector2d from = plan_.placeOf(edge.a);
  const Eigen::Vector2d way = plan_.placeOf(edge.b) - from;
  border.length = way.norm();
  border.is_of_facets = isFacet(edge.left) && isFacet(edge.right) &&
                        edge.left.ceiling != edge.right.ceiling;
  border.is_drawn = border.is_of_facets;
  border.middle = from + way / 2;
  border.normal = Eigen::Vector2d(-way.y(), way.x()) / std::max(border.length, 1e-9);
  if (!border.is_of_facets)
    return border;
  const auto heights = [&](int k, double side) {
    return Eigen::Vector2d(
        slab(k).heightAt(border.middle),
        slab(k).heightAt(border.middle + side * beside_border * border.normal));
  };
  border.meeting =
      meetingOf(heights(edge.left.ceiling, 1), heights(edge.right.ceiling, -1),
                beside_border, roughnessAt(edge));
  return border;
}

std::vector<int>
CeilingBorders::endsAt() const
{
  constexpr int many = 8;
  std::vector<int> ends(plan_.vertices.size(), 0);
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const bool is_other = !edges_[e].is_of_facets &&
                          plan_.edges[e].left.ceiling != plan_.edges[e].right.ceiling;
    for (const std::uint32_t v : {plan_.edges[e].a, plan_.edges[e].b})
      ends[v] += is_other ? many : edges_[e].is_drawn ? 1 : 0;
  }
  return ends;
}

template <typename Kind>
std::vector<std::vector<std::size_t>>
CeilingBorders::linesOf(Kind kind) const
{
  std::vector<std::vector<std::size_t>> at(plan_.vertices.size());
  for (std::size_t e = 0; e < edges_.size(); ++e)
    if (edges_[e].is_drawn)
      for (const std::uint32_t v : {plan_.edges[e].a, plan_.edges[e].b})
        at[v].push_back(e);
  const std::vector<int> ends = endsAt();
  std::vector<bool> is_used(edges_.size(), false);
  const auto goesOn = [&](std::uint32_t v) {
    return ends[v] == 2 && at[v].size() == 2 && kind(at[v][0]) == kind(at[v][1]);
  };
  std::vector<std::vector<std::size_t>> found;
  const auto follow = [&](std::size_t e, std::uint32_t v) {
    std::vector<std::size_t> line;
    while (!is_used[e]) {
      is_used[e] = true;
      line.push_back(e);
      v = plan_.edges[e].a == v ? plan_.edges[e].b : plan_.edges[e].a;
      if (!goesOn(v))
        break;
      e = at[v][0] == e ? at[v][1] : at[v][0];
    }
    found.push_back(line);
  };
  for (const bool is_closed : {false, true})
    for (std::size_t e = 0; e < edges_.size(); ++e)
      for (const std::uint32_t v : {plan_.edges[e].a, plan_.edges[e].b})
        if (edges_[e].is_drawn && !is_used[e] && (is_closed || !goesOn(v)))
          follow(e, v);
  return found;
}

std::vector<std::vector<std::size_t>>
CeilingBorders::lines() const
{
  return linesOf([&](std::size_t e) { return arcAt(e); });
}

const PlanElement*
CeilingBorders::arcAt(std::size_t e) const
{
  for (const std::size_t element : plan_.edges[e].elements)
    for (const RoomLayers::Loop& loop : layers_.loops) {
      const std::size_t k = element - loop.first_element; // wraps around if before
      if (element >= loop.first_element && k < loop.loop->elements.size() &&
          loop.loop->elements[k].isArc())
        return &loop.loop->elements[k];
    }
  return nullptr;
}

std::vector<Eigen::Vector2d>
CeilingBorders::placesOf(const std::vector<std::size_t>& line) const
{
  const SubdivisionEdge& first = plan_.edges[line.front()];
  const auto isAt = [&](std::uint32_t v, std::size_t e) {
    return plan_.edges[e].a == v || plan_.edges[e].b == v;
  };
  std::uint32_t at =
      line.size() > 1 && isAt(first.a, line[1]) && !isAt(first.b, line[1]) ? first.b
                                                                           : first.a;
  std::vector<Eigen::Vector2d> places{places_[at]};
  for (const std::size_t e : line) {
    at = plan_.edges[e].a == at ? plan_.edges[e].b : plan_.edges[e].a;
    places.push_back(places_[at]);
  }
  return places;
}

void
CeilingBorders::lookFromAfar()
{
  const RoomLookup lookup(room_);
  const double away = std::max(min_width * finest_, beside_border);
  const auto heights = [&](const Border& border, int k, double side) {
    const Eigen::Vector2d p = border.middle + side * away * border.normal;
    return Eigen::Vector2d(slab(k).heightAt(border.middle), lookup.contains(p)
                                                                ? lookup.ceilingAt(p)
                                                                : slab(k).heightAt(p));
  };
  for (std::size_t e = 0; e < edges_.size(); ++e)
    if (edges_[e].is_drawn)
      edges_[e].meeting =
          meetingOf(heights(edges_[e], plan_.edges[e].left.ceiling, 1),
                    heights(edges_[e], plan_.edges[e].right.ceiling, -1), away,
                    roughnessAt(plan_.edges[e]));
}

void
CeilingBorders::joinWhereUnseen()
{
  for (const std::vector<std::size_t>& line : linesOf([&](std::size_t e) {
         const auto [a, b] =
             std::minmax(plan_.edges[e].left.ceiling, plan_.edges[e].right.ceiling);
         return std::make_pair(a, b);
       })) {
    if (share(line, [](const Meeting& m) { return m.is_seen; }) >= 0.5)
      continue;
    for (const std::size_t e : line)
      edges_[e].is_drawn = false;
    parts_.join(partOf(line.front(), true), partOf(line.front(), false));
  }
}

std::size_t
CeilingBorders::partOf(std::size_t e, bool is_left) const
{
  const SubdivisionEdge& edge = plan_.edges[e];
  return parts_.find(
      static_cast<std::size_t>(is_left ? edge.left.ceiling : edge.right.ceiling));
}

std::map<std::size_t, CeilingBorders::Part>
CeilingBorders::partsBetween() const
{
  std::map<std::size_t, Part> parts;
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const SubdivisionEdge& edge = plan_.edges[e];
    const Eigen::Vector2d a = plan_.placeOf(edge.a);
    const Eigen::Vector2d b = plan_.placeOf(edge.b);
    const double under = (a.x() * b.y() - a.y() * b.x()) / 2;
    const bool is_inside = edges_[e].is_of_facets && !edges_[e].is_drawn;
    for (const bool is_left : {true, false}) {
      if (!isFacet(is_left ? edge.left : edge.right))
        continue;
      Part& part = parts[partOf(e, is_left)];
      part.area += is_left ? under : -under;
      part.perimeter += is_inside ? 0 : edges_[e].length;
      if (edges_[e].is_drawn && partOf(e, true) != partOf(e, false))
        part.beside[partOf(e, !is_left)] += edges_[e].length;
    }
  }
  return parts;
}

void
CeilingBorders::joinSmallParts()
{
  const auto isSmall = [&](const Part& part) {
    return part.area < min_part_area * finest_ * finest_ ||
           2 * part.area < min_width * finest_ * part.perimeter;
  };
  while (true) {
    const std::map<std::size_t, Part> parts = partsBetween();
    auto smallest = parts.end();
    for (auto p = parts.begin(); p != parts.end(); ++p)
      if (!p->second.beside.empty() && isSmall(p->second) &&
          (smallest == parts.end() || p->second.area < smallest->second.area))
        smallest = p;
    if (smallest == parts.end())
      return;
    const auto& beside = smallest->second.beside;
    join(smallest->first, std::max_element(beside.begin(), beside.end(),
                                           [](const auto& a, const auto& b) {
                                             return a.second < b.second;
                                           })
                              ->first);
  }
}

void
CeilingBorders::join(std::size_t small, std::size_t neighbour)
{
  std::map<int, double> in_common; // with the facets of the neighbour
  for (std::size_t e = 0; e < edges_.size(); ++e)
    for (const bool is_left : {true, false})
      if (edges_[e].is_drawn && partOf(e, is_left) == small &&
          partOf(e, !is_left) == neighbour) {
        edges_[e].is_drawn = false;
        in_common[shownOn(e, !is_left)] += edges_[e].length;
      }
  const int facet =
      std::max_element(in_common.begin(), in_common.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; })
          ->first;
  for (std::size_t k = 0; k < shown_.size(); ++k)
    if (parts_.find(ceiling_slab + k) == small)
      shown_[k] = facet;
  parts_.join(small, neighbour);
}

bool
CeilingBorders::dropShortEnds()
{
  bool is_changed = false;
  const std::vector<int> ends = endsAt();
  for (const std::vector<std::size_t>& line : lines()) {
    double length = 0;
    bool is_loose = false;
    for (const std::size_t e : line) {
      length += edges_[e].length;
      is_loose = is_loose || ends[plan_.edges[e].a] == 1 || ends[plan_.edges[e].b] == 1;
    }
    if (!is_loose || length >= std::min(min_end * finest_, max_end))
      continue;
    for (const std::size_t e : line)
      edges_[e].is_drawn = false;
    is_changed = true;
  }
  return is_changed;
}

void
CeilingBorders::findSteps()
{
  for (const std::vector<std::size_t>& line : lines()) {
    const bool is_step = share(line, [](const Meeting& m) { return m.is_step; }) >= 0.5;
    for (const std::size_t e : line)
      edges_[e].is_step = is_step;
  }
}

void
CeilingBorders::moveVertices()
{
  std::vector<std::vector<Limit>> limits(plan_.vertices.size());
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const SubdivisionEdge& edge = plan_.edges[e];
    if (edges_[e].is_of_facets ? !edges_[e].is_drawn
                               : edge.left.ceiling == edge.right.ceiling)
      continue;
    for (const std::uint32_t v : {edge.a, edge.b})
      limits[v].push_back(limitOf(e));
  }
  for (std::uint32_t v = 0; v < limits.size(); ++v)
    places_.push_back(placeOfMeeting(limits[v], plan_.placeOf(v)));
}

Limit
CeilingBorders::limitOf(std::size_t e) const
{
  const bool do_meet = edges_[e].is_drawn && !edges_[e].is_step && !arcAt(e);
  return {edges_[e].normal, do_meet ? &slabOn(e, true) : nullptr,
          do_meet ? &slabOn(e, false) : nullptr};
}

CeilingLines::Borders
CeilingBorders::borders() const
{
  CeilingLines::Borders found;
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    if (!edges_[e].is_of_facets)
      continue;
    PlanElement border;
    border.start = plan_.placeOf(plan_.edges[e].a);
    border.end = plan_.placeOf(plan_.edges[e].b);
    found[std::minmax({shownOn(e, true), shownOn(e, false)})].emplace_back(
        border, edges_[e].is_drawn && edges_[e].is_step);
  }
  return found;
}

std::vector<std::size_t>
CeilingBorders::parts() const
{
  std::vector<std::size_t> found;
  for (std::size_t d = 0; d <= room_.details.size(); ++d)
    found.push_back(parts_.find(ceiling_slab + d));
  return found;
}

} // namespace pcl::sedr
