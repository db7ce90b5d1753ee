// SPDX-License-Identifier: BSD-3-Clause
#include "floor_platforms.h"

#include <pcl/impl/instantiate.hpp>
#include <pcl/sedr_filters/point_types.h>
#include <pcl/sedr_segmentation/impl/horizontal_plane_detection.hpp>

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

namespace {

std::string
problemOf(const LevelParameters& p)
{
  const auto bad = [&](const char* what, double value, const char* range) {
    return std::string(what) + " must be " + range + ", it is " + std::to_string(value);
  };
  if (!(p.tolerance > 0) || !std::isfinite(p.tolerance))
    return bad("the distance threshold", p.tolerance, "above 0 m");
  if (!(p.cell_size > 0) || !std::isfinite(p.cell_size))
    return bad("the grid size", p.cell_size, "above 0 m");
  if (!(p.maximum_tilt >= 0 && p.maximum_tilt <= M_PI / 4))
    return bad("the maximum tilt", p.maximum_tilt, "within 0 and pi/4 radians");
  if (!(p.minimum_area > 0) || !std::isfinite(p.minimum_area))
    return bad("the minimum area", p.minimum_area, "above 0 square metres");
  if (!(p.minimum_room_height > 0) || !std::isfinite(p.minimum_room_height))
    return bad("the minimum room height", p.minimum_room_height, "above 0 m");
  return problemOf(p.priors);
}

pcl::HorizontalPlane
planeOf(Level level, double cell_size)
{
  pcl::HorizontalPlane plane;
  plane.inliers.indices = std::move(level.inliers);
  for (int k = 0; k < 4; ++k)
    plane.coefficients.values.push_back(static_cast<float>(level.slab.plane[k]));
  plane.kind = level.kind;
  plane.height = level.height;
  plane.cells = level.cells.size();
  plane.area = static_cast<double>(plane.cells) * cell_size * cell_size;
  plane.residual = level.slab.residual;
  plane.slab = level.slab;
  return plane;
}

} // namespace

std::string
detectHorizontalPlanes(const PointView& points,
                       const pcl::Indices& indices,
                       const LevelParameters& parameters,
                       std::vector<pcl::HorizontalPlane>& planes,
                       HeightHistogram& histogram)
{
  std::string problem = indicesProblem(indices, points.size());
  if (problem.empty())
    problem = problemOf(parameters);
  if (!problem.empty())
    return problem;
  const LevelColumns columns = columnsOf(points, indices, parameters);
  std::vector<Level> levels = findLevels(columns, parameters, &histogram);
  classifyLevels(levels, parameters);
  markPlatforms(levels, points, indices, parameters);
  collectInliers(levels, columns, parameters);
  for (Level& level : levels)
    planes.push_back(planeOf(std::move(level), parameters.cell_size));
  if (!planes.empty())
    return {};
  return "no horizontal plane of at least " + std::to_string(parameters.minimum_area) +
         " square metres in " + std::to_string(indices.size()) + " points";
}

} // namespace pcl::sedr

PCL_INSTANTIATE(HorizontalPlaneDetection, SEDR_POINT_TYPES)
