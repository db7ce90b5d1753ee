// SPDX-License-Identifier: BSD-3-Clause
#include "level_notes.h"

#include "../formats/decimal_text.h"
#include "../sheet/plan_frame.h"
#include "roof_lines.h"
#include "sedr_filters/src/plan/level_planes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

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

/** @brief Puts details of a ceiling that go on into each other into one group. */
class CeilingGroups {
public:
  explicit CeilingGroups(const PlanRoom& room)
      : parent_(room.details.size() + 1)
  {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    for (std::size_t d = 0; d < room.details.size(); ++d)
      if (room.details[d].is_facet)
        joinAcross(room, d);
  }

  /** @brief The group of a detail; of the main ceiling for -1. */
  std::size_t of(int detail)
  {
    auto k = static_cast<std::size_t>(detail + 1);
    while (parent_[k] != k)
      k = parent_[k];
    return k;
  }

private:
  void joinAcross(const PlanRoom& room, std::size_t d)
  {
    for (const PlanElement& border : room.details[d].boundary.elements) {
      if (border.length() <= 0 || roofLineAt(room, border).is_seen)
        continue;
      const double s = border.length() / 2;
      const Eigen::Vector2d outside =
          border.pointAt(s) - beside_border * border.normalAt(s);
      if (!room.contains(outside))
        continue;
      const int other = room.detailAt(outside);
      if (other < 0 || room.details[static_cast<std::size_t>(other)].is_facet)
        join(of(static_cast<int>(d)), of(other));
    }
  }

  void join(std::size_t a, std::size_t b) { parent_[std::max(a, b)] = std::min(a, b); }

  std::vector<std::size_t> parent_;
};

/** @brief Returns the details of the ceiling that have a note: the largest of each
 * group, in order. */
std::vector<std::size_t>
notedDetails(const PlanRoom& room)
{
  CeilingGroups groups(room);
  const auto areaOf = [&](std::size_t d) {
    return std::abs(room.details[d].boundary.area());
  };
  std::vector<std::size_t> largest(room.details.size() + 1, room.details.size());
  for (std::size_t d = 0; d < room.details.size(); ++d) {
    std::size_t& best = largest[groups.of(static_cast<int>(d))];
    if (best == room.details.size() || areaOf(d) > areaOf(best))
      best = d;
  }
  std::vector<std::size_t> noted;
  for (std::size_t d = 0; d < room.details.size(); ++d) {
    const std::size_t group = groups.of(static_cast<int>(d));
    if (group != groups.of(-1) && largest[group] == d)
      noted.push_back(d);
  }
  return noted;
}

} // namespace

std::vector<LevelNote>
levelNotes(const PlanRoom& room, const TextSpot& room_spot)
{
  constexpr double around_name = 0.35; // share of the free space
  std::vector<LevelNote> notes;
  const auto add = [&](const std::vector<PlanDetail>& details, std::size_t d,
                       const std::vector<Eigen::AlignedBox2d>& boxes,
                       DrawnLayer layer) {
    const PlanDetail& detail = details[d];
    std::vector<PlanLoop> others = detail.holes; // and details above it
    for (std::size_t later = d + 1; later < details.size(); ++later)
      if (boxes[later].intersects(boxes[d]))
        others.push_back(details[later].boundary);
    others.push_back(circleAbout(room_spot.place, around_name * room_spot.radius));
    LevelNote note{textSpotIn(detail.boundary, others), {}, layer};
    if (!room.contains(note.spot.place))
      return;
    const Eigen::Vector2d& p = note.spot.place;
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
  for (const std::size_t d : notedDetails(room))
    add(room.details, d, overhead, DrawnLayer::Detail);
  const std::vector<Eigen::AlignedBox2d> steps = boxesOf(room.floor_details);
  for (std::size_t d = 0; d < room.floor_details.size(); ++d)
    add(room.floor_details, d, steps, DrawnLayer::FloorDetail);
  return notes;
}

} // namespace pcl::sedr
