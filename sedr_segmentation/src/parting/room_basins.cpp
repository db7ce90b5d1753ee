// SPDX-License-Identifier: BSD-3-Clause
#include "room_parting.h"

#include "../air/air_gaps.h"
#include "../air/air_measures.h"
#include "room_labels.h"

#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/grids/disjoint_sets.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl::sedr {

namespace {

constexpr std::size_t rim_gaps_a_block = 16384;
constexpr int directions = 16; // of half a turn

class JambLines {
public:
  JambLines(const AirGaps& air,
            const std::vector<float>& distance,
            const PartingParameters& parameters)
      : air_(air)
      , distance_(distance)
      , cell_(air.columns().cellSize())
      , longest_(parameters.widest_door / cell_)
      , thickness_(static_cast<int>(std::lround(parameters.thickest_wall / cell_)))
  {}

  std::vector<std::uint8_t> find() const
  {
    // Of each gap the direction in which it is in the middle of such a line.
    std::vector<std::int8_t> line(air_.size(), -1);
    parallelBlocks(air_.size(), rim_gaps_a_block, air_.parameters().threads,
                   [&](std::size_t begin, std::size_t end) {
                     for (std::size_t g = begin; g < end; ++g)
                       line[g] = lineThrough(static_cast<std::uint32_t>(g));
                   });
    std::vector<std::uint8_t> is_on_line(air_.size(), 0);
    for (std::uint32_t g = 0; g < air_.size(); ++g)
      if (line[g] >= 0)
        for (const double side : {-1.0, 1.0})
          mark(g, side * along(line[g]), is_on_line);
    return is_on_line;
  }

private:
  Eigen::Vector2d along(int direction) const
  {
    const double angle = M_PI * direction / directions;
    return {cell_ * std::cos(angle), cell_ * std::sin(angle)};
  }

  /** @brief How many steps one goes from a place until the air ends, at most `most`. */
  int stepsFrom(const Eigen::Vector2d& place,
                const Eigen::Vector2d& step,
                int most,
                std::uint32_t like) const
  {
    int n = 0;
    while (n < most && air_.gapAt(place + (n + 1) * step, air_[like]) != AirGaps::none)
      ++n;
    return n;
  }

  /** @brief The direction of the jamb line in whose middle a gap is, or -1: the
   * shortest of all lines through it. */
  std::int8_t lineThrough(std::uint32_t g) const
  {
    const double half = distance_[g];
    if (half <= 0 || 2 * half > longest_ + 1)
      return -1;
    const Eigen::Vector2d place = air_.placeOf(g);
    const int reach = static_cast<int>(std::ceil(half)) + 1;
    const int longest = static_cast<int>(longest_);
    std::array<int, directions> steps{};
    int fewest = longest;
    for (int k = 0; k < directions; ++k) {
      const int a = stepsFrom(place, along(k), reach, g);
      const int b = a == reach ? reach : stepsFrom(place, -along(k), reach, g);
      const bool is_middle = std::max(a, b) < reach && std::abs(a - b) <= 1;
      steps[static_cast<std::size_t>(k)] = is_middle ? a + b : longest + 1;
      fewest = std::min(fewest, steps[static_cast<std::size_t>(k)]);
    }
    for (int k = 0; k < directions; ++k)
      if (steps[static_cast<std::size_t>(k)] == fewest &&
          isFromWallToWall(g, along(k)) && isWiderOnBothSides(g, along(k), fewest))
        return static_cast<std::int8_t>(k);
    return -1;
  }

  bool isFromWallToWall(std::uint32_t g, const Eigen::Vector2d& step) const
  {
    const Eigen::Vector2d place = air_.placeOf(g);
    const auto isWallBehind = [&](const Eigen::Vector2d& way) {
      const int n = stepsFrom(place, way, static_cast<int>(longest_), g);
      return isWallAt(air_, air_.columnAt(place + (n + 1) * way), air_[g]);
    };
    return isWallBehind(step) && isWallBehind(-step);
  }

  bool
  isWiderOnBothSides(std::uint32_t g, const Eigen::Vector2d& step, int length) const
  {
    const Eigen::Vector2d across(-step.y(), step.x());
    const int front = stepsToWider(g, step, across, length);
    return front <= thickness_ &&
           front + stepsToWider(g, step, -across, length) <= thickness_ + 2;
  }

  /** @brief How far to go across a line until the air is wider by more than a wall is
   * thick, as no niche and no window beside a pier is deep. */
  int stepsToWider(std::uint32_t g,
                   const Eigen::Vector2d& step,
                   const Eigen::Vector2d& across,
                   int length) const
  {
    const int wide = length + thickness_ + 1;
    for (int away = 1; away <= thickness_ + 1; ++away) {
      const Eigen::Vector2d place = air_.placeOf(g) + away * across;
      if (air_.gapAt(place, air_[g]) == AirGaps::none)
        break;
      if (stepsFrom(place, step, wide, g) + stepsFrom(place, -step, wide, g) >= wide)
        return away;
    }
    return 2 * thickness_ + 2;
  }

  /** @brief Marks the gaps from one in a direction to where the air ends, and beside
   * them those that a step over a corner would touch. */
  void mark(std::uint32_t g,
            const Eigen::Vector2d& step,
            std::vector<std::uint8_t>& is_on_line) const
  {
    constexpr int parts = 4; // of a step: a line without gaps at its corners
    const Eigen::Vector2d place = air_.placeOf(g);
    for (int k = 0;; ++k) {
      const std::uint32_t o = air_.gapAt(place + k * step / parts, air_[g]);
      if (o == AirGaps::none)
        return;
      is_on_line[o] = 1;
    }
  }

  const AirGaps& air_;
  const std::vector<float>& distance_;
  double cell_;
  double longest_; ///< columns, likewise below
  int thickness_;
};

/** @brief Lines from jamb to jamb in doorways without a lintel: straight, no longer
 * than the widest door, from wall to wall, and within a wall's thickness the air is
 * wider on both sides. So a doorway to a corridor is found however narrow the corridor
 * is.
 * @param distance of each gap from the rim of what may be crossed, in columns, see
 *        distanceToRim(); 0 elsewhere
 * @return 1 for the gaps on such lines. O(gaps) times a door's width. */
std::vector<std::uint8_t>
jambLines(const AirGaps& air,
          const std::vector<float>& distance,
          const PartingParameters& parameters)
{
  return JambLines(air, distance, parameters).find();
}

constexpr std::int32_t no_room = RoomLabels::no_room;

/** @brief Basins of the distance from the rim, from their middles outwards, which end
 * at jamb lines. */
std::vector<std::int32_t>
basinsOf(const AirGaps& air,
         const std::vector<float>& distance,
         const std::vector<std::uint8_t>& is_jamb_line,
         double same_basin)
{
  std::vector<std::uint32_t> order;
  for (std::uint32_t g = 0; g < air.size(); ++g)
    if (distance[g] > 0 && is_jamb_line[g] == 0)
      order.push_back(g);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return distance[a] > distance[b];
  });
  std::vector<std::int32_t> basin(air.size(), no_room);
  std::vector<float> peak; // falls: of several basins the first is the highest
  DisjointSets<> sets(order.size());
  for (const std::uint32_t g : order) {
    std::vector<std::uint32_t> met;
    std::uint32_t uphill =
        AirGaps::none; // towards its own middle, not into what is larger
    for (int d = 0; d < 4; ++d)
      for (const std::uint32_t o : {air.next(g, d), air.diagonal(g, d)})
        if (o != AirGaps::none && basin[o] != no_room) {
          met.push_back(sets.find(static_cast<std::uint32_t>(basin[o])));
          if (uphill == AirGaps::none || distance[o] > distance[uphill])
            uphill = o;
        }
    if (met.empty()) {
      basin[g] = static_cast<std::int32_t>(peak.size());
      peak.push_back(distance[g]);
      continue;
    }
    basin[g] = basin[uphill];
    const std::uint32_t highest = *std::min_element(met.begin(), met.end());
    for (const std::uint32_t other : met)
      if (distance[g] >= same_basin * peak[other])
        sets.join(highest, other);
  }
  for (std::int32_t& b : basin)
    if (b != no_room)
      b = static_cast<std::int32_t>(sets.find(static_cast<std::uint32_t>(b)));
  return basin;
}

/** @brief Takes labels outwards, step by step, to gaps that have none and are not to be
 * left out. */
void
growLabels(const AirGaps& air,
           const std::vector<std::uint8_t>& is_left_out,
           std::vector<std::int32_t>& label)
{
  std::vector<std::uint32_t> front;
  for (std::uint32_t g = 0; g < air.size(); ++g)
    if (label[g] != no_room)
      front.push_back(g);
  while (!front.empty()) {
    std::vector<std::uint32_t> next;
    for (const std::uint32_t g : front)
      for (int d = 0; d < 4; ++d) {
        const std::uint32_t o = air.next(g, d);
        if (o != AirGaps::none && label[o] == no_room && is_left_out[o] == 0) {
          label[o] = label[g];
          next.push_back(o);
        }
      }
    front = std::move(next);
  }
}

} // namespace

std::vector<std::int32_t>
roomBasins(const AirGaps& air,
           const std::vector<float>& dip,
           const PartingParameters& parameters)
{
  const std::vector<std::uint8_t> is_jamb_line =
      jambLines(air, distanceToRim(air), parameters);
  std::vector<std::int32_t> label =
      basinsOf(air, distanceToLintel(air, dip, parameters.lintel), is_jamb_line,
               parameters.same_basin);
  growLabels(air, is_jamb_line, label); // rooms meet in doorways
  growLabels(air, std::vector<std::uint8_t>(air.size(), 0), label);
  return label;
}

} // namespace pcl::sedr
