// SPDX-License-Identifier: BSD-3-Clause
#include "detail_trim.h"

#include "sedr_filters/src/base/exactness.h"

#include "../curves/loop_difference.h"
#include "../curves/plan_curve.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace pcl::sedr {

namespace {

/** @brief Returns whether a corner of a loop lies outside a boundary, or a part of the
 * boundary inside the loop. */
bool
reachesOut(const PlanLoop& loop, const PlanLoop& boundary)
{
  const auto isOff = [](const PlanLoop& other, const Eigen::Vector2d& p) {
    return other.distance(p) > same_line;
  };
  const std::vector<Eigen::Vector2d> corners = loop.polygon(same_line);
  const std::vector<PlanElement> crossed = partsInside(loop, boundary).second;
  return std::any_of(corners.begin(), corners.end(),
                     [&](const Eigen::Vector2d& p) {
                       return isOff(boundary, p) && !boundary.contains(p);
                     }) ||
         std::any_of(crossed.begin(), crossed.end(), [&](const PlanElement& e) {
           return isOff(loop, e.pointAt(e.length() / 2));
         });
}

/** @brief Returns the lines of a boundary's segments that a side nearly follows. */
std::vector<PlanCurve>
linesAlong(const PlanElement& side, const PlanLoop& boundary)
{
  std::vector<PlanCurve> lines;
  for (const PlanElement& e : boundary.elements) {
    if (side.isArc() || e.isArc() || !(e.length() > same_line))
      continue;
    const PlanCurve line = carrierOf(e);
    if (line.distance(side.start) <= same_line &&
        line.distance(side.end) <= same_line &&
        std::min({e.distance(side.start), e.distance(side.end), side.distance(e.start),
                  side.distance(e.end)}) <= same_line)
      lines.push_back(line);
  }
  return lines;
}

/** @brief Returns a loop with its segments moved onto the boundary's segments with
 * which they nearly coincide. */
PlanLoop
snapped(PlanLoop loop, const PlanLoop& boundary)
{
  std::vector<PlanElement>& elements = loop.elements;
  const std::vector<PlanElement> were = elements;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const std::size_t before = (i + elements.size() - 1) % elements.size();
    const std::vector<PlanCurve> first = linesAlong(were[before], boundary);
    const std::vector<PlanCurve> second = linesAlong(were[i], boundary);
    if (were[before].isArc() || were[i].isArc() || (first.empty() && second.empty()))
      continue;
    Eigen::Vector2d corner =
        (first.empty() ? second : first).front().project(were[i].start);
    if (!first.empty() && !second.empty())
      for (const auto& crossing : intersections(first.front(), second.front()))
        if ((crossing - were[i].start).norm() <= 2 * same_line)
          corner = crossing;
    elements[before].end = elements[i].start = corner;
  }
  return loop;
}

/** @brief Returns the parts of a counter-clockwise loop inside a boundary. Returns the
 * loop itself if the result is inconsistent, e.g. when both coincide up to rounding. */
std::vector<PlanLoop>
within(const PlanLoop& loop, const PlanLoop& boundary)
{
  std::vector<PlanLoop> inside = intersection(loop, boundary);
  double missing = loop.area();
  for (const auto& part : inside)
    missing -= part.area();
  for (const auto& part : difference(loop, boundary))
    missing -= part.area();
  if (std::abs(missing) > same_place) // square metres
    return {loop};
  inside.erase(std::remove_if(inside.begin(), inside.end(),
                              [](const PlanLoop& part) {
                                return 2 * part.area() <= same_line * part.length();
                              }),
               inside.end());
  return inside;
}

/** @brief Returns the parts of a detail inside a boundary, with their holes. */
std::vector<PlanDetail>
trimmed(const PlanDetail& detail, const PlanLoop& boundary)
{
  std::vector<PlanDetail> parts;
  for (const PlanLoop& loop : within(snapped(detail.boundary, boundary), boundary)) {
    PlanDetail part;
    part.boundary = loop;
    part.slab = detail.slab;
    part.is_facet = detail.is_facet;
    for (const PlanLoop& hole : detail.holes)
      for (const PlanLoop& of_hole : within(reversed(hole), loop))
        part.holes.push_back(reversed(of_hole));
    parts.push_back(std::move(part));
  }
  return parts;
}

void
trim(std::vector<PlanDetail>& details, const PlanLoop& boundary)
{
  std::vector<PlanDetail> kept;
  for (PlanDetail& detail : details) {
    if (!reachesOut(detail.boundary, boundary)) {
      kept.push_back(std::move(detail));
      continue;
    }
    for (PlanDetail& part : trimmed(detail, boundary))
      kept.push_back(std::move(part));
  }
  details = std::move(kept);
}

} // namespace

void
trimDetails(PlanRoom& room)
{
  trim(room.details, room.boundary);
  trim(room.floor_details, room.boundary);
}

} // namespace pcl::sedr
