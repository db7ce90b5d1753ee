// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_segmentation/ceiling_boundary_wall_growing.h>

#include <pcl/impl/pcl_base.hpp>

#include <vector>

template <typename PointT>
std::string
pcl::CeilingBoundaryWallGrowing<PointT>::problem() const
{
  for (const auto& indices : {IndicesConstPtr(indices_), ceiling_, floor_, details_}) {
    std::string wrong =
        indices ? sedr::indicesProblem(*indices, input_->size()) : std::string();
    if (!wrong.empty())
      return wrong;
  }
  std::string wrong = sedr::problemOf(boundary_);
  return wrong.empty() ? sedr::problemOf(growing_) : wrong;
}

template <typename PointT>
bool
pcl::CeilingBoundaryWallGrowing<PointT>::segment(pcl::PointIndices& walls)
{
  walls = pcl::PointIndices();
  for (auto* result :
       {&ceiling_boundary_, &scope_boundary_, &floor_boundary_, &wall_indices_})
    result->clear();
  seeds_ = sedr::WallSeeds();
  this->clearError();
  if (!input_ || !this->initCompute())
    return this->fail("CeilingBoundaryWallGrowing", "no input cloud was set");
  walls.header = input_->header;

  std::string wrong = problem();
  if (wrong.empty()) {
    const sedr::PointView points(*input_);
    const sedr::WallParts parts = sedr::wallParts(
        points, *indices_, ceiling_.get(), floor_.get(), details_.get(), growing_);
    wrong = sedr::problemOf(parts, growing_);
    if (wrong.empty()) {
      seeds_ = sedr::seedsWithSupport(points, parts, findSeeds(parts), growing_);
      wall_indices_ = sedr::growWalls(points, parts, seeds_, growing_);
      walls.indices = sedr::unite(wall_indices_, parts.details);
    }
  }
  this->deinitCompute();
  return wrong.empty() || this->fail("CeilingBoundaryWallGrowing", wrong);
}

template <typename PointT>
pcl::sedr::WallSeeds
pcl::CeilingBoundaryWallGrowing<PointT>::findSeeds(const sedr::WallParts& parts)
{
  ceiling_boundary_ = boundaryOf(parts.ceiling);
  if (!growing_.hasSlice())
    return {ceiling_boundary_, {}};

  floor_boundary_ = boundaryOf(parts.floor);
  scope_boundary_ = sedr::boundaryPoints(sedr::PointView(*input_),
                                         sedr::unite(parts.ceiling, parts.details),
                                         sedr::Nearness::Plan, boundary_);
  return {sedr::unite(ceiling_boundary_, scope_boundary_), floor_boundary_};
}

template <typename PointT>
pcl::Indices
pcl::CeilingBoundaryWallGrowing<PointT>::boundaryOf(const pcl::Indices& slab) const
{
  const sedr::PointView points(*input_);
  if (!search_)
    return sedr::boundaryPoints(points, slab, sedr::Nearness::Space, boundary_);
  search_->setInputCloud(input_, pcl::make_shared<const pcl::Indices>(slab));
  const auto search = [this](pcl::index_t index, unsigned int k,
                             pcl::Indices& nearest) {
    std::vector<float> square_distances;
    const auto& point = (*input_)[static_cast<std::size_t>(index)];
    search_->nearestKSearch(point, static_cast<int>(k), nearest, square_distances);
  };
  return sedr::boundaryPoints(points, slab, search, boundary_);
}

#define PCL_INSTANTIATE_CeilingBoundaryWallGrowing(T)                                  \
  template class PCL_EXPORTS pcl::CeilingBoundaryWallGrowing<T>;
