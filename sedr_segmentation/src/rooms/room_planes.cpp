// SPDX-License-Identifier: BSD-3-Clause
#include "../air/height_counts.h"

#include "room_planes.h"
#include "sedr_filters/src/base/plane_fit.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace pcl::sedr {

namespace {

HeightCounts
heightsOf(const PointView& points, const std::vector<int>& sheet)
{
  HeightCounts heights;
  for (const int i : sheet)
    if (points.isFinite(static_cast<std::size_t>(i)))
      heights.add(points[static_cast<std::size_t>(i)].z());
  return heights;
}

} // namespace

double
ceilingLevel(const PointView& points, const std::vector<int>& sheet)
{
  return heightsOf(points, sheet).highestCount();
}

double
floorLevel(const PointView& points, const std::vector<int>& sheet)
{
  return heightsOf(points, sheet).lowestOf(HeightCounts::share_of_floor);
}

PlanSlab
mainPlane(const PointView& points,
          const std::vector<int>& sheet,
          double height,
          const RoomPlaneParameters& parameters)
{
  const double band =
      2 * parameters.tolerance; // what is level, and what is tilted from it
  std::vector<int> level;
  std::copy_if(sheet.begin(), sheet.end(), std::back_inserter(level), [&](int i) {
    return std::abs(points[static_cast<std::size_t>(i)].z() - height) <= band;
  });
  return findLargerSlab(positionsOf(points, level.size() < 3 ? sheet : level),
                        parameters.tolerance, parameters.maximum_tilt, parameters.seed,
                        parameters.threads);
}

std::vector<int>
pointsOn(const PointView& points,
         const std::vector<int>& indices,
         const PlanSlab& plane,
         double tolerance)
{
  std::vector<int> on;
  std::copy_if(indices.begin(), indices.end(), std::back_inserter(on), [&](int i) {
    return std::abs(distanceAbove(plane, points[static_cast<std::size_t>(i)])) <=
           tolerance;
  });
  return on;
}

std::vector<Eigen::Vector2d>
partsOf(Cell cell, const CellGrid& coarse, const CellGrid& fine)
{
  const int parts =
      std::max(1, static_cast<int>(std::lround(coarse.size() / fine.size())));
  std::vector<Eigen::Vector2d> places;
  for (int part = 0; part < parts * parts; ++part)
    places.push_back(coarse.centre(cell) +
                     fine.size() * Eigen::Vector2d(part % parts - (parts - 1) / 2.0,
                                                   part / parts - (parts - 1) / 2.0));
  return places;
}

std::vector<Eigen::Vector3f>
hiddenCeiling(const std::vector<RoomColumn>& columns,
              const CellGrid& coarse,
              const CellGrid& grid,
              const CellSet& seen,
              const PlanSlab& plane)
{
  constexpr double same = 0.2; // metres between the main plane and the height inferred
  std::vector<Eigen::Vector3f> hidden;
  for (const RoomColumn& column : columns) {
    if (column.ceiling_seen)
      continue;
    for (const Eigen::Vector2d& place : partsOf(column.cell, coarse, grid)) {
      if (seen.contains(grid.at(place.x(), place.y())))
        continue;
      const double of_plane = plane.heightAt(place);
      const bool is_main = std::abs(of_plane - column.ceiling) < same;
      hidden.push_back(
          Eigen::Vector3d(place.x(), place.y(), is_main ? of_plane : column.ceiling)
              .cast<float>());
    }
  }
  return hidden;
}

} // namespace pcl::sedr
