// SPDX-License-Identifier: BSD-3-Clause
#include "ceiling_lines.h"

#include "ceiling_meeting.h"

#include "../formats/decimal_text.h"
#include "../solid/plan_subdivision.h"
#include "line_pieces.h"

#include "sedr_filters/src/grids/disjoint_sets.h"
#include "sedr_filters/src/plan/room_lookup.h"
#include <pcl/sedr_surface/room_solid.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace pcl::sedr {
namespace {

constexpr double min_width = 2; ///< of a part between two lines, millimetres
constexpr double min_area = 25; ///< of a part, square millimetres
constexpr double min_end = 30;  ///< of a line that leads nowhere, millimetres
constexpr double max_end = 1;   ///< which is no more than this, metres
constexpr double straight = 1;  ///< distance of corners that are one, millimetres

/** @brief Finds the lines of a room's ceiling. */
class LineFinder {
public:
  LineFinder(const PlanRoom& room, double finest)
      : room_(room)
      , finest_(finest)
      , layers_(room)
      , parts_(layers_.slabs.size())
  {
    std::vector<std::string> warnings;
    if (!subdivideRoom(layers_, {}, plan_, warnings).empty())
      plan_ = {}; // its solid says why
    for (const SubdivisionEdge& edge : plan_.edges)
      edges_.push_back(borderOf(edge));
  }

  CeilingLines find()
  {
    joinWhereUnseen();
    joinSmallParts();
    while (dropShortEnds()) {
    }
    lookFromAfar();
    CeilingLines found;
    for (const std::vector<std::size_t>& line : lines())
      addPieces(line, found.lines);
    for (std::size_t d = 0; d <= room_.details.size(); ++d)
      found.part.push_back(parts_.find(ceiling_slab + d));
    return found;
  }

private:
  static constexpr std::size_t ceiling_slab = 1; ///< its details follow

  /** @brief An edge of the subdivision as a border of two facets. */
  struct Border {
    bool is_drawn = false; ///< so far; never for what is no border of facets
    bool is_of_facets = false;
    Meeting meeting;
    double length = 0;
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    Eigen::Vector2d normal = Eigen::Vector2d::Zero(); ///< to the left
  };

  double roughnessAt(const SubdivisionEdge& edge) const
  {
    return std::hypot(slab(edge.left.ceiling).residual,
                      slab(edge.right.ceiling).residual);
  }

  const PlanSlab& slab(int k) const
  {
    return layers_.slabs[static_cast<std::size_t>(k)].slab;
  }

  bool isFacet(const PlanRegion& region) const
  {
    return region.isRoom() && !layers_.isNiche(region) &&
           layers_.slabs[static_cast<std::size_t>(region.ceiling)].is_facet;
  }

  Border borderOf(const SubdivisionEdge& edge) const
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

  /** @brief Looks at the lines that are left from where the parts are that a drawing
   * shows: a strip between two vaults is a valley. */
  void lookFromAfar()
  {
    const RoomLookup lookup(room_);
    const double away = std::max(min_width * finest_, beside_border);
    const auto heights = [&](const Border& border, int k, double side) {
      const Eigen::Vector2d p = border.middle + side * away * border.normal;
      return Eigen::Vector2d(slab(k).heightAt(border.middle),
                             lookup.contains(p) ? lookup.ceilingAt(p)
                                                : slab(k).heightAt(p));
    };
    for (std::size_t e = 0; e < edges_.size(); ++e)
      if (edges_[e].is_drawn)
        edges_[e].meeting =
            meetingOf(heights(edges_[e], plan_.edges[e].left.ceiling, 1),
                      heights(edges_[e], plan_.edges[e].right.ceiling, -1), away,
                      roughnessAt(plan_.edges[e]));
  }

  /** @brief Decides border by border, not edge by edge, what is seen. */
  void joinWhereUnseen()
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

  /** @brief Returns the share of a line's length at which something holds. */
  template <typename Holds>
  double share(const std::vector<std::size_t>& line, Holds holds) const
  {
    double part = 0;
    double length = 0;
    for (const std::size_t e : line) {
      length += edges_[e].length;
      part += holds(edges_[e].meeting) ? edges_[e].length : 0;
    }
    return length > 0 ? part / length : 0;
  }

  std::size_t partOf(std::size_t e, bool is_left) const
  {
    const SubdivisionEdge& edge = plan_.edges[e];
    return parts_.find(
        static_cast<std::size_t>(is_left ? edge.left.ceiling : edge.right.ceiling));
  }

  /** @brief A part between lines, and what it has in common with others. */
  struct Part {
    double area = 0;
    double perimeter = 0;
    std::map<std::size_t, double> beside;
  };

  std::map<std::size_t, Part> partsBetween() const
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

  void joinSmallParts()
  {
    while (true) {
      const std::map<std::size_t, Part> parts = partsBetween();
      auto smallest = parts.end();
      for (auto p = parts.begin(); p != parts.end(); ++p)
        if (!p->second.beside.empty() &&
            (p->second.area < min_area * finest_ * finest_ ||
             2 * p->second.area < min_width * finest_ * p->second.perimeter) &&
            (smallest == parts.end() || p->second.area < smallest->second.area))
          smallest = p;
      if (smallest == parts.end())
        return;
      const auto& beside = smallest->second.beside;
      const auto heir = std::max_element(
          beside.begin(), beside.end(),
          [](const auto& a, const auto& b) { return a.second < b.second; });
      for (std::size_t e = 0; e < edges_.size(); ++e)
        if (edges_[e].is_drawn && std::minmax(partOf(e, true), partOf(e, false)) ==
                                      std::minmax(smallest->first, heir->first))
          edges_[e].is_drawn = false;
      parts_.join(smallest->first, heir->first);
    }
  }

  /** @brief Takes away lines that end within a part soon after they began. */
  bool dropShortEnds()
  {
    bool is_changed = false;
    const std::vector<int> ends = endsAt();
    for (const std::vector<std::size_t>& line : lines()) {
      double length = 0;
      bool is_loose = false;
      for (const std::size_t e : line) {
        length += edges_[e].length;
        is_loose =
            is_loose || ends[plan_.edges[e].a] == 1 || ends[plan_.edges[e].b] == 1;
      }
      if (!is_loose || length >= std::min(min_end * finest_, max_end))
        continue;
      for (const std::size_t e : line)
        edges_[e].is_drawn = false;
      is_changed = true;
    }
    return is_changed;
  }

  /** @brief Returns how many lines end at each vertex; far more than two where a wall,
   * a column or the edge of a detail passes. */
  std::vector<int> endsAt() const
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

  /** @brief Returns the lines that are drawn, as edges one after the other: from end
   * to end, or closed. They end where others do and where `kind` of the edges changes.
   */
  template <typename Kind>
  std::vector<std::vector<std::size_t>> linesOf(Kind kind) const
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

  std::vector<std::vector<std::size_t>> lines() const
  {
    return linesOf([&](std::size_t e) { return arcAt(e); });
  }

  /** @brief Returns the arc that an edge is a chord of, or null. */
  const PlanElement* arcAt(std::size_t e) const
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

  void addPieces(const std::vector<std::size_t>& line, std::vector<CeilingLine>& found)
  {
    const SubdivisionEdge& first = plan_.edges[line.front()];
    const auto isAt = [&](std::uint32_t v, std::size_t e) {
      return plan_.edges[e].a == v || plan_.edges[e].b == v;
    };
    std::uint32_t at =
        line.size() > 1 && isAt(first.a, line[1]) && !isAt(first.b, line[1]) ? first.b
                                                                             : first.a;
    std::vector<Eigen::Vector2d> places{plan_.placeOf(at)};
    for (const std::size_t e : line) {
      at = plan_.edges[e].a == at ? plan_.edges[e].b : plan_.edges[e].a;
      places.push_back(plan_.placeOf(at));
    }
    const bool is_crease =
        share(line, [](const Meeting& m) { return m.is_crease; }) >= 0.5;
    if (const PlanElement* arc = arcAt(line.front())) {
      const bool is_whole = (places.front() - places.back()).norm() < 1e-6;
      found.push_back({is_whole ? *arc
                                : partPassing(*arc, places.front(), places.back(),
                                              edges_[line[line.size() / 2]].middle),
                       is_crease,
                       {}});
      return;
    }
    const std::size_t begin = found.size();
    for (const PlanElement& piece : piecesOf(places, straight * finest_))
      found.push_back({piece, is_crease, {}});
    const auto longest =
        std::max_element(found.begin() + static_cast<std::ptrdiff_t>(begin),
                         found.end(), [](const CeilingLine& a, const CeilingLine& b) {
                           return a.element.length() < b.element.length();
                         });
    if (is_crease)
      longest->text = textOf(line, longest->element);
  }

  std::string textOf(const std::vector<std::size_t>& line,
                     const PlanElement& piece) const
  {
    constexpr double level = 0.05; // maximum height difference along a level line
    const Eigen::Vector2d middle = (piece.start + piece.end) / 2;
    const auto offOf = [&](std::size_t e) {
      return (edges_[e].middle - middle).norm();
    };
    const std::size_t nearest =
        *std::min_element(line.begin(), line.end(), [&](std::size_t a, std::size_t b) {
          return offOf(a) < offOf(b);
        });
    const PlanSlab& ceiling = slab(plan_.edges[nearest].left.ceiling);
    if (!edges_[nearest].meeting.is_crease ||
        std::abs(ceiling.heightAt(piece.start) - ceiling.heightAt(piece.end)) >= level)
      return "";
    return (edges_[nearest].meeting.is_ridge ? "ridge " : "valley ") +
           decimalText(ceiling.heightAt(middle) - room_.floorAt(middle), 2);
  }

  const PlanRoom& room_;
  double finest_;
  RoomLayers layers_;
  PlanSubdivision plan_;
  std::vector<Border> edges_;               ///< as in the subdivision
  mutable DisjointSets<std::size_t> parts_; ///< of slabs; finding shortens its paths
};

} // namespace

CeilingLines
ceilingLines(const PlanRoom& room, double finest)
{
  if (room.hasFacets())
    return LineFinder(room, finest).find();
  CeilingLines none;
  none.part.resize(room.details.size() + 1);
  std::iota(none.part.begin(), none.part.end(), std::size_t{0});
  return none;
}

} // namespace pcl::sedr
