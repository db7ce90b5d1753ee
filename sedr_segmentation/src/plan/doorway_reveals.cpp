// SPDX-License-Identifier: BSD-3-Clause
#include "doorway_reveals.h"

#include "../curves/plan_segment.h"
#include "../details/detail_trim.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace pcl::sedr {
namespace {

/** @brief What may be a reveal: three consecutive elements of a loop. */
struct Reveal {
  const PlanElement& out_jamb; ///< from the room to the end of the reveal
  const PlanElement& end;
  const PlanElement& in_jamb; ///< back to the room
};

/** @brief How deep a jamb is, seen from the end of the reveal; nothing if it is none.
 * @param away from the end of the reveal to the room */
std::optional<double>
depthOf(const PlanElement& jamb, const Eigen::Vector2d& away, const Priors& priors)
{
  const double min_cosine = std::cos(radians(30)); // off the way into the room
  const double depth = std::abs(away.dot(jamb.end - jamb.start));
  if (jamb.isArc() || depth > priors.max_wall || depth < min_cosine * jamb.length())
    return std::nullopt;
  return depth;
}

/** @brief Whether elements are the reveal of a doorway of a room. */
bool
isRevealOf(const PlanRoom& room,
           const Reveal& reveal,
           const PlanDoorway& doorway,
           const Priors& priors)
{
  const PlanElement& end = reveal.end;
  if (end.isArc() || end.length() <= 0)
    return false;
  const Eigen::Vector2d inward = end.normalAt(0);
  const auto first = depthOf(reveal.out_jamb, inward, priors);
  const auto second = depthOf(reveal.in_jamb, inward, priors);
  if (!first || !second || std::abs(*first - *second) > priors.surface_band ||
      inward.dot(reveal.out_jamb.end - reveal.out_jamb.start) >= 0 ||
      inward.dot(reveal.in_jamb.end - reveal.in_jamb.start) <= 0)
    return false;
  const double beside = priors.run_gap; // a doorway's line is not exact
  const Eigen::Vector2d middle = (doorway.start + doorway.end) / 2;
  const double off = inward.dot(middle - end.start);
  const double depth = std::max(*first, *second);
  const double along = (end.end - end.start).normalized().dot(middle - end.start);
  const Eigen::Vector2d before =
      end.pointAt(end.length() / 2) + (depth + priors.wall_band) * inward;
  return off > -beside && off < depth + beside && along > 0 && along < end.length() &&
         doorway.top + priors.min_drop < room.ceilingAt(before);
}

bool
areInLine(const PlanElement& a, const PlanElement& b, const Priors& priors)
{
  const double off = 2 * priors.wall_noise;
  if (a.isArc() || b.isArc())
    return false;
  const Eigen::Vector2d way = (a.end - a.start).normalized();
  const Eigen::Vector2d left(-way.y(), way.x());
  return way.dot(b.end - b.start) > 0 &&
         std::abs(left.dot(b.end - b.start)) < priors.same_direction * b.length() &&
         std::abs(left.dot(b.start - a.end)) < off &&
         std::abs(left.dot(b.end - a.end)) < off;
}

/** @brief One element for two in a line. */
PlanElement
joined(const PlanElement& a, const PlanElement& b)
{
  PlanElement e = segment(a.start, b.end);
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

/** @brief Closes the mouth of the reveal that is the last three elements of a loop. */
void
closeMouth(const PlanRoom& room,
           std::vector<PlanElement>& loop,
           const PlanDoorway& doorway,
           const Priors& priors)
{
  const std::size_t n = loop.size();
  PlanElement mouth = segment(loop[n - 3].start, loop[n - 1].end);
  if (loop.front().evidence.isKnown()) {
    const Eigen::Vector2d middle = (mouth.start + mouth.end) / 2;
    const double height = room.ceilingAt(middle) - room.floorAt(middle);
    mouth.evidence.opening =
        std::clamp((doorway.top - doorway.bottom) / std::max(height, 1e-3), 0.0, 1.0);
    mouth.evidence.hidden = 1 - mouth.evidence.opening;
  }
  loop.resize(n - 3);
  if (areInLine(loop.back(), mouth, priors)) {
    mouth = joined(loop.back(), mouth);
    loop.pop_back();
  }
  if (areInLine(mouth, loop.front(), priors))
    loop.front() = joined(mouth, loop.front());
  else
    loop.push_back(mouth);
}

/** @brief Closes the first reveal of a doorway along a loop; a doorway has one at each
 * side of its wall.
 * @param loop of the room
 * @return whether there was one */
bool
closeRevealAlong(const PlanRoom& room,
                 PlanLoop& loop,
                 const PlanDoorway& doorway,
                 const Priors& priors)
{
  std::vector<PlanElement>& elements = loop.elements;
  const std::size_t n = elements.size();
  for (std::size_t k = 0; n >= 6 && k < n; ++k) { // a reveal and three walls
    const Reveal reveal{elements[(k + n - 3) % n], elements[(k + n - 2) % n],
                        elements[(k + n - 1) % n]};
    if (!isRevealOf(room, reveal, doorway, priors))
      continue;
    std::rotate(elements.begin(), elements.begin() + static_cast<std::ptrdiff_t>(k),
                elements.end());
    closeMouth(room, elements, doorway, priors);
    return true;
  }
  return false;
}

} // namespace

void
closeReveals(Floorplan& plan, const Priors& priors)
{
  for (PlanRoom& room : plan.rooms) {
    bool is_changed = false;
    for (const PlanDoorway& doorway : plan.doorways) {
      if (room.id != doorway.rooms[0] && room.id != doorway.rooms[1])
        continue;
      is_changed |= closeRevealAlong(room, room.boundary, doorway, priors);
      for (PlanLoop& column : room.columns)
        is_changed |= closeRevealAlong(room, column, doorway, priors);
    }
    if (is_changed)
      trimDetails(room);
  }
}

} // namespace pcl::sedr
