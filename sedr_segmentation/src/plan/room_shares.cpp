// SPDX-License-Identifier: BSD-3-Clause
#include "room_shares.h"

#include "../air/height_counts.h"
#include "../faces/room_cells.h"
#include "../rooms/room_gaps.h"

#include <algorithm>
#include <map>

namespace pcl::sedr {

namespace {

/** @brief Returns the gaps of a room: from its ceiling, as high as in each cell, down
 * to its lowest floor that is as large as a pit; without floor points it is as high as
 * usual.
 * @param room its number */
void
appendGaps(const PointView& points,
           const CellGrid& grid,
           const RoomEvidence& evidence,
           double pit,
           std::uint32_t room,
           std::vector<RoomGap>& gaps)
{
  std::map<CellKey, float> top;
  const auto add = [&](const Eigen::Vector3f& p) {
    const auto cell = top.emplace(keyOf(grid.at(p.x(), p.y())), p.z()).first;
    cell->second = std::max(cell->second, p.z());
  };
  for (const auto* part : {&evidence.ceiling, &evidence.details})
    for (const int i : *part)
      add(points[static_cast<std::size_t>(i)]);
  for (const Eigen::Vector3f& place : evidence.hidden.ceiling)
    add(place);
  if (top.empty())
    return;
  HeightCounts lows;
  for (const int i : evidence.floor)
    lows.add(points[static_cast<std::size_t>(i)].z());
  const double area =
      static_cast<double>(CellSet(grid, points, evidence.floor).size()) * grid.size() *
      grid.size();
  const double lowest =
      std::min_element(top.begin(), top.end(), [](const auto& a, const auto& b) {
        return a.second < b.second;
      })->second;
  const double floor = lows.empty() ? lowest - usual_height : lows.lowestOf(pit / area);
  for (const auto& [cell, high] : top)
    gaps.push_back({cellOf(cell), room, static_cast<float>(floor), high,
                    static_cast<float>(floor)});
}

} // namespace

std::vector<std::uint32_t>
roomNumbers(const PlanEvidence& evidence)
{
  if (evidence.room.empty())
    return {1};
  std::vector<std::uint32_t> numbers;
  for (const int i : evidence.ceiling)
    if (evidence.room[static_cast<std::size_t>(i)] != 0)
      numbers.push_back(evidence.room[static_cast<std::size_t>(i)]);
  for (const auto& [number, cells] : evidence.hidden)
    if (!cells.ceiling.empty())
      numbers.push_back(number);
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

std::vector<int>
seenPoints(const PointView& points,
           const CellGrid& grid,
           const std::vector<int>& indices,
           bool is_floor)
{
  // Metres: more than the steepest slope rises in a cell.
  const auto step = static_cast<float>(2 * grid.size());
  const float sign = is_floor ? -1 : 1;
  std::map<CellKey, float> nearest;
  const auto forAll = [&](auto use) {
    for (const int i : indices)
      if (const auto at = static_cast<std::size_t>(i);
          points.isFinite(at) && grid.holds(points[at].x(), points[at].y()))
        use(i, keyOf(grid.at(points[at].x(), points[at].y())), sign * points[at].z());
  };
  forAll([&](int, CellKey cell, float z) {
    const auto known = nearest.emplace(cell, z).first;
    known->second = std::min(known->second, z);
  });
  std::vector<int> seen;
  forAll([&](int i, CellKey cell, float z) {
    if (z < nearest[cell] + step)
      seen.push_back(i);
  });
  return seen;
}

std::vector<RoomEvidence>
roomEvidence(const PointView& points,
             const PlanEvidence& evidence,
             const std::vector<std::uint32_t>& numbers,
             const RoomFitParameters& parameters)
{
  const CellGrid grid(parameters.cell_size);
  std::vector<RoomEvidence> rooms(numbers.size());
  const auto roomOf = [&](std::uint32_t number) -> RoomEvidence* {
    const auto it = std::lower_bound(numbers.begin(), numbers.end(), number);
    return it != numbers.end() && *it == number
               ? &rooms[static_cast<std::size_t>(it - numbers.begin())]
               : nullptr;
  };
  const auto labelled = [&](int i) -> RoomEvidence* {
    const Eigen::Vector3f p = points[static_cast<std::size_t>(i)];
    if (!points.isFinite(static_cast<std::size_t>(i)) || !grid.holds(p.x(), p.y()))
      return nullptr;
    return evidence.room.empty() ? &rooms.front()
                                 : roomOf(evidence.room[static_cast<std::size_t>(i)]);
  };
  const auto share = [&](const std::vector<int>& indices, auto list, auto ownerOf) {
    for (const int i : indices)
      if (RoomEvidence* const room = ownerOf(i))
        (room->*list).push_back(i);
  };
  share(evidence.ceiling, &RoomEvidence::ceiling, labelled);
  share(evidence.details, &RoomEvidence::details, labelled);
  share(evidence.floor, &RoomEvidence::floor, labelled);
  for (std::size_t r = 0; r < rooms.size(); ++r) {
    std::vector<int> both = rooms[r].ceiling;
    both.insert(both.end(), rooms[r].details.begin(), rooms[r].details.end());
    rooms[r].sheets = seenPoints(points, grid, both, false);
    if (const auto known = evidence.hidden.find(numbers[r]);
        known != evidence.hidden.end())
      rooms[r].hidden = known->second;
  }
  std::vector<PointOwner> found;
  if (evidence.owners.empty()) {
    std::vector<RoomGap> gaps;
    for (std::size_t r = 0; r < rooms.size(); ++r)
      appendGaps(points, grid, rooms[r], parameters.minimum_detail_area, numbers[r],
                 gaps);
    found =
        RoomGaps(grid, gaps, parameters.priors).ownersOf(points, parameters.threads);
  }
  const std::vector<PointOwner>& owners =
      evidence.owners.empty() ? found : evidence.owners;
  const auto owned = [&](int i) -> RoomEvidence* {
    const PointOwner& owner = owners[static_cast<std::size_t>(i)];
    return owner.beyond ? nullptr : roomOf(owner.room);
  };
  share(evidence.floor, &RoomEvidence::floor,
        [&](int i) { return labelled(i) ? nullptr : owned(i); });
  share(evidence.all, &RoomEvidence::around, owned);
  if (evidence.walls.empty())
    for (RoomEvidence& room : rooms)
      room.walls = room.around;
  else
    share(evidence.walls, &RoomEvidence::walls, owned);
  return rooms;
}

} // namespace pcl::sedr
