// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "comparison.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace pcl::sedr::tools {

/** @brief The distance of elements that cannot be the same. */
constexpr double never = std::numeric_limits<double>::infinity();

/** @brief A room, wall, column, slab or opening of a plan. */
struct Element {
  std::string what{};
  std::string name{}; ///< as in a solid
  PlanLoop outline{};
  double size = 0; ///< see Change
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  RoomHeights heights{}; ///< of its room
};

/** @brief Returns the change of one element, before or after. */
Change changeOf(const Element& element, ChangeKind kind);

/** @brief Returns the move of an element, by that of its middle. */
Change moveOf(const Element& before, const Element& after);

/** @brief Finds walls that moved, appeared or vanished, by the positions of their faces
 * only. A wall that became longer or belongs to another room is not reported. Equal
 * changes of both faces of a partition are merged, as are neighbours in a room's
 * outline that appear or vanish together.
 * @param rooms that appeared or vanished, whose walls are ignored */
std::vector<Change> wallChanges(const Floorplan& before,
                                const Floorplan& after,
                                const CompareSettings& settings,
                                const std::vector<Change>& rooms);

/** @brief Finds ceilings and floors at another height, and soffits, recesses, steps and
 * platforms that moved, appeared or vanished. A detail is unchanged if the other plan
 * has the same height over more than half of it, whatever its kind.
 * @param rooms that appeared or vanished are added: less than half of their floor is
 * floor in the other plan */
std::vector<Change> slabChanges(const Floorplan& before,
                                const Floorplan& after,
                                const CompareSettings& settings,
                                std::vector<Change>& rooms);

/** @brief Pairs the elements of two lists, the nearest ones first, and removes them
 * from their lists.
 * @param distance of an element of each list
 * @param farthest distance of a pair, excluded */
template <typename ElementT, typename DistanceT>
std::vector<std::pair<ElementT, ElementT>>
takePairs(std::vector<ElementT>& before,
          std::vector<ElementT>& after,
          double farthest,
          const DistanceT& distance)
{
  std::vector<std::pair<ElementT, ElementT>> pairs;
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
