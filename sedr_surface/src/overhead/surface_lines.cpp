// SPDX-License-Identifier: BSD-3-Clause
#include "room_faces.h"

#include "sedr_filters/src/base/number_text.h"

#include "sedr_filters/src/grids/disjoint_sets.h"
#include "sedr_filters/src/plan/plan_geometry.h"
#include "sedr_filters/src/plan/room_lookup.h"
#include "sedr_segmentation/src/curves/contour.h"

#include <map>
#include <set>
#include <tuple>

namespace pcl::sedr {
namespace {

constexpr double min_step = 0.03; ///< metres
constexpr double beside = 0.05;   ///< where facets are asked for, metres
constexpr double shortest = 8;    ///< line, millimetres of paper
constexpr int outside = -2;       ///< of the room

/** @brief What lies to the left and to the right of a place of a line: details, -1 for
 * the main slab; and whether they differ there. */
struct Sides {
  int left = outside;
  int right = outside;
  bool differ = false;
  bool is_crease = false; ///< they meet there

  auto key() const { return std::tie(left, right, differ, is_crease); }
  bool operator==(const Sides& o) const { return key() == o.key(); }
};

/** @brief The border of two details. */
struct Border {
  Sides sides;
  double length = 0;
  double different = 0; ///< length along which both sides differ
  double crease = 0;    ///< length along which they meet
  std::vector<PlanElement> arcs{};
  std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> segments{};

  bool isCrease() const { return 2 * crease > length; }
};

/** @brief Finds the lines of a room's ceiling or floor. */
class LineFinder {
public:
  LineFinder(const PlanRoom& room, SurfaceSide side, double finest)
      : room_(room)
      , is_floor_(side == SurfaceSide::Floor)
      , details_(is_floor_ ? room.floor_details : room.details)
      , lookup_(room)
      , finest_(finest)
  {}

  SurfaceLines find()
  {
    for (std::size_t d = 0; d < details_.size(); ++d) {
      addLoop(d, details_[d].boundary);
      for (const PlanLoop& hole : details_[d].holes)
        addLoop(d, hole);
    }
    findParts();
    for (const auto& [sides, border] : borders_) {
      if (partOf(sides.first) == partOf(sides.second))
        continue;
      for (const PlanElement& arc : border.arcs)
        add({{arc}}, border);
      for (const auto& line : chained(border.segments))
        addLine(border, line);
    }
    for (std::size_t& part : found_.part) // what has no line
      part = drawn_.count(part) > 0 ? part : found_.part[0];
    return std::move(found_);
  }

private:
  const PlanSlab& slab(int detail) const
  {
    return is_floor_ ? room_.floorSlab(detail) : room_.ceilingSlab(detail);
  }

  int detailAt(const Eigen::Vector2d& p) const
  {
    return is_floor_ ? lookup_.floorDetailAt(p) : lookup_.detailAt(p);
  }

  /** @brief Returns what is beside an edge of a detail that is seen. */
  Sides sidesOf(std::size_t detail, const PlanElement& edge, double s) const
  {
    const Eigen::Vector2d place = edge.pointAt(s);
    const Eigen::Vector2d off = beside * edge.normalAt(s);
    if (!lookup_.contains(place + off) || !lookup_.contains(place - off))
      return {};
    Sides sides{detailAt(place + off), detailAt(place - off)};
    if (sides.left == sides.right ||
        std::max(sides.left, sides.right) != static_cast<int>(detail))
      return {};
    const PlanSlab& a = slab(sides.left);
    const PlanSlab& b = slab(sides.right);
    const double step = std::abs(a.heightAt(place) - b.heightAt(place));
    const Eigen::Vector3d up = a.normalAt(place);
    const Eigen::Vector3d other = b.normalAt(place);
    const double angle = std::acos(std::clamp(up.dot(other), -1.0, 1.0));
    const double min_angle = is_floor_ ? M_PI / 90 : M_PI / 30; // 2 and 6 degrees
    sides.differ = step > min_step || angle > min_angle;
    sides.is_crease = angle > min_angle && step < min_step;
    return sides;
  }

  void addLoop(std::size_t detail, const PlanLoop& loop)
  {
    for (const PlanElement& edge : loop.elements) {
      if (!(edge.length() > 0))
        continue;
      const auto sidesAt = [&](double s) { return sidesOf(detail, edge, s); };
      forEachPart(edge, sidesAt, [&](const PlanElement& part, const Sides& sides) {
        if (sides.left == outside)
          return;
        Border& border = borders_[std::minmax(sides.left, sides.right)];
        border.sides = sides;
        border.length += part.length();
        border.different += sides.differ ? part.length() : 0;
        border.crease += sides.is_crease ? part.length() : 0;
        if (part.isArc())
          border.arcs.push_back(part);
        else
          border.segments.emplace_back(part.start, part.end);
      });
    }
  }

  void addLine(const Border& border, const std::vector<Eigen::Vector2d>& line)
  {
    const std::vector<Eigen::Vector2d> places =
        simplifiedLine(line, std::max(finest_, beside));
    PlanLoop drawn;
    for (std::size_t k = 0; k + 1 < places.size(); ++k)
      drawn.elements.push_back(segment(places[k], places[k + 1]));
    add(drawn, border);
  }

  /** @brief Adds a line unless it is tiny on paper. Of a crease the longest element has
   * its text. */
  void add(const PlanLoop& line, const Border& border)
  {
    Eigen::AlignedBox2d box = boundsOf(line);
    const PlanElement* longest = nullptr;
    for (const PlanElement& element : line.elements) {
      box.extend(element.end);
      if (!longest || element.length() > longest->length())
        longest = &element;
    }
    if (!longest || box.diagonal().norm() < shortest * finest_)
      return;
    drawn_.insert({partOf(border.sides.left), partOf(border.sides.right)});
    for (const PlanElement& element : line.elements)
      found_.lines.push_back({element, border.isCrease(),
                              border.isCrease() && &element == longest
                                  ? textOf(border.sides, element)
                                  : ""});
  }

  /** @brief Returns the height of a ridge or valley, if it is level. */
  std::string textOf(const Sides& sides, const PlanElement& line) const
  {
    constexpr double level = 0.05; // metres
    constexpr double falls = 0.02; // slope
    const PlanSlab& one = slab(sides.left);
    const Eigen::Vector2d middle = line.pointAt(line.length() / 2);
    const Eigen::Vector2d off = beside * line.normalAt(line.length() / 2);
    if (is_floor_ ||
        std::abs(one.heightAt(line.start) - one.heightAt(line.end)) > level)
      return "";
    const auto rise = [&](const Eigen::Vector2d& to) {
      const PlanSlab& there = slab(detailAt(middle + to));
      return (there.heightAt(middle + to) - there.heightAt(middle)) / beside;
    };
    const double a = rise(off);
    const double b = rise(-off);
    const bool is_ridge = a < -falls && b < -falls;
    const bool is_valley = a > falls && b > falls;
    if (!is_ridge && !is_valley)
      return "";
    return (is_ridge ? "ridge " : "valley ") +
           decimalText(one.heightAt(middle) - room_.floorAt(middle), 2);
  }

  std::size_t partOf(int detail) const
  {
    return found_.part[static_cast<std::size_t>(detail + 1)];
  }

  /** @brief Finds the parts: details that do not differ along most of their border are
   * of one, so that lines between parts end nowhere but at others and at walls. */
  void findParts()
  {
    DisjointSets<std::size_t> sets(details_.size() + 1);
    for (const auto& [sides, border] : borders_)
      if (2 * border.different <= border.length)
        sets.join(static_cast<std::size_t>(sides.first + 1),
                  static_cast<std::size_t>(sides.second + 1));
    for (std::size_t k = 0; k <= details_.size(); ++k)
      found_.part.push_back(sets.find(k));
  }

  const PlanRoom& room_;
  bool is_floor_;
  const std::vector<PlanDetail>& details_;
  RoomLookup lookup_;
  double finest_;
  SurfaceLines found_;
  std::map<std::pair<int, int>, Border> borders_; ///< by both details, lower first
  std::set<std::size_t> drawn_;                   ///< parts with a line
};

} // namespace

std::vector<NotedPart>
SurfaceLines::noted(const PlanRoom& room, SurfaceSide side) const
{
  const bool is_floor = side == SurfaceSide::Floor;
  const std::vector<PlanDetail>& details = is_floor ? room.floor_details : room.details;
  std::vector<NotedPart> parts{
      {is_floor ? room.floor : room.ceiling, room.boundary, room.columns}};
  for (const PlanDetail& detail : details)
    parts[0].others.push_back(detail.boundary);
  std::map<std::size_t, std::size_t> largest; // detail, by part
  const auto areaOf = [&](std::size_t d) {
    return std::abs(details[d].boundary.area());
  };
  for (std::size_t d = 0; d < details.size(); ++d)
    if (part[d + 1] != part.front())
      if (const auto [best, is_first] = largest.emplace(part[d + 1], d);
          !is_first && areaOf(d) > areaOf(best->second))
        best->second = d;
  std::set<std::size_t> chosen;
  for (const auto& [of, d] : largest)
    chosen.insert(d);
  for (const std::size_t d : chosen) {
    NotedPart& noted = parts.emplace_back(
        NotedPart{details[d].slab, details[d].boundary, room.columns});
    noted.others.insert(noted.others.end(), details[d].holes.begin(),
                        details[d].holes.end());
    for (std::size_t later = d + 1; later < details.size(); ++later)
      if (boundsOf(details[later].boundary).intersects(boundsOf(noted.outline)))
        noted.others.push_back(details[later].boundary);
  }
  return parts;
}

SurfaceLines
surfaceLines(const PlanRoom& room, SurfaceSide side, double finest)
{
  return LineFinder(room, side, finest).find();
}

} // namespace pcl::sedr
