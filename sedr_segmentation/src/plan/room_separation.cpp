// SPDX-License-Identifier: BSD-3-Clause
#include "../details/detail_trim.h"

#include "room_separation.h"

#include "../curves/contour.h"
#include "../curves/loop_difference.h"
#include "../loop/loop_lobes.h"
#include "../loop/loop_necks.h"
#include "sedr_filters/src/base/exactness.h"
#include "sedr_filters/src/plan/plan_bounds.h"
#include "sedr_filters/src/plan/plan_evidence.h"
#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <set>
#include <utility>

namespace pcl::sedr {

namespace {

bool
overlap(const PlanLoop& a, const PlanLoop& b)
{
  if (!boundsOf(a).intersects(boundsOf(b)))
    return false;
  const auto [of_a, of_b] = partsInside(a, b);
  return !of_a.empty() || !of_b.empty();
}

/** @brief Returns the hole of another room that contains most of a room, or null. Such
 * a room lies in the core of the other one or was cut out of it. */
const PlanLoop*
holeAround(const PlanRoom& room, const PlanRoom& other)
{
  for (const PlanLoop& hole : other.columns) {
    double area = 0;
    for (const PlanLoop& part : intersection(room.boundary, reversed(hole)))
      area += part.area();
    if (2 * area > room.boundary.area())
      return &hole;
  }
  return nullptr;
}

/** @brief Returns the seen length of a room's walls inside another room. */
double
seenInside(const PlanRoom& room,
           const PlanLoop& other,
           const PointView& points,
           const std::vector<int>& indices)
{
  Floorplan plan;
  plan.rooms.push_back(room);
  plan.rooms.front().boundary.elements = partsInside(room.boundary, other).first;
  measureEvidence(plan, points, indices);
  double length = 0;
  for (const auto& e : plan.rooms.front().boundary.elements)
    length += e.evidence.seen * e.length();
  return length;
}

/** @brief Returns the largest part of a loop outside `cutter`. */
PlanLoop
largestPart(const PlanLoop& loop, const PlanLoop& cutter)
{
  const bool is_clockwise = loop.area() < 0;
  const std::vector<PlanLoop> parts =
      difference(is_clockwise ? reversed(loop) : loop, cutter);
  if (parts.empty() || !(parts.front().area() > 0))
    return {};
  return is_clockwise ? reversed(parts.front()) : parts.front();
}

void
cutDetails(std::vector<PlanDetail>& details, const PlanLoop& cutter)
{
  for (auto& detail : details) {
    if (!overlap(detail.boundary, cutter))
      continue;
    detail.boundary = largestPart(detail.boundary, cutter);
    for (auto& hole : detail.holes)
      hole = largestPart(hole, cutter);
    detail.holes.erase(
        std::remove_if(detail.holes.begin(), detail.holes.end(),
                       [](const PlanLoop& h) { return h.elements.empty(); }),
        detail.holes.end());
  }
  details.erase(
      std::remove_if(details.begin(), details.end(),
                     [](const PlanDetail& d) { return d.boundary.elements.empty(); }),
      details.end());
}

/** @brief Removes the inside of `cutter` from a room.
 * @param parts the remaining parts of its boundary */
void
cutRoom(PlanRoom& room, const PlanLoop& cutter, const std::vector<PlanLoop>& parts)
{
  room.boundary = parts.front();
  const auto isOutside = [&](const PlanLoop& column) {
    return overlap(column, cutter) ||
           !room.boundary.contains(column.elements.front().start);
  };
  room.columns.erase(
      std::remove_if(room.columns.begin(), room.columns.end(), isOutside),
      room.columns.end());
  // The other room may lie completely inside this one.
  for (std::size_t p = 1; p < parts.size(); ++p)
    if (parts[p].area() < 0 && room.boundary.contains(parts[p].elements[0].start))
      room.columns.push_back(parts[p]);
  cutDetails(room.details, cutter);
  cutDetails(room.floor_details, cutter);
  const auto isLost = [&](const PlanNiche& niche) {
    return std::none_of(niche.boundary.elements.begin(), niche.boundary.elements.end(),
                        [&](const PlanElement& e) {
                          return room.boundary.distance(e.pointAt(e.length() / 2)) <
                                 1e-5;
                        });
  };
  room.niches.erase(std::remove_if(room.niches.begin(), room.niches.end(), isLost),
                    room.niches.end());
}

/** @brief Returns whether a niche overlaps a room or one of its niches. */
bool
reachesInto(const PlanNiche& niche, const PlanRoom& room)
{
  return overlap(niche.boundary, room.boundary) ||
         std::any_of(room.niches.begin(), room.niches.end(), [&](const PlanNiche& n) {
           return overlap(niche.boundary, n.boundary);
         });
}

/** @brief Returns whether a niche takes all of a pier: two of its sides, square to its
 * mouth, lie at both ends on walls of the room that are square to it, too, so that it
 * is a part of the room beside it. */
bool
takesPier(const PlanNiche& niche, const PlanRoom& room, const Priors& priors)
{
  const auto& sides = niche.boundary.elements;
  const auto middleOf = [](const PlanElement& e) { return e.pointAt(e.length() / 2); };
  const PlanElement& mouth = *std::min_element(
      sides.begin(), sides.end(), [&](const PlanElement& a, const PlanElement& b) {
        return room.boundary.distance(middleOf(a)) <
               room.boundary.distance(middleOf(b));
      });
  const Eigen::Vector2d normal = mouth.normalAt(mouth.length() / 2);
  const auto isSquare = [&](const PlanElement& e, const Eigen::Vector2d& p) {
    return std::abs(e.normalAt(e.project(p)).dot(normal)) < M_SQRT1_2;
  };
  const auto isOnWall = [&](const Eigen::Vector2d& p) {
    return std::any_of(room.boundary.elements.begin(), room.boundary.elements.end(),
                       [&](const PlanElement& e) {
                         return e.distance(p) < priors.min_wall && isSquare(e, p);
                       });
  };
  return std::count_if(sides.begin(), sides.end(), [&](const PlanElement& side) {
           return isSquare(side, side.start) && isOnWall(side.start) &&
                  isOnWall(side.end);
         }) > 1;
}

void
dropNiches(Floorplan& plan, const Priors& priors)
{
  std::vector<Eigen::AlignedBox2d> bounds; // of rooms with their niches
  for (const auto& room : plan.rooms) {
    bounds.push_back(boundsOf(room.boundary));
    for (const auto& niche : room.niches)
      bounds.back().extend(boundsOf(niche.boundary));
  }
  for (std::size_t r = 0; r < plan.rooms.size(); ++r) {
    PlanRoom& room = plan.rooms[r];
    const auto isNone = [&](const PlanNiche& niche) {
      if (takesPier(niche, room, priors))
        return true;
      const Eigen::AlignedBox2d own = boundsOf(niche.boundary);
      for (std::size_t o = 0; o < plan.rooms.size(); ++o)
        if (const PlanRoom& other = plan.rooms[o];
            o != r && own.intersects(bounds[o]) && shareHeights(room, other) &&
            reachesInto(niche, other))
          return true;
      return false;
    };
    room.niches.erase(std::remove_if(room.niches.begin(), room.niches.end(), isNone),
                      room.niches.end());
  }
}

std::string
sentenceOf(const PlanRoom& room, const PlanRoom& other, double area)
{
  char text[120];
  std::snprintf(text, sizeof text,
                "room %u: %.2f m2 of it ran into room %u and are left to that", room.id,
                area, other.id);
  return text;
}

/** @brief Cuts a room back from another one. If coinciding curves break the result, it
 * is tried again with a slightly larger cutter.
 * @return false if nothing is left of the room */
bool
cutBack(PlanRoom& room, const PlanRoom& from, const Priors& priors)
{
  constexpr double fine_chord = 0.002;
  const double slack = priors.evidence_cell * priors.evidence_cell;
  constexpr int tries = 5;
  std::optional<PlanRoom> left;
  for (int k = 0; k < tries; ++k) {
    const PlanLoop cutter =
        widened(from.boundary, priors.assumed_partition + 1.3 * priors.unevenness * k);
    const std::vector<PlanLoop> parts = difference(room.boundary, cutter);
    if (parts.empty() || !(parts.front().area() > 0))
      continue;
    left = room;
    cutRoom(*left, cutter, parts);
    double lost = room.boundary.area();
    for (const auto& part : parts)
      lost -= part.area();
    if (lost < cutter.area() + slack &&
        !crossesItself(left->boundary.polygon(fine_chord)) &&
        (holeAround(from, *left) || !overlap(left->boundary, from.boundary)))
      break;
  }
  if (!left)
    return false;
  room = std::move(*left);
  return true;
}

/** @brief Clips a room that lies mostly in a hole of another one to that hole.
 * @return whether there is such a hole */
bool
keepInHole(PlanRoom& room, const PlanRoom& other, const Priors& priors)
{
  const PlanLoop* const hole = holeAround(room, other);
  if (!hole)
    return false;
  if (!partsInside(room.boundary, reversed(*hole)).second.empty()) {
    const std::vector<PlanLoop> parts = intersection(
        room.boundary, widened(reversed(*hole), -priors.assumed_partition));
    if (!parts.empty())
      room.boundary = parts.front();
  }
  return true;
}

/** @brief Resolves all pairwise overlaps once.
 * @param[in,out] gone rooms of which nothing is left
 * @return whether any two overlapped */
bool
separateOnce(Floorplan& plan,
             const PointView& points,
             const std::vector<int>& indices,
             const Priors& priors,
             std::set<std::size_t>& gone,
             std::vector<std::string>& sentences)
{
  bool has_changed = false;
  std::vector<Eigen::AlignedBox2d> bounds; // a cut can only shrink a room
  for (const auto& room : plan.rooms)
    bounds.push_back(boundsOf(room.boundary));
  for (std::size_t a = 0; a < plan.rooms.size(); ++a)
    for (std::size_t b = a + 1; b < plan.rooms.size(); ++b) {
      PlanRoom& first = plan.rooms[a];
      PlanRoom& second = plan.rooms[b];
      if (!bounds[a].intersects(bounds[b]) || gone.count(a) + gone.count(b) > 0 ||
          !shareHeights(first, second) || keepInHole(first, second, priors) ||
          keepInHole(second, first, priors) ||
          !overlap(first.boundary, second.boundary))
        continue;
      has_changed = true;
      const double seen_first = seenInside(first, second.boundary, points, indices);
      const double seen_second = seenInside(second, first.boundary, points, indices);
      const bool is_first_cut = seen_first == seen_second ? first.area() > second.area()
                                                          : seen_first < seen_second;
      PlanRoom& loser = is_first_cut ? first : second;
      const PlanRoom& winner = is_first_cut ? second : first;
      double lost = loser.area();
      if (cutBack(loser, winner, priors))
        lost -= loser.area();
      else
        gone.insert(is_first_cut ? a : b);
      if (lost > priors.small_area)
        sentences.push_back(sentenceOf(loser, winner, lost));
    }
  return has_changed;
}

/** @brief Cuts off slits and spikes of a room and of its details. */
void
cutNecksOf(PlanRoom& room, const Priors& priors)
{
  if (cutNecks(room.boundary, priors) == 0)
    return;
  for (auto* details : {&room.details, &room.floor_details})
    for (PlanDetail& detail : *details)
      cutNecks(detail.boundary, priors);
}

} // namespace

std::vector<std::string>
separateRooms(Floorplan& plan,
              const PointView& points,
              const std::vector<int>& indices,
              const Priors& priors)
{
  constexpr int max_rounds = 4; // a cut room may overlap a third
  std::vector<std::string> sentences;
  std::set<std::size_t> gone;
  for (int round = 0; round < max_rounds; ++round)
    if (!separateOnce(plan, points, indices, priors, gone, sentences))
      break;
  for (auto it = gone.rbegin(); it != gone.rend(); ++it)
    plan.rooms.erase(plan.rooms.begin() + static_cast<std::ptrdiff_t>(*it));
  for (PlanRoom& room : plan.rooms) {
    cutNecksOf(room, priors);
    dropPoints(room.boundary);
    trimDetails(room);
  }
  dropNiches(plan, priors);
  return sentences;
}

} // namespace pcl::sedr
