// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_segmentation/floor_platforms.h>
#include <pcl/sedr_segmentation/floor_reflections.h>
#include <pcl/sedr_segmentation/horizontal_plane_detection.h>

#include <algorithm>
#include <cmath>

template <typename PointT>
bool
pcl::HorizontalPlaneDetection<PointT>::checkParameters()
{
  const auto& p = parameters_;
  const auto bad = [&](const char* what, double value, const char* range) {
    return this->fail("HorizontalPlaneDetection", std::string(what) + " must be " +
                                                      range + ", it is " +
                                                      std::to_string(value));
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
  return true;
}

template <typename PointT>
std::vector<pcl::sedr::Level>
pcl::HorizontalPlaneDetection<PointT>::findLevels(const sedr::LevelColumns& columns)
{
  std::vector<sedr::Level> levels = sedr::findLevels(columns, parameters_, &histogram_);
  sedr::classifyLevels(levels, parameters_);
  return levels;
}

template <typename PointT>
bool
pcl::HorizontalPlaneDetection<PointT>::segment(std::vector<HorizontalPlane>& planes)
{
  planes.clear();
  histogram_ = sedr::HeightHistogram();
  reflections_.clear();
  this->clearError();
  if (!this->initCompute())
    return this->fail("HorizontalPlaneDetection", "no input cloud was set");
  const std::string problem = sedr::indicesProblem(*indices_, input_->size());
  if (!problem.empty()) {
    this->deinitCompute();
    return this->fail("HorizontalPlaneDetection", problem);
  }
  if (!checkParameters()) {
    this->deinitCompute();
    return false;
  }

  const sedr::PointView points(*input_);
  pcl::Indices used = *indices_;
  sedr::LevelColumns columns = sedr::columnsOf(points, used, parameters_);
  std::vector<sedr::Level> levels = findLevels(columns);
  reflections_ = sedr::findReflections(columns, levels, parameters_);
  if (!reflections_.empty()) {
    used.erase(std::remove_if(used.begin(), used.end(),
                              [&](index_t i) {
                                return std::binary_search(reflections_.begin(),
                                                          reflections_.end(), i);
                              }),
               used.end());
    columns = sedr::columnsOf(points, used, parameters_);
    levels = findLevels(columns);
  }
  sedr::markPlatforms(levels, points, used, parameters_);
  sedr::collectInliers(levels, columns, parameters_);
  for (auto& level : levels) {
    HorizontalPlane plane;
    plane.inliers.header = plane.coefficients.header = input_->header;
    plane.inliers.indices = std::move(level.inliers);
    for (int k = 0; k < 4; ++k)
      plane.coefficients.values.push_back(static_cast<float>(level.slab.plane[k]));
    plane.kind = level.kind;
    plane.height = level.height;
    plane.cells = level.cells.size();
    plane.area = static_cast<double>(plane.cells) * parameters_.cell_size *
                 parameters_.cell_size;
    plane.residual = level.slab.residual;
    plane.slab = level.slab;
    planes.push_back(std::move(plane));
  }
  this->deinitCompute();
  if (planes.empty())
    return this->fail(
        "HorizontalPlaneDetection",
        "no horizontal plane of at least " + std::to_string(parameters_.minimum_area) +
            " square metres in " + std::to_string(indices_->size()) + " points");
  return true;
}

#define PCL_INSTANTIATE_HorizontalPlaneDetection(T)                                    \
  template class PCL_EXPORTS pcl::HorizontalPlaneDetection<T>;
