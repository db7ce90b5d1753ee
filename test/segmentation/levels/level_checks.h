// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room_points.h"

#include "sedr_segmentation/src/levels/horizontal_levels.h"

#include <gtest/gtest.h>

#include <vector>

namespace sedr_test {

using namespace pcl::sedr;

constexpr auto Ceiling = LevelKind::Ceiling;
constexpr auto Floor = LevelKind::Floor;
constexpr auto Other = LevelKind::Other;

inline std::vector<Level>
levelsOf(const RoomPoints& points, const LevelParameters& parameters = {})
{
  std::vector<Level> levels = findLevels(points.view(), points.all(), parameters);
  classifyLevels(levels, parameters);
  collectInliers(levels, points.view(), points.all(), parameters);
  return levels;
}

inline double
heightOf(const Level& level)
{
  return level.slab.heightAt({0, 0});
}

inline std::vector<LevelKind>
kindsOf(const std::vector<Level>& levels)
{
  std::vector<LevelKind> kinds;
  for (const auto& level : levels)
    kinds.push_back(level.kind);
  return kinds;
}

/** Expects the heights of the levels at the origin, within `tolerance`. */
inline void
expectHeights(const std::vector<Level>& levels,
              const std::vector<double>& heights,
              double tolerance = 1e-5)
{
  ASSERT_EQ(levels.size(), heights.size());
  for (std::size_t l = 0; l < levels.size(); ++l)
    EXPECT_NEAR(heightOf(levels[l]), heights[l], tolerance) << "level " << l;
}

/** Returns the points of a slab in cells without wall points. */
inline std::vector<int>
besideWalls(const RoomPoints& points,
            const std::vector<int>& slab,
            const std::vector<int>& walls)
{
  const CellGrid grid(0.05);
  const CellSet wall_cells(grid, points.view(), walls);
  std::vector<int> result;
  for (const int i : slab)
    if (!wall_cells.contains(grid.at(points[i].x(), points[i].y())))
      result.push_back(i);
  return result;
}

} // namespace sedr_test
