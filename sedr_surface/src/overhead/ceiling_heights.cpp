// SPDX-License-Identifier: BSD-3-Clause
#include "ceiling_lines.h"

#include "sedr_filters/src/base/number_text.h"

#include "sedr_filters/src/plan/plan_bounds.h"
#include "sedr_filters/src/plan/plan_segment.h"
#include "sedr_filters/src/plan/room_lookup.h"
#include "sedr_segmentation/src/curves/contour.h"

#include <algorithm>
#include <limits>
#include <map>

namespace pcl::sedr {
namespace {

constexpr double usual_spacing = 0.05; ///< of samples, metres
constexpr double max_samples = 400;    ///< along the longer side of a room
constexpr double beside_wall = 0.03;   ///< metres

/** @brief Square lattice over a box. */
struct Lattice {
  Eigen::Vector2d origin;
  double spacing;
  int columns;
  int rows;

  explicit Lattice(const Eigen::AlignedBox2d& box)
      : origin(box.min())
      , spacing(std::max(usual_spacing, box.sizes().maxCoeff() / max_samples))
      , columns(static_cast<int>(box.sizes().x() / spacing) + 2)
      , rows(static_cast<int>(box.sizes().y() / spacing) + 2)
  {}

  Eigen::Vector2d at(int x, int y) const
  {
    return origin + spacing * Eigen::Vector2d(x, y);
  }
};

using Segments = std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>>;

/** @brief Appends where a function is zero in the squares of a lattice that meet a box,
 * of which `isWanted` the middle (marching squares; Lorensen and Cline 1987). */
template <typename Function, typename IsWanted>
void
addZeros(const Lattice& lattice,
         const Eigen::AlignedBox2d& box,
         Function function,
         IsWanted isWanted,
         Segments& segments)
{
  const Eigen::Array2d low = (box.min() - lattice.origin) / lattice.spacing;
  const Eigen::Array2d high = (box.max() - lattice.origin) / lattice.spacing;
  const Eigen::Array2i first = low.floor().cast<int>().max(0);
  const Eigen::Array2i last =
      high.floor().cast<int>().min(Eigen::Array2i(lattice.columns, lattice.rows) - 2);
  for (int y = first.y(); y <= last.y(); ++y)
    for (int x = first.x(); x <= last.x(); ++x) {
      const Eigen::Vector2d corners[] = {lattice.at(x, y), lattice.at(x + 1, y),
                                         lattice.at(x + 1, y + 1),
                                         lattice.at(x, y + 1)};
      double values[4];
      std::transform(corners, corners + 4, values, function);
      std::vector<Eigen::Vector2d> crossings;
      for (int k = 0; k < 4; ++k) {
        const double a = values[k];
        const double b = values[(k + 1) % 4];
        if ((a < 0) != (b < 0))
          crossings.push_back(corners[k] +
                              a / (a - b) * (corners[(k + 1) % 4] - corners[k]));
      }
      for (std::size_t k = 0; k + 1 < crossings.size(); k += 2)
        if (isWanted((crossings[k] + crossings[k + 1]) / 2))
          segments.emplace_back(crossings[k], crossings[k + 1]);
    }
}

} // namespace

std::vector<PlanElement>
heightLines(const PlanRoom& room, double height)
{
  constexpr double tolerance = 0.005;
  constexpr double shortest = 0.5; // metres: less tells nobody anything
  std::vector<PlanElement> lines;
  if (!room.hasFacets() || room.boundary.elements.empty())
    return lines;
  const RoomLookup lookup(room);
  const Lattice lattice(boundsOf(room.boundary));
  Segments segments;
  // Of each pair of a part of the ceiling and one of the floor, where they are.
  for (int d = -1; d < static_cast<int>(room.details.size()); ++d)
    for (int f = -1; f < static_cast<int>(room.floor_details.size()); ++f) {
      const PlanSlab& ceiling = room.ceilingSlab(d);
      const PlanSlab& floor = room.floorSlab(f);
      Eigen::AlignedBox2d box = boundsOf(room.boundary);
      if (d >= 0)
        box = box.intersection(
            boundsOf(room.details[static_cast<std::size_t>(d)].boundary));
      if (f >= 0)
        box = box.intersection(
            boundsOf(room.floor_details[static_cast<std::size_t>(f)].boundary));
      if (box.isEmpty())
        continue;
      addZeros(
          lattice, box,
          [&](const Eigen::Vector2d& p) {
            return ceiling.heightAt(p) - floor.heightAt(p) - height;
          },
          [&](const Eigen::Vector2d& p) {
            return lookup.contains(p) && lookup.detailAt(p) == d &&
                   lookup.floorDetailAt(p) == f;
          },
          segments);
    }
  for (const std::vector<Eigen::Vector2d>& line : chained(segments)) {
    Eigen::AlignedBox2d extent;
    for (const Eigen::Vector2d& place : line)
      extent.extend(place);
    if (extent.diagonal().norm() < shortest)
      continue;
    const std::vector<Eigen::Vector2d> places = simplifiedLine(line, tolerance);
    for (std::size_t k = 0; k + 1 < places.size(); ++k)
      lines.push_back(segment(places[k], places[k + 1]));
  }
  return lines;
}

std::pair<double, double>
heightRange(const PlanRoom& room)
{
  const RoomLookup lookup(room);
  std::pair<double, double> range(std::numeric_limits<double>::infinity(),
                                  -std::numeric_limits<double>::infinity());
  // Parts below a 50th of the largest one do not count.
  constexpr std::size_t few = 50;
  const Lattice lattice(boundsOf(room.boundary));
  std::map<int, std::size_t> samples; // by detail
  std::size_t most = 0;
  for (int y = 0; y < lattice.rows; ++y)
    for (int x = 0; x < lattice.columns; ++x)
      if (lookup.contains(lattice.at(x, y)))
        most = std::max(most, ++samples[lookup.detailAt(lattice.at(x, y))]);
  // The height at a place of what is above another one, nearby in the room.
  const auto add = [&](const Eigen::Vector2d& place, const Eigen::Vector2d& inside) {
    const int detail = lookup.detailAt(inside);
    if (!lookup.contains(inside) || few * samples[detail] < most)
      return;
    const double height =
        room.ceilingSlab(detail).heightAt(place) - lookup.floorAt(inside);
    range = {std::min(range.first, height), std::max(range.second, height)};
  };
  for (int y = 0; y < lattice.rows; ++y)
    for (int x = 0; x < lattice.columns; ++x)
      add(lattice.at(x, y), lattice.at(x, y));
  const auto addAlong = [&](const PlanLoop& loop) {
    for (const PlanElement& e : loop.elements)
      for (const double share : {0.02, 0.5, 0.98}) {
        const double s = share * e.length();
        add(e.pointAt(s), e.pointAt(s) + beside_wall * e.normalAt(s));
      }
  };
  addAlong(room.boundary);
  for (const PlanDetail& detail : room.details)
    addAlong(detail.boundary);
  return range;
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
