// SPDX-License-Identifier: BSD-3-Clause
#include "room_shares.h"

#include "../air/height_counts.h"
#include "../faces/room_cells.h"
#include "../rooms/room_gaps.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

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

template <typename Visitor>
void
forAllBeside(Cell cell, Visitor visit)
{
  for (const Cell beside : {Cell{cell.x - 1, cell.y}, Cell{cell.x + 1, cell.y},
                            Cell{cell.x, cell.y - 1}, Cell{cell.x, cell.y + 1}})
    visit(beside);
}

/** @brief Adds to the ceiling of each room the points of no ceiling or floor on which
 * it goes on from cell to cell, over more than a door's width and by a square metre: a
 * wall interrupts it for its thickness, what ends below it does not. What is less wide
 * than three cells may be the tops of walls. O(points). */
void
addCeilingsBeyond(const PointView& points,
                  const CellGrid& grid,
                  const PlanEvidence& evidence,
                  const Priors& priors,
                  std::vector<RoomEvidence>& rooms)
{
  std::vector<std::uint8_t> is_slab(points.size(), 0);
  for (const auto* list : {&evidence.ceiling, &evidence.details, &evidence.floor})
    for (const int i : *list)
      is_slab[static_cast<std::size_t>(i)] = 1;
  std::map<CellKey, std::vector<int>> others;
  for (const int i : evidence.all)
    if (const auto at = static_cast<std::size_t>(i);
        !is_slab[at] && points.isFinite(at) &&
        grid.holds(points[at].x(), points[at].y()))
      others[keyOf(grid.at(points[at].x(), points[at].y()))].push_back(i);
  for (RoomEvidence& room : rooms) {
    std::map<CellKey, float> heights;
    for (const auto* list : {&room.ceiling, &room.details})
      for (const int i : *list) {
        const Eigen::Vector3f p = points[static_cast<std::size_t>(i)];
        const auto cell = heights.emplace(keyOf(grid.at(p.x(), p.y())), p.z()).first;
        cell->second = std::max(cell->second, p.z());
      }
    std::vector<std::pair<CellKey, float>> next(heights.begin(), heights.end());
    std::map<CellKey, std::vector<int>> beyond;
    while (!next.empty()) {
      const auto [key, z] = next.back();
      next.pop_back();
      forAllBeside(cellOf(key), [&, z = z](Cell beside) {
        const auto found = others.find(keyOf(beside));
        if (found == others.end() || heights.count(found->first) > 0)
          return;
        std::vector<int> on;
        for (const int i : found->second)
          if (std::abs(points[static_cast<std::size_t>(i)].z() - z) <
              priors.min_ceiling_step)
            on.push_back(i);
        if (on.empty())
          return;
        const float height = points[static_cast<std::size_t>(on.front())].z();
        heights.emplace(found->first, height);
        next.emplace_back(found->first, height);
        beyond.emplace(found->first, std::move(on));
      });
    }
    const auto isBeyond = [&](Cell cell) { return beyond.count(keyOf(cell)) > 0; };
    std::set<CellKey> wide;
    for (const auto& [key, on] : beyond) {
      const Cell low = cellOf(key);
      bool is_wide = true;
      for (std::int32_t y = 0; y < 3; ++y)
        for (std::int32_t x = 0; x < 3; ++x)
          is_wide = is_wide && isBeyond({low.x + x, low.y + y});
      for (std::int32_t y = -1; is_wide && y < 4; ++y)
        for (std::int32_t x = -1; x < 4; ++x)
          wide.insert(keyOf({low.x + x, low.y + y}));
    }
    std::vector<CellKey> kept;
    for (const auto& [key, on] : beyond)
      if (wide.count(key) > 0)
        kept.push_back(key);
    const CellSet cells = CellSet::fromSorted(std::move(kept));
    const CellRegions regions = labelRegions(cells);
    std::vector<double> passed(regions.sizes.size(), 0); // metres of ceiling beside
    for (std::size_t k = 0; k < cells.size(); ++k)
      forAllBeside(cells[k], [&](Cell beside) {
        if (heights.count(keyOf(beside)) > 0 && !isBeyond(beside))
          passed[regions.label[k]] += grid.size();
      });
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const std::size_t region = regions.label[k];
      if (passed[region] < priors.max_door_width || // as through a gap
          static_cast<double>(regions.sizes[region]) * grid.size() * grid.size() <
              priors.min_slab_area)
        continue;
      const std::vector<int>& on = beyond[keyOf(cells[k])];
      room.ceiling.insert(room.ceiling.end(), on.begin(), on.end());
      others.erase(keyOf(cells[k]));
    }
  }
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
  addCeilingsBeyond(points, grid, evidence, parameters.priors, rooms);
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
