// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "change.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Rooms that appeared or vanished: less than half of their floor is floor in
 * the other plan. */
struct RoomChanges {
  std::vector<Change> changes;
  std::vector<std::uint32_t> before; ///< ids of rooms that vanished
  std::vector<std::uint32_t> after;  ///< ids of rooms that appeared
};

RoomChanges roomChanges(const Floorplan& before, const Floorplan& after);

/** @brief Finds walls that moved, appeared or vanished, by the positions of their faces
 * only. A wall that became longer or belongs to another room is not reported. Equal
 * changes of both faces of a partition are merged, as are neighbours in a room's
 * outline that appear or vanish together.
 * @param rooms whose walls are ignored */
std::vector<Change> wallChanges(const Floorplan& before,
                                const Floorplan& after,
                                const CompareSettings& settings,
                                const RoomChanges& rooms);

/** @brief Finds columns that moved, appeared or vanished. A column that only changed
 * its size, or became part of the walls, is not reported. */
std::vector<Change> columnChanges(const Floorplan& before,
                                  const Floorplan& after,
                                  const CompareSettings& settings);

/** @brief Finds ceilings and floors at another height, and soffits, recesses, steps and
 * platforms that moved, appeared or vanished. A detail is unchanged if the other plan
 * has the same height over more than half of it, whatever its kind. */
std::vector<Change> slabChanges(const Floorplan& before,
                                const Floorplan& after,
                                const CompareSettings& settings);

/** @brief Finds doors, windows and passages that appeared or vanished in walls that
 * both plans have. What shares a part of a wall with another one is unchanged. Nothing
 * if one of the plans has no openings at all: nobody looked for them. */
std::vector<Change> openingChanges(const Floorplan& before,
                                   const Floorplan& after,
                                   const CompareSettings& settings);

/** @brief Pairs the things of two lists, the nearest ones first, and removes them from
 * their lists.
 * @param distance of a thing of each list; infinite if they cannot be the same
 * @param farthest distance of a pair, excluded */
template <typename ThingT, typename DistanceT>
std::vector<std::pair<ThingT, ThingT>>
takePairs(std::vector<ThingT>& before,
          std::vector<ThingT>& after,
          double farthest,
          const DistanceT& distance)
{
  std::vector<std::pair<ThingT, ThingT>> pairs;
  while (true) {
    double least = farthest;
    auto a_best = before.end();
    auto b_best = after.end();
    for (auto a = before.begin(); a != before.end(); ++a)
      for (auto b = after.begin(); b != after.end(); ++b)
        if (const double found = distance(*a, *b); found < least) {
          least = found;
          a_best = a;
          b_best = b;
        }
    if (a_best == before.end())
      return pairs;
    pairs.emplace_back(*a_best, *b_best);
    before.erase(a_best);
    after.erase(b_best);
  }
}

} // namespace pcl::sedr::tools
