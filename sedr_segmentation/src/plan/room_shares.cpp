// SPDX-License-Identifier: BSD-3-Clause
#include "room_shares.h"

#include "../air/height_counts.h"
#include "../faces/room_cells.h"
#include "../rooms/room_gaps.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Returns the heights of the ceiling of a room, the highest in each cell. */
std::map<CellKey, float>
ceilingHeights(const PointView& points, const CellGrid& grid, const RoomEvidence& room)
{
  std::map<CellKey, float> heights;
  const auto add = [&](const Eigen::Vector3f& p) {
    const auto cell = heights.emplace(keyOf(grid.at(p.x(), p.y())), p.z()).first;
    cell->second = std::max(cell->second, p.z());
  };
  for (const auto* part : {&room.ceiling, &room.details})
    for (const int i : *part)
      add(points[static_cast<std::size_t>(i)]);
  for (const Eigen::Vector3f& place : room.hidden.ceiling)
    add(place);
  return heights;
}

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
  const std::map<CellKey, float> top = ceilingHeights(points, grid, evidence);
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

using PointsOfCells = std::map<CellKey, std::vector<int>>;

template <typename Visitor>
void
forAllBeside(Cell cell, Visitor visit)
{
  for (const Cell beside : {Cell{cell.x - 1, cell.y}, Cell{cell.x + 1, cell.y},
                            Cell{cell.x, cell.y - 1}, Cell{cell.x, cell.y + 1}})
    visit(beside);
}

/** @brief Calls `visit` for the square of cells up to `reach` cells from one. */
template <typename Visitor>
void
forAllAround(Cell cell, std::int32_t reach, Visitor visit)
{
  for (std::int32_t y = -reach; y <= reach; ++y)
    for (std::int32_t x = -reach; x <= reach; ++x)
      visit(Cell{cell.x + x, cell.y + y});
}

/** @brief Returns the points of `others` on which a ceiling goes on from cell to cell,
 * at the height that is nearest to that of the cell before. */
PointsOfCells
pointsBeyond(const PointView& points,
             const PointsOfCells& others,
             std::map<CellKey, float> heights,
             double step)
{
  PointsOfCells beyond;
  std::vector<std::pair<CellKey, float>> next(heights.begin(), heights.end());
  while (!next.empty()) {
    const auto [key, z] = next.back();
    next.pop_back();
    forAllBeside(cellOf(key), [&, z = z](Cell beside) {
      const auto found = others.find(keyOf(beside));
      if (found == others.end() || heights.count(found->first) > 0)
        return;
      std::vector<int> on;
      float height = std::numeric_limits<float>::infinity();
      for (const int i : found->second) {
        const float at = points[static_cast<std::size_t>(i)].z();
        if (std::abs(at - z) >= step)
          continue;
        on.push_back(i);
        if (std::abs(at - z) < std::abs(height - z))
          height = at;
      }
      if (on.empty())
        return;
      heights.emplace(found->first, height);
      next.emplace_back(found->first, height);
      beyond.emplace(found->first, std::move(on));
    });
  }
  return beyond;
}

/** @brief Returns the parts that are three cells wide or more, without the rest, which
 * may be the tops of walls. */
CellSet
wideParts(const PointsOfCells& cells)
{
  std::set<CellKey> wide;
  for (const auto& [key, on] : cells) {
    bool is_wide = true;
    forAllAround(cellOf(key), 1,
                 [&](Cell cell) { is_wide = is_wide && cells.count(keyOf(cell)) > 0; });
    if (is_wide)
      forAllAround(cellOf(key), 2, [&](Cell cell) {
        if (cells.count(keyOf(cell)) > 0)
          wide.insert(keyOf(cell));
      });
  }
  return CellSet::fromSorted({wide.begin(), wide.end()});
}

/** @brief Adds to the ceiling of each room the points of no ceiling or floor on which
 * it goes on from cell to cell, over more than a door's width and by a square metre: a
 * wall interrupts it for its thickness, what ends below it does not. What lies beside
 * several rooms is the ceiling of the one beside which most of it lies. O(points log
 * points) for each room beside them. */
void
addCeilingsBeyond(const PointView& points,
                  const CellGrid& grid,
                  const PlanEvidence& evidence,
                  const Priors& priors,
                  std::vector<RoomEvidence>& rooms)
{
  std::vector<std::uint8_t> is_taken(points.size(), 0);
  for (const auto* list : {&evidence.ceiling, &evidence.details, &evidence.floor})
    for (const int i : *list)
      is_taken[static_cast<std::size_t>(i)] = 1;
  PointsOfCells others;
  for (const int i : evidence.all)
    if (const auto at = static_cast<std::size_t>(i);
        is_taken[at] == 0 && points.isFinite(at) &&
        grid.holds(points[at].x(), points[at].y()))
      others[keyOf(grid.at(points[at].x(), points[at].y()))].push_back(i);
  struct Part {
    std::size_t room;
    double passed = 0; // metres beside the ceiling of the room
    std::size_t cells = 0;
    std::vector<int> on{};
  };
  std::vector<Part> parts;
  for (std::size_t r = 0; r < rooms.size(); ++r) {
    const auto heights = ceilingHeights(points, grid, rooms[r]);
    const PointsOfCells beyond =
        pointsBeyond(points, others, heights, priors.min_ceiling_step);
    const CellSet cells = wideParts(beyond);
    const CellRegions regions = labelRegions(cells);
    std::vector<Part> of_room(regions.sizes.size(), {r});
    for (std::size_t k = 0; k < cells.size(); ++k) {
      Part& part = of_room[regions.label[k]];
      const std::vector<int>& on = beyond.at(cells.keys()[k]);
      part.on.insert(part.on.end(), on.begin(), on.end());
      ++part.cells;
      forAllBeside(cells[k], [&](Cell beside) {
        part.passed += heights.count(keyOf(beside)) > 0 ? grid.size() : 0;
      });
    }
    for (Part& part : of_room)
      if (part.passed >= priors.max_door_width && // not as through a gap
          static_cast<double>(part.cells) * grid.size() * grid.size() >=
              priors.min_slab_area)
        parts.push_back(std::move(part));
  }
  std::stable_sort(parts.begin(), parts.end(),
                   [](const Part& a, const Part& b) { return a.passed > b.passed; });
  for (const Part& part : parts)
    for (const int i : part.on)
      if (std::uint8_t& taken = is_taken[static_cast<std::size_t>(i)]; taken == 0) {
        rooms[part.room].ceiling.push_back(i);
        taken = 1;
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
