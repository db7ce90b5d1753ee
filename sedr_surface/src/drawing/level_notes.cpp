// SPDX-License-Identifier: BSD-3-Clause
#include "level_notes.h"

#include "../formats/decimal_text.h"
#include "../sheet/plan_frame.h"
#include "sedr_filters/src/plan/level_planes.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace pcl::sedr {

namespace {

PlanLoop
circleAbout(const Eigen::Vector2d& centre, double radius)
{
  PlanElement circle;
  circle.centre = centre;
  circle.radius = radius;
  circle.start = circle.end = centre + Eigen::Vector2d(radius, 0);
  return {{circle}};
}

/** @brief Returns the details of the ceiling that have a note: the largest of each
 * part, in order.
 * @param part of the main ceiling and of each detail, see CeilingLines */
std::vector<std::size_t>
notedDetails(const PlanRoom& room, const std::vector<std::size_t>& part)
{
  const auto areaOf = [&](std::size_t d) {
    return std::abs(room.details[d].boundary.area());
  };
  std::map<std::size_t, std::size_t> largest;
  for (std::size_t d = 0; d < room.details.size(); ++d) {
    const auto [best, is_first] = largest.emplace(part[d + 1], d);
    if (!is_first && areaOf(d) > areaOf(best->second))
      best->second = d;
  }
  std::vector<std::size_t> noted;
  for (std::size_t d = 0; d < room.details.size(); ++d)
    if (part[d + 1] != part.front() && largest[part[d + 1]] == d)
      noted.push_back(d);
  return noted;
}

} // namespace

std::vector<LevelNote>
levelNotes(const PlanRoom& room, const CeilingLines& ceiling, const TextSpot& room_text)
{
  std::vector<LevelNote> notes;
  const auto add = [&](const std::vector<PlanDetail>& details, std::size_t d,
                       const std::vector<Eigen::AlignedBox2d>& boxes,
                       DrawnLayer layer) {
    const PlanDetail& detail = details[d];
    std::vector<PlanLoop> others = detail.holes; // and details above it
    for (std::size_t later = d + 1; later < details.size(); ++later)
      if (boxes[later].intersects(boxes[d]))
        others.push_back(details[later].boundary);
    others.push_back(circleAbout(room_text.place, room_text.radius));
    LevelNote note{textSpotIn(detail.boundary, others), {}, layer};
    if (!room.contains(note.spot.place))
      return;
    const Eigen::Vector2d& p = note.spot.place;
    note.spot.radius = std::min(note.spot.radius, room.boundary.distance(p));
    const double height = detail.slab.heightAt(p) - room.floor.heightAt(p);
    if (detail.is_facet && !isLevel(detail.slab))
      return; // its height is not constant
    const bool is_floor = layer == DrawnLayer::FloorDetail;
    note.text = (is_floor && height > 0 ? "+" : "") + decimalText(height, 2);
    notes.push_back(note);
  };
  const auto boxesOf = [](const std::vector<PlanDetail>& details) {
    std::vector<Eigen::AlignedBox2d> boxes;
    for (const PlanDetail& detail : details)
      boxes.push_back(boundsOf(detail.boundary));
    return boxes;
  };
  const std::vector<Eigen::AlignedBox2d> overhead = boxesOf(room.details);
  for (const std::size_t d : notedDetails(room, ceiling.part))
    add(room.details, d, overhead, DrawnLayer::Detail);
  const std::vector<Eigen::AlignedBox2d> steps = boxesOf(room.floor_details);
  for (std::size_t d = 0; d < room.floor_details.size(); ++d)
    add(room.floor_details, d, steps, DrawnLayer::FloorDetail);
  return notes;
}

} // namespace pcl::sedr
