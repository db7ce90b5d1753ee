// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_segmentation/rooms_beyond_openings.h>

#include <pcl/sedr_filters/plan_evidence.h>
#include <pcl/sedr_filters/storeys.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>

namespace pcl {
namespace sedr {

namespace {

constexpr double most_seen = 0.05;   ///< share of a wall that was not in view
constexpr double least_open = 0.3;   ///< share of it before which nothing stands
constexpr double least_unseen = 1.5; ///< metres of such walls of a room
constexpr double least_share = 0.2;  ///< of its perimeter
constexpr double reach_behind = 1.0; ///< metres; a wall, and what of a room behind an
                                     ///< opening its lintel hides
constexpr double step = 0.1;         ///< metres

/** @brief Walls that nothing was seen of though nothing hides them, and their length.
 */
struct UnseenWalls {
  std::vector<const PlanElement*> walls;
  double length = 0;
};

/** @brief Whether the wall to where the scanner stood may be as long. */
bool
isMuch(double length, const PlanRoom& room)
{
  return length >= least_unseen && length >= least_share * room.boundary.length();
}

UnseenWalls
unseenWalls(const PlanRoom& room,
            const PointView& points,
            const std::vector<int>& indices)
{
  UnseenWalls unseen;
  const std::vector<PlanElement>& elements = room.boundary.elements;
  double candidates = 0;
  for (const PlanElement& e : elements)
    if (e.evidence.isKnown() && e.evidence.seen < most_seen)
      candidates += e.length();
  if (!isMuch(candidates, room))
    return unseen;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const PlanElement& e = elements[i];
    if (!e.evidence.isKnown() || e.evidence.seen >= most_seen ||
        countedEvidence(room, i, points, indices).opening < least_open)
      continue;
    unseen.walls.push_back(&e);
    unseen.length += e.length();
  }
  return unseen;
}

bool
isBehind(const PlanRoom& other, const PlanRoom& room, const PlanElement& wall)
{
  if (!shareHeights(other, room))
    return false;
  for (double s = step / 2; s < wall.length(); s += step)
    for (double d = step / 2; d < reach_behind; d += step) {
      const Eigen::Vector2d place = wall.pointAt(s) - d * wall.normalAt(s);
      if (other.boundary.contains(place))
        return true;
    }
  return false;
}

} // namespace

std::vector<std::string>
dropRoomsBeyondOpenings(Floorplan& plan,
                        const PointView& points,
                        const std::vector<int>& indices)
{
  std::vector<UnseenWalls> unseen;
  for (const PlanRoom& room : plan.rooms) {
    unseen.push_back(unseenWalls(room, points, indices));
    if (!isMuch(unseen.back().length, room))
      unseen.back().walls.clear();
  }
  std::vector<std::uint8_t> is_beyond(plan.rooms.size(), 0);
  std::vector<std::string> sentences;
  for (std::size_t r = 0; r < plan.rooms.size(); ++r) {
    const PlanRoom& room = plan.rooms[r];
    double length = 0;
    for (const PlanElement* wall : unseen[r].walls)
      for (std::size_t o = 0; o < plan.rooms.size(); ++o)
        if (unseen[o].walls.empty() && isBehind(plan.rooms[o], room, *wall)) {
          length += wall->length();
          break;
        }
    is_beyond[r] = isMuch(length, room);
    if (!is_beyond[r])
      continue;
    char text[120];
    std::snprintf(text, sizeof text,
                  "room %u: %.2f m2 that were seen through an opening of another room "
                  "only are left out",
                  room.id, room.area());
    sentences.emplace_back(text);
  }
  std::size_t kept = 0;
  for (std::size_t r = 0; r < is_beyond.size(); ++r)
    if (!is_beyond[r]) {
      if (kept != r)
        plan.rooms[kept] = std::move(plan.rooms[r]);
      ++kept;
    }
  plan.rooms.resize(kept);
  return sentences;
}

} // namespace sedr
} // namespace pcl
