// SPDX-License-Identifier: BSD-3-Clause
#include "doorway_reveals.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace pcl::sedr {
namespace {

/** @brief A loop from the mouth of a reveal around the room and back to it: jamb, end
 * and jamb are the last three elements. */
using FromMouth = std::vector<PlanElement>;

PlanElement
segmentFrom(const Eigen::Vector2d& from, const Eigen::Vector2d& to)
{
  PlanElement e;
  e.start = from;
  e.end = to;
  return e;
}

/** @brief How deep a jamb is, seen from the end of the reveal; nothing if it is none.
 * @param away from the end of the reveal to the room */
std::optional<double>
depthOf(const PlanElement& jamb, const Eigen::Vector2d& away)
{
  constexpr double deepest = 0.6;     // metres
  constexpr double min_cosine = 0.87; // 30 degrees off the way into the room
  const double depth = std::abs(away.dot(jamb.end - jamb.start));
  if (jamb.isArc() || depth > deepest || depth < min_cosine * jamb.length())
    return std::nullopt;
  return depth;
}

/** @brief Whether the last three elements are the reveal of a doorway of a room. */
bool
isRevealOf(const PlanRoom& room, const FromMouth& loop, const PlanDoorway& doorway)
{
  constexpr double min_lintel = 0.1; // metres
  constexpr double beside = 0.15;    // a doorway's line is not exact
  constexpr double same_depth = 0.1; // of both jambs
  const std::size_t n = loop.size();
  const PlanElement& end = loop[n - 2];
  if (n < 6 || end.isArc() || end.length() <= 0)
    return false;
  const Eigen::Vector2d inward = end.normalAt(0);
  const Eigen::Vector2d out_jamb = loop[n - 3].end - loop[n - 3].start;
  const Eigen::Vector2d in_jamb = loop[n - 1].end - loop[n - 1].start;
  const auto first = depthOf(loop[n - 3], inward);
  const auto second = depthOf(loop[n - 1], inward);
  if (!first || !second || std::abs(*first - *second) > same_depth ||
      inward.dot(out_jamb) >= 0 || inward.dot(in_jamb) <= 0)
    return false;
  const Eigen::Vector2d middle = (doorway.start + doorway.end) / 2;
  const double off = inward.dot(middle - end.start);
  const double depth = std::max(*first, *second);
  const Eigen::Vector2d way = (end.end - end.start).normalized();
  const double along = way.dot(middle - end.start);
  const Eigen::Vector2d mouth = end.pointAt(end.length() / 2) + depth * inward;
  constexpr double into_room = 0.05; // past the reveal
  return off > -beside && off < depth + beside && along > 0 && along < end.length() &&
         doorway.top + min_lintel < room.ceilingAt(mouth + into_room * inward);
}

bool
areInLine(const PlanElement& a, const PlanElement& b)
{
  constexpr double off = 0.02;      // metres
  constexpr double parallel = 0.05; // sine
  if (a.isArc() || b.isArc())
    return false;
  const Eigen::Vector2d way = (a.end - a.start).normalized();
  const Eigen::Vector2d left(-way.y(), way.x());
  return way.dot(b.end - b.start) > 0 &&
         std::abs(left.dot(b.end - b.start)) < parallel * b.length() &&
         std::abs(left.dot(b.start - a.end)) < off &&
         std::abs(left.dot(b.end - a.end)) < off;
}

/** @brief One element for two in a line. */
PlanElement
joined(const PlanElement& a, const PlanElement& b)
{
  PlanElement e = segmentFrom(a.start, b.end);
  const double share = a.length() / (a.length() + b.length());
  const auto mean = [&](double at_a, double at_b) {
    return share * at_a + (1 - share) * at_b;
  };
  e.evidence = {mean(a.evidence.seen, b.evidence.seen),
                mean(a.evidence.hidden, b.evidence.hidden),
                mean(a.evidence.opening, b.evidence.opening)};
  e.inliers = a.inliers + b.inliers;
  const auto squares = [](const PlanElement& of) {
    return static_cast<double>(of.inliers) * of.residual * of.residual;
  };
  if (e.inliers > 0)
    e.residual = std::sqrt((squares(a) + squares(b)) / static_cast<double>(e.inliers));
  return e;
}

/** @brief Closes the mouth of the reveal at the end of a loop. */
void
closeMouth(const PlanRoom& room, FromMouth& loop, const PlanDoorway& doorway)
{
  const std::size_t n = loop.size();
  PlanElement mouth = segmentFrom(loop[n - 3].start, loop[n - 1].end);
  if (loop.front().evidence.isKnown()) {
    const Eigen::Vector2d middle = (mouth.start + mouth.end) / 2;
    const double height = room.ceilingAt(middle) - room.floorAt(middle);
    mouth.evidence.opening =
        std::clamp((doorway.top - doorway.bottom) / std::max(height, 1e-3), 0.0, 1.0);
    mouth.evidence.hidden = 1 - mouth.evidence.opening;
  }
  loop.resize(n - 3);
  if (areInLine(loop.back(), mouth)) {
    mouth = joined(loop.back(), mouth);
    loop.pop_back();
  }
  if (areInLine(mouth, loop.front()))
    loop.front() = joined(mouth, loop.front());
  else
    loop.push_back(mouth);
}

/** @brief Closes the reveals of a doorway along a loop. */
void
closeRevealsAlong(const PlanRoom& room, PlanLoop& loop, const PlanDoorway& doorway)
{
  for (std::size_t k = 0; k < loop.elements.size(); ++k) {
    FromMouth turned = loop.elements;
    std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(k),
                turned.end());
    if (!isRevealOf(room, turned, doorway))
      continue;
    closeMouth(room, turned, doorway);
    loop.elements = std::move(turned);
    return;
  }
}

} // namespace

void
closeReveals(Floorplan& plan)
{
  for (const PlanDoorway& doorway : plan.doorways)
    for (PlanRoom& room : plan.rooms) {
      if (room.id != doorway.rooms[0] && room.id != doorway.rooms[1])
        continue;
      const PlanRoom before = room;
      closeRevealsAlong(before, room.boundary, doorway);
      for (PlanLoop& column : room.columns)
        closeRevealsAlong(before, column, doorway);
    }
}

} // namespace pcl::sedr
