// SPDX-License-Identifier: BSD-3-Clause
#include "height_bends.h"

#include "../levels/level_relief.h"

#include "sedr_filters/src/base/exactness.h"
#include "sedr_filters/src/base/plane_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Heights of a cell's points above the main slab, metres. */
struct CellHeights {
  double sum = 0;
  double count = 0;
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double height)
  {
    sum += height;
    count += 1;
    low = std::min(low, height);
    high = std::max(high, height);
  }
};

/** @brief Records the relief of a ceiling in the cells of its room.
 * @return a mark per cell for steps */
std::vector<std::uint8_t>
noteRelief(const PointView& points,
           const SlabEvidence& evidence,
           const CellGrid& grid,
           HeightMap& map)
{
  const double max_spread = map.priors.surface_band; // a larger spread is a riser
  const CellMask& room = map.room;
  std::vector<CellHeights> seen(room.values().size());
  for (const auto* indices : {&evidence.main, &evidence.details})
    for (const int i : *indices) {
      const Eigen::Vector3f p = points[static_cast<std::size_t>(i)];
      const Cell cell = grid.at(p.x(), p.y());
      if (room.at(cell))
        seen[room.indexOf(cell)].add(distanceAbove(map.main, p));
    }
  const CellSet cells = room.toSet();
  std::vector<double> heights;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const CellHeights& of_cell = seen[room.indexOf(cells[k])];
    heights.push_back(of_cell.high - of_cell.low <= max_spread
                          ? of_cell.sum / of_cell.count
                          : unknown);
  }
  const std::vector<std::uint8_t> edges = cellsOfSteps(cells, heights, 1, map.priors);
  const std::vector<double> smooth = smoothRelief(cells, heights, 1);
  map.relief.assign(seen.size(), unknown);
  std::vector<std::uint8_t> steps(seen.size(), 0);
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const std::size_t at = room.indexOf(cells[k]);
    map.relief[at] = smooth[k];
    steps[at] = edges[k] != 0 || seen[at].high - seen[at].low > max_spread ? 1 : 0;
  }
  return steps;
}

/** @brief Common border of two labels. */
struct Meeting {
  double cells = 0; ///< edges between seen or step cells of the two
  double bends = 0; ///< edges without a step
  double drop = 0;  ///< sum of the height differences of the planes there, metres

  bool isBend() const { return 2 * bends > cells; }
};

using Meetings = std::vector<std::map<std::int32_t, Meeting>>;

/** @brief Two adjacent cells. */
using CellPair = std::pair<std::size_t, std::size_t>;

/** @brief Returns the labels grown into nearby unlabelled cells. */
std::vector<std::int32_t>
grownLabels(const HeightMap& map)
{
  const auto reach = static_cast<int>(map.priors.riser_cells);
  std::vector<std::int32_t> label = map.label;
  growLabels(map.room, reach, label);
  return label;
}

/** @brief Returns the adjacent cells of different labels that were seen or hold a step.
 */
std::vector<CellPair>
borderOf(const HeightMap& map,
         const std::vector<std::int32_t>& label,
         const std::vector<std::uint8_t>& steps)
{
  std::vector<CellPair> border;
  for (std::size_t i = 0; i < label.size(); ++i) {
    if (label[i] < 0)
      continue;
    const Cell cell = map.room.cellAt(i);
    for (const Cell d : {Cell{1, 0}, Cell{0, 1}}) {
      const Cell to{cell.x + d.x, cell.y + d.y};
      if (!map.room.at(to))
        continue;
      const std::size_t j = map.room.indexOf(to);
      if (label[j] >= 0 && label[j] != label[i] &&
          (steps[i] || steps[j] || !std::isnan(map.relief[i] - map.relief[j])))
        border.emplace_back(i, j);
    }
  }
  return border;
}

/** @brief Common borders of all labels, updated as labels are joined. */
class LabelMeetings {
public:
  /** @param label labels of the cells; O(cells) */
  LabelMeetings(const HeightMap& map,
                const CellGrid& grid,
                const std::vector<std::uint8_t>& steps,
                std::vector<std::int32_t> label)
      : map_(map)
      , grid_(grid)
      , steps_(steps)
      , label_(std::move(label))
      , border_(borderOf(map, label_, steps))
      , border_of_(map.details.size() + 1)
      , meetings_(map.details.size() + 1)
  {
    for (const CellPair& pair : border_) {
      for (const std::size_t at : {pair.first, pair.second})
        border_of_[static_cast<std::size_t>(label_[at])].push_back(pair);
      add(pair);
    }
  }

  const Meetings& all() const { return meetings_; }

  /** @brief Merges a label into another. O(its border). */
  void join(std::int32_t from, std::int32_t to)
  {
    auto& own = border_of_[static_cast<std::size_t>(from)];
    for (const auto& entry : meetings_[static_cast<std::size_t>(from)])
      meetings_[static_cast<std::size_t>(entry.first)].erase(from);
    meetings_[static_cast<std::size_t>(from)].clear();
    for (const CellPair& pair : own)
      for (const std::size_t at : {pair.first, pair.second})
        if (label_[at] == from)
          label_[at] = to;
    for (const CellPair& pair : own)
      add(pair);
    auto& joined = border_of_[static_cast<std::size_t>(to)];
    joined.insert(joined.end(), own.begin(), own.end());
    own.clear();
  }

private:
  void add(const CellPair& pair)
  {
    const auto [i, j] = pair;
    const std::int32_t a = label_[i];
    const std::int32_t b = label_[j];
    if (a == b)
      return;
    const double rise = std::abs(map_.relief[i] - map_.relief[j]);
    const Eigen::Vector2d place = grid_.centre(map_.room.cellAt(i));
    const double drop =
        std::abs(map_.slabOf(a).heightAt(place) - map_.slabOf(b).heightAt(place));
    const bool is_bend = !steps_[i] && !steps_[j] &&
                         (drop < map_.priors.min_floor_step || 2 * rise < drop);
    for (const auto& [from, other] : {std::pair{a, b}, std::pair{b, a}}) {
      Meeting& meeting = meetings_[static_cast<std::size_t>(from)][other];
      meeting.cells += 1;
      meeting.bends += is_bend ? 1 : 0;
      meeting.drop += drop;
    }
  }

  const HeightMap& map_;
  const CellGrid& grid_;
  const std::vector<std::uint8_t>& steps_;
  std::vector<std::int32_t> label_;
  std::vector<CellPair> border_;
  std::vector<std::vector<CellPair>> border_of_; ///< of each label
  Meetings meetings_;
};

/** @brief Returns the label to merge a sliver with, -1 if none is close. It must share
 * at least a quarter of the border, mostly without a step; the nearest in height wins.
 */
std::int32_t
besideSliver(const std::map<std::int32_t, Meeting>& meetings, const Priors& priors)
{
  double around = 0;
  for (const auto& [other, meeting] : meetings)
    around += meeting.cells;
  double least = priors.min_floor_step;
  std::int32_t beside = -1;
  for (const auto& [other, meeting] : meetings) {
    const double drop = meeting.drop / meeting.cells;
    if (4 * meeting.cells < around || !meeting.isBend() || drop >= least)
      continue;
    least = drop;
    beside = other;
  }
  return beside;
}

/** @brief Merges slivers with their neighbours, the smallest first.
 * @return the borders of the remaining labels */
Meetings
joinSlivers(const std::vector<std::uint8_t>& steps,
            const CellGrid& grid,
            HeightMap& map)
{
  // The grown cells do not depend on the merges, so they are computed once.
  LabelMeetings meetings(map, grid, steps, grownLabels(map));
  std::vector<double> area(map.details.size() + 1, 0);
  for (const std::int32_t l : map.label)
    if (l >= 0)
      area[static_cast<std::size_t>(l)] += grid.size() * grid.size();
  std::vector<std::int32_t> now(area.size()); // current label of each original one
  std::iota(now.begin(), now.end(), 0);
  for (bool has_changed = true; has_changed;) {
    has_changed = false;
    double least = map.priors.min_slab_area;
    std::pair<std::int32_t, std::int32_t> join;
    for (std::size_t l = 1; l < area.size(); ++l) {
      const std::int32_t beside = area[l] > 0 && area[l] < least
                                      ? besideSliver(meetings.all()[l], map.priors)
                                      : -1;
      if (beside < 0)
        continue;
      least = area[l];
      join = {static_cast<std::int32_t>(l), beside};
      has_changed = true;
    }
    if (!has_changed)
      break;
    const auto [from, to] = join;
    meetings.join(from, to);
    std::replace(now.begin(), now.end(), from, to);
    area[static_cast<std::size_t>(to)] += area[static_cast<std::size_t>(from)];
    area[static_cast<std::size_t>(from)] = 0;
  }
  for (std::int32_t& l : map.label)
    if (l >= 0)
      l = now[static_cast<std::size_t>(l)];
  return meetings.all();
}

/** @brief Returns the nearby label whose plane is closest to the relief of a cell. */
std::int32_t
nearestLabel(const HeightMap& map, const CellGrid& grid, std::size_t at)
{
  constexpr int reach = 2; // cells
  const Cell cell = map.room.cellAt(at);
  const Eigen::Vector2d place = grid.centre(cell);
  const double height = map.main.heightAt(place) + map.relief[at];
  const auto distance = [&](std::int32_t l) {
    return std::abs(map.slabOf(l).heightAt(place) - height);
  };
  const std::int32_t own = map.label[at];
  std::int32_t nearest = own;
  double least =
      nearest < 0 ? std::numeric_limits<double>::infinity() : distance(nearest);
  for (int dy = -reach; dy <= reach; ++dy)
    for (int dx = -reach; dx <= reach; ++dx) {
      const Cell near{cell.x + dx, cell.y + dy};
      const std::int32_t l = map.room.at(near) ? map.label[map.room.indexOf(near)] : -1;
      if (l < 0 || l == nearest || (own >= 0 && map.bends.count({own, l}) == 0))
        continue;
      const double d = distance(l);
      if (d < least) {
        least = d;
        nearest = l;
      }
    }
  return nearest;
}

/** @brief Relabels the cells without a step by their heights. */
void
followHeights(const std::vector<std::uint8_t>& steps,
              const CellGrid& grid,
              HeightMap& map)
{
  constexpr int max_rounds = 20;
  for (int round = 0; round < max_rounds; ++round) {
    std::vector<std::int32_t> next = map.label;
    for (std::size_t i = 0; i < next.size(); ++i)
      if (map.room.values()[i] && !std::isnan(map.relief[i]) &&
          (map.label[i] >= 0 || !steps[i]))
        next[i] = nearestLabel(map, grid, i);
    if (next == map.label)
      return;
    map.label = std::move(next);
  }
}

/** @brief Keeps only the largest region of each detail. */
void
keepLargestParts(HeightMap& map)
{
  const std::vector<CellBox> boxes = boxesOf(map);
  for (std::size_t l = 1; l <= map.details.size(); ++l) {
    const CellMask cells = cellsOf(map, static_cast<std::int32_t>(l), boxes[l]);
    const MaskRegions regions = labelRegions(cells, true);
    const auto largest = std::max_element(regions.sizes.begin(), regions.sizes.end()) -
                         regions.sizes.begin();
    for (std::size_t i = 0; i < regions.label.size(); ++i)
      if (regions.label[i] >= 0 && regions.label[i] != largest)
        map.label[map.room.indexOf(cells.cellAt(i))] = -1;
  }
}

} // namespace

void
tidyBends(const PointView& points,
          const SlabEvidence& evidence,
          const CellGrid& grid,
          HeightMap& map)
{
  if (map.details.empty())
    return;
  const std::vector<std::uint8_t> steps = noteRelief(points, evidence, grid, map);
  const Meetings meetings = joinSlivers(steps, grid, map);
  for (std::size_t l = 0; l < meetings.size(); ++l)
    for (const auto& [other, meeting] : meetings[l])
      if (meeting.isBend())
        map.bends.insert({static_cast<std::int32_t>(l), other});
  if (map.bends.empty())
    return;
  followHeights(steps, grid, map);
  keepLargestParts(map);
}

} // namespace pcl::sedr
