// SPDX-License-Identifier: BSD-3-Clause
#include "plan_geometry.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

namespace pcl::sedr {
namespace {

/** @brief Returns the overlap of two ranges as a share of the shorter one. */
double
commonShare(const RoomHeights& a, const RoomHeights& b)
{
  const double common = std::min(a.high, b.high) - std::max(a.low, b.low);
  const double lower = std::min(a.high - a.low, b.high - b.low);
  return common > 0 && lower > 0 ? common / lower : 0;
}

bool
isListed(const std::vector<std::uint32_t>& ids, std::uint32_t id)
{
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

/** @brief Sets the heights of a storey from its rooms, and sorts the rooms. */
void
complete(PlanStorey& storey,
         const Floorplan& plan,
         const std::vector<RoomHeights>& heights)
{
  storey.floor = std::numeric_limits<double>::infinity();
  storey.ceiling = -storey.floor;
  for (std::size_t r = 0; r < plan.rooms.size(); ++r)
    if (isListed(storey.rooms, plan.rooms[r].id)) {
      storey.floor = std::min(storey.floor, heights[r].low);
      storey.ceiling = std::max(storey.ceiling, heights[r].high);
    }
  std::sort(storey.rooms.begin(), storey.rooms.end());
}

PlanStorey&
nearestOf(std::vector<PlanStorey>& storeys, double floor)
{
  return *std::min_element(storeys.begin(), storeys.end(),
                           [floor](const PlanStorey& a, const PlanStorey& b) {
                             return std::abs(a.floor - floor) <
                                    std::abs(b.floor - floor);
                           });
}

/** @brief Returns the storeys listed in a plan, reduced to its rooms. */
std::vector<PlanStorey>
namedStoreys(const Floorplan& plan, const std::vector<RoomHeights>& heights)
{
  std::vector<PlanStorey> storeys = plan.storeys;
  for (PlanStorey& storey : storeys)
    storey.rooms.clear();
  for (std::size_t r = 0; r < plan.rooms.size(); ++r) {
    const std::uint32_t id = plan.rooms[r].id;
    const auto listing = std::find_if(
        plan.storeys.begin(), plan.storeys.end(),
        [id](const PlanStorey& storey) { return isListed(storey.rooms, id); });
    if (listing != plan.storeys.end())
      storeys[static_cast<std::size_t>(listing - plan.storeys.begin())].rooms.push_back(
          id);
    else
      nearestOf(storeys, heights[r].low).rooms.push_back(id);
  }
  storeys.erase(std::remove_if(storeys.begin(), storeys.end(),
                               [](const PlanStorey& s) { return s.rooms.empty(); }),
                storeys.end());
  for (PlanStorey& storey : storeys)
    complete(storey, plan, heights);
  return storeys;
}

} // namespace

std::vector<PlanStorey>
storeysOf(std::vector<RoomLevel> rooms, double step)
{
  std::stable_sort(
      rooms.begin(), rooms.end(),
      [](const RoomLevel& a, const RoomLevel& b) { return a.floor < b.floor; });
  std::vector<PlanStorey> storeys;
  double mean = 0; // of the floors of the last storey
  double area = 0;
  for (const RoomLevel& room : rooms) {
    if (storeys.empty() || room.floor >= mean + step) {
      const auto number = static_cast<std::uint32_t>(storeys.size() + 1);
      storeys.push_back({number, storeyName(number), room.floor, room.ceiling, {}});
      mean = room.floor;
      area = 0;
    }
    area += room.area;
    mean += area > 0 ? (room.floor - mean) * room.area / area : 0;
    storeys.back().ceiling = std::max(storeys.back().ceiling, room.ceiling);
    storeys.back().rooms.push_back(room.id);
  }
  for (PlanStorey& storey : storeys)
    std::sort(storey.rooms.begin(), storey.rooms.end());
  return storeys;
}

RoomHeights
heightsOf(const PlanRoom& room)
{
  const Eigen::AlignedBox2d box = boundsOf(room.boundary);
  const Eigen::Vector2d middle =
      box.isEmpty() ? Eigen::Vector2d(0, 0) : Eigen::Vector2d(box.center());
  // A vault ends at its side lines: beside it is another facet.
  return {room.floor.heightAt(middle),
          room.ceiling.curve ? room.ceilingAt(middle) : room.ceiling.heightAt(middle)};
}

std::vector<RoomHeights>
heightsOf(const Floorplan& plan)
{
  std::vector<RoomHeights> heights;
  for (const PlanRoom& room : plan.rooms)
    heights.push_back(heightsOf(room));
  return heights;
}

bool
shareHeights(const RoomHeights& a, const RoomHeights& b)
{
  constexpr double forgiven = 0.25;
  return commonShare(a, b) > forgiven;
}

bool
shareHeights(const PlanRoom& a, const PlanRoom& b)
{
  return shareHeights(heightsOf(a), heightsOf(b));
}

std::vector<const PlanRoom*>
roomsAt(const Floorplan& plan, const RoomHeights& heights)
{
  std::vector<const PlanRoom*> rooms;
  for (const PlanRoom& room : plan.rooms)
    if (shareHeights(heightsOf(room), heights))
      rooms.push_back(&room);
  return rooms;
}

std::vector<PlanStorey>
storeysOf(const Floorplan& plan)
{
  const std::vector<RoomHeights> heights = heightsOf(plan);
  if (!plan.storeys.empty())
    return namedStoreys(plan, heights);
  std::vector<RoomLevel> levels;
  for (std::size_t r = 0; r < plan.rooms.size(); ++r)
    levels.push_back(
        {plan.rooms[r].id, heights[r].low, heights[r].high, plan.rooms[r].area()});
  return storeysOf(std::move(levels));
}

std::map<std::uint32_t, std::uint32_t>
storeyOfRooms(const Floorplan& plan)
{
  std::map<std::uint32_t, std::uint32_t> numbers;
  for (const PlanStorey& storey : storeysOf(plan))
    for (const std::uint32_t room : storey.rooms)
      numbers[room] = storey.number;
  return numbers;
}

double
usualFloor(const Floorplan& plan, const PlanStorey& storey)
{
  std::map<double, double> areas; // by height
  double half = 0;
  for (const std::uint32_t id : storey.rooms) {
    const PlanRoom& room = *findRoom(plan, id);
    areas[heightsOf(room).low] += room.area();
    half += room.area() / 2;
  }
  auto floor = areas.begin();
  for (; half > floor->second && std::next(floor) != areas.end(); ++floor)
    half -= floor->second;
  return floor->first;
}

Floorplan
partOf(const Floorplan& plan, const PlanStorey& storey)
{
  const auto touches = [&storey](const auto& link) {
    return isListed(storey.rooms, link.rooms[0]) ||
           isListed(storey.rooms, link.rooms[1]);
  };
  Floorplan part;
  for (const PlanRoom& room : plan.rooms)
    if (isListed(storey.rooms, room.id))
      part.rooms.push_back(room);
  part.storeys = {storey};
  std::copy_if(plan.stairs.begin(), plan.stairs.end(), std::back_inserter(part.stairs),
               touches);
  std::copy_if(plan.openings.begin(), plan.openings.end(),
               std::back_inserter(part.openings), touches);
  return part;
}

void
numberOpenings(Floorplan& plan)
{
  std::array<std::uint32_t, 4> last{};                           // of each kind
  std::map<std::uint32_t, std::vector<PlanOpening*>> unnumbered; // by storey
  const std::map<std::uint32_t, std::uint32_t> storeys = storeyOfRooms(plan);
  for (PlanOpening& opening : plan.openings) {
    std::uint32_t& largest = last[static_cast<std::size_t>(opening.kind)];
    largest = std::max(largest, opening.number);
    std::uint32_t lowest = std::numeric_limits<std::uint32_t>::max();
    for (const std::uint32_t room : opening.rooms)
      if (const auto storey = storeys.find(room); storey != storeys.end())
        lowest = std::min(lowest, storey->second);
    if (opening.number == 0)
      unnumbered[lowest].push_back(&opening);
  }
  for (const auto& [storey, openings] : unnumbered)
    for (PlanOpening* opening : openings)
      opening->number = ++last[static_cast<std::size_t>(opening->kind)];
}

std::string
storeyName(std::uint32_t number)
{
  return "storey " + std::to_string(number);
}

} // namespace pcl::sedr
