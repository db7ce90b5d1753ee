// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_segmentation/settled_rooms.h>

#include <pcl/sedr_filters/plan_evidence.h>
#include <pcl/sedr_segmentation/room_separation.h>
#include <pcl/sedr_segmentation/rooms_beyond_openings.h>

#include <algorithm>
#include <cstdint>
#include <set>

namespace pcl {
namespace sedr {

namespace {

std::set<std::uint32_t>
idsOf(const Floorplan& plan)
{
  std::set<std::uint32_t> ids;
  for (const PlanRoom& room : plan.rooms)
    ids.insert(room.id);
  return ids;
}

/** @brief Takes the rooms out of a plan that are in the one, but not in the other. */
void
leaveOut(Floorplan& plan,
         const std::set<std::uint32_t>& before,
         const std::set<std::uint32_t>& after)
{
  const auto isGone = [&](const PlanRoom& room) {
    return before.count(room.id) > after.count(room.id);
  };
  plan.rooms.erase(std::remove_if(plan.rooms.begin(), plan.rooms.end(), isGone),
                   plan.rooms.end());
}

} // namespace

std::vector<std::string>
settleRooms(Floorplan& plan,
            const PointView& points,
            const std::vector<int>& indices,
            unsigned threads)
{
  constexpr double tolerance = 0.05; // metres, of what lies on a wall
  std::vector<std::string> left_out;
  Floorplan fitted = plan;
  while (true) {
    std::vector<std::string> sentences = separateRooms(plan, points, indices);
    measureEvidence(plan, points, indices, tolerance, threads);
    const std::set<std::uint32_t> ids = idsOf(plan);
    const std::vector<std::string> beyond =
        dropRoomsBeyondOpenings(plan, points, indices);
    left_out.insert(left_out.end(), beyond.begin(), beyond.end());
    if (beyond.empty()) {
      sentences.insert(sentences.end(), left_out.begin(), left_out.end());
      return sentences;
    }
    const std::size_t before = fitted.rooms.size();
    leaveOut(fitted, ids, idsOf(plan));
    if (fitted.rooms.size() == before) { // ids that are not unique name none of them
      sentences.insert(sentences.end(), left_out.begin(), left_out.end());
      return sentences;
    }
    plan = fitted;
  }
}

} // namespace sedr
} // namespace pcl
