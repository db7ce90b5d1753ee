// SPDX-License-Identifier: BSD-3-Clause
#include "room_faces.h"

#include "sedr_filters/src/base/number_text.h"
#include "sedr_filters/src/plan/plan_geometry.h"
#include "sedr_filters/src/plan/room_lookup.h"
#include "sedr_segmentation/src/curves/contour.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>

namespace pcl::sedr {

std::vector<std::vector<Eigen::Vector2d>>
chained(const std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>>& segments)
{
  constexpr double same = 1e-4;
  using Place = std::pair<std::int64_t, std::int64_t>;
  const auto placeOf = [](const Eigen::Vector2d& p) {
    return Place(std::llround(p.x() / same), std::llround(p.y() / same));
  };
  std::map<Place, std::vector<std::size_t>> at;
  for (std::size_t k = 0; k < segments.size(); ++k) {
    at[placeOf(segments[k].first)].push_back(k);
    at[placeOf(segments[k].second)].push_back(k);
  }
  std::vector<bool> is_used(segments.size(), false);
  std::vector<std::vector<Eigen::Vector2d>> lines;
  const auto follow = [&](std::size_t k, bool is_forward) {
    std::vector<Eigen::Vector2d> line{is_forward ? segments[k].first
                                                 : segments[k].second};
    while (!is_used[k]) {
      is_used[k] = true;
      line.push_back(is_forward ? segments[k].second : segments[k].first);
      const Place end = placeOf(line.back());
      const std::vector<std::size_t>& beside = at[end];
      if (beside.size() != 2)
        break;
      k = beside[0] == k ? beside[1] : beside[0];
      is_forward = placeOf(segments[k].first) == end;
    }
    lines.push_back(line);
  };
  // Open lines from their ends, then closed ones.
  for (const bool is_closed : {false, true})
    for (std::size_t k = 0; k < segments.size(); ++k)
      for (const bool is_forward : {true, false}) {
        const Eigen::Vector2d& start =
            is_forward ? segments[k].first : segments[k].second;
        if (!is_used[k] && (is_closed || at[placeOf(start)].size() != 2))
          follow(k, is_forward);
      }
  return lines;
}

namespace {

constexpr double beside_wall = 0.03; ///< metres

using Segments = std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>>;

/** @brief Appends where a function of the corners of triangles, linear between them, is
 * zero. */
template <typename Function>
void
addZeros(const TriangleMesh& mesh,
         const std::vector<std::size_t>& triangles,
         Function function,
         Segments& segments)
{
  constexpr double hair = 1e-6; // so near to zero a corner is on the line
  const auto valueOf = [&](const Eigen::Vector3d& p) {
    const double value = function(p);
    return std::abs(value) < hair ? 0 : value;
  };
  for (const std::size_t t : triangles) {
    std::vector<Eigen::Vector2d> crossings;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [i, j] =
          std::minmax(mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]);
      const Eigen::Vector3d& from = mesh.vertices[i];
      const Eigen::Vector3d& to = mesh.vertices[j];
      const double a = valueOf(from);
      const double b = valueOf(to);
      if ((a < 0) != (b < 0))
        crossings.emplace_back((from + a / (a - b) * (to - from)).head<2>());
    }
    if (crossings.size() == 2 && (crossings[0] - crossings[1]).norm() > hair)
      segments.emplace_back(crossings[0], crossings[1]);
  }
}

/** @brief Appends segments as lines, without those that tell nobody anything; the
 * longest element of each has the text. */
void
addLines(const Segments& segments,
         const std::string& text,
         std::vector<SurfaceLine>& lines)
{
  constexpr double tolerance = 0.005;
  constexpr double shortest = 0.5; // metres
  for (const std::vector<Eigen::Vector2d>& line : chained(segments)) {
    Eigen::AlignedBox2d extent;
    for (const Eigen::Vector2d& place : line)
      extent.extend(place);
    if (extent.diagonal().norm() < shortest)
      continue;
    const std::vector<Eigen::Vector2d> places = simplifiedLine(line, tolerance);
    std::size_t longest = lines.size();
    for (std::size_t k = 0; k + 1 < places.size(); ++k) {
      lines.push_back({segment(places[k], places[k + 1])});
      if (lines.back().element.length() > lines[longest].element.length())
        longest = lines.size() - 1;
    }
    lines[longest].text = text;
  }
}

/** @brief Returns the least usual distance of contours of which a range has at most
 * eight. */
double
contourStep(double range)
{
  constexpr double most = 8;
  for (const double step : {0.05, 0.1, 0.25, 0.5})
    if (range <= most * step)
      return step;
  return std::max(1.0, std::ceil(range / most));
}

} // namespace

RoomFaces::RoomFaces(const PlanRoom& of)
    : room(of)
{
  report = extrudeRoom(room, {}, solid, elements);
  const std::size_t start = ("room_" + std::to_string(room.id) + "_").size();
  for (std::size_t t = 0; t < solid.triangles.size(); ++t)
    parts[elements[solid.elements[t] - 1].name.substr(start)].push_back(t);
  faces.push_back(trianglesOf({"ceiling"}));
  for (std::size_t d = 1; d <= room.details.size(); ++d)
    faces.push_back(trianglesOf({"detail_" + std::to_string(d)}));
}

std::vector<std::size_t>
RoomFaces::trianglesOf(const std::vector<std::string>& names) const
{
  std::vector<std::size_t> triangles;
  for (const std::string& name : names)
    if (const auto part = parts.find(name); part != parts.end())
      triangles.insert(triangles.end(), part->second.begin(), part->second.end());
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

double
RoomFaces::area(std::size_t face) const
{
  double area = 0;
  for (const std::size_t t : faces[face])
    area += solid.scaledNormal(t).norm() / 2;
  return area;
}

double
RoomFaces::area() const
{
  double all = 0;
  for (std::size_t face = 0; face < faces.size(); ++face)
    all += area(face);
  return all;
}

std::vector<SurfaceLine>
heightLines(const RoomFaces& ceiling, double height)
{
  const PlanRoom& room = ceiling.room;
  if (!room.hasFacets())
    return {};
  const RoomLookup lookup(room);
  Segments segments;
  // Above each part of the floor, where that is.
  for (int f = -1; f < static_cast<int>(room.floor_details.size()); ++f) {
    const PlanSlab& floor = room.floorSlab(f);
    Segments above;
    for (const std::vector<std::size_t>& face : ceiling.faces)
      addZeros(
          ceiling.solid, face,
          [&](const Eigen::Vector3d& p) {
            return p.z() - floor.heightAt(p.head<2>()) - height;
          },
          above);
    for (const auto& [from, to] : above) {
      const PlanElement line = segment(from, to);
      const auto isAbove = [&](double s) {
        return lookup.floorDetailAt(line.pointAt(s)) == f;
      };
      for (const PlanElement& part : partsWhere(line, isAbove))
        segments.emplace_back(part.start, part.end);
    }
  }
  std::vector<SurfaceLine> lines;
  addLines(segments, "h " + decimalText(height, 2), lines);
  return lines;
}

std::vector<SurfaceLine>
contourLines(const RoomFaces& ceiling)
{
  const PlanSlab& floor = ceiling.room.floor;
  const auto heightOf = [&](const Eigen::Vector3d& p) {
    return p.z() - floor.heightAt(p.head<2>());
  };
  std::vector<std::size_t> curved; // triangles
  for (std::size_t face = 0; face < ceiling.faces.size(); ++face)
    if (ceiling.room.ceilingSlab(static_cast<int>(face) - 1).curve)
      curved.insert(curved.end(), ceiling.faces[face].begin(),
                    ceiling.faces[face].end());
  Eigen::AlignedBox1d range;
  for (const std::size_t t : curved)
    for (const int k : {0, 1, 2})
      range.extend(Eigen::Matrix<double, 1, 1>(heightOf(ceiling.solid.corner(t, k))));
  std::vector<SurfaceLine> lines;
  if (range.isEmpty())
    return lines;
  const double step = contourStep(range.sizes().x());
  for (double k = std::ceil(range.min().x() / step); k * step < range.max().x(); ++k) {
    Segments segments;
    addZeros(
        ceiling.solid, curved,
        [&](const Eigen::Vector3d& p) { return heightOf(p) - k * step; }, segments);
    addLines(segments, decimalText(k * step, 2), lines);
  }
  return lines;
}

std::pair<double, double>
heightRange(const RoomFaces& ceiling)
{
  constexpr double few = 50;
  constexpr double inward = 0.02; // share of the way to the middle of a triangle
  const PlanRoom& room = ceiling.room;
  const RoomLookup lookup(room);
  std::vector<double> areas;
  for (std::size_t face = 0; face < ceiling.faces.size(); ++face)
    areas.push_back(ceiling.area(face));
  const double most = *std::max_element(areas.begin(), areas.end());
  Eigen::AlignedBox1d range;
  // The height of a face at a place over what is below another one, nearby.
  const auto add = [&](std::size_t face, const Eigen::Vector3d& place,
                       const Eigen::Vector2d& inside) {
    if (few * areas[face] >= most)
      range.extend(Eigen::Matrix<double, 1, 1>(
          place.z() -
          room.floorSlab(lookup.floorDetailAt(inside)).heightAt(place.head<2>())));
  };
  for (std::size_t face = 0; face < ceiling.faces.size(); ++face)
    for (const std::size_t t : ceiling.faces[face]) {
      const auto corner = [&](int k) { return ceiling.solid.corner(t, k); };
      const Eigen::Vector3d middle = (corner(0) + corner(1) + corner(2)) / 3;
      for (int k = 0; k < 3; ++k)
        add(face, corner(k), (corner(k) + inward * (middle - corner(k))).head<2>());
    }
  for (const PlanDetail& step : room.floor_details)
    for (const PlanElement& e : step.boundary.elements) {
      const double s = e.length() / 2;
      const Eigen::Vector2d p = e.pointAt(s) + beside_wall * e.normalAt(s);
      if (lookup.contains(p))
        add(static_cast<std::size_t>(lookup.detailAt(p) + 1),
            {p.x(), p.y(), lookup.ceilingAt(p)}, p);
    }
  return range.isEmpty() ? std::pair(0., 0.)
                         : std::pair(range.min().x(), range.max().x());
}

std::string
eavesText(const PlanRoom& room, const PlanElement& wall)
{
  constexpr double level = 0.05; // maximum height difference along eaves
  constexpr double inward = 0.4;
  constexpr double rises = 0.03; // metres, over that distance
  if (!room.hasFacets() || wall.isArc() || wall.length() < 4 * beside_wall)
    return "";
  // Of the slab beside the wall.
  const auto heightAt = [&](double share, double distance) {
    const double s = share * wall.length();
    const Eigen::Vector2d inside = wall.pointAt(s) + beside_wall * wall.normalAt(s);
    return room.ceilingSlab(room.detailAt(inside))
        .heightAt(wall.pointAt(s) + distance * wall.normalAt(s));
  };
  const double middle = heightAt(0.5, 0);
  const auto [low, high] = std::minmax({heightAt(0.05, 0), middle, heightAt(0.95, 0)});
  if (high - low > level || heightAt(0.5, inward) < middle + rises)
    return "";
  const double s = wall.length() / 2;
  return "eaves " + decimalText(middle - room.floorAt(wall.pointAt(s) +
                                                      beside_wall * wall.normalAt(s)),
                                2);
}

} // namespace pcl::sedr
