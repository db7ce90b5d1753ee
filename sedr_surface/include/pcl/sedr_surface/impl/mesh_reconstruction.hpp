// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/impl/pcl_bases.hpp>
#include <pcl/sedr_surface/impl/mesh_reconstruction.h>

#include <pcl/kdtree/impl/kdtree_flann.hpp>
#include <pcl/search/impl/kdtree.hpp>
#include <pcl/search/impl/organized.hpp>
#include <pcl/search/impl/search.hpp>

// Searches that are compiled already, as the base classes are.
#ifndef PCL_ONLY_CORE_POINT_TYPES
#define PCL_INSTANTIATE_CompiledSearches(T)                                            \
  extern template class pcl::KdTreeFLANN<T>;                                           \
  extern template class pcl::search::Search<T>;                                        \
  extern template class pcl::search::KdTree<T>;                                        \
  extern template class pcl::search::OrganizedNeighbor<T>;
PCL_INSTANTIATE(CompiledSearches, SEDR_POINT_TYPES)
#endif

namespace pcl::sedr {

template <typename PointT>
MeshReconstruction<PointT>::MeshReconstruction()
{
  this->check_tree_ = false;
}

template <typename PointT>
MeshReconstruction<PointT>::~MeshReconstruction() = default;

template <typename PointT>
void
MeshReconstruction<PointT>::reconstruct(pcl::PolygonMesh& output)
{
  output = pcl::PolygonMesh();
  if (input_)
    output.header = input_->header;
  performReconstruction(output);
}

template <typename PointT>
void
MeshReconstruction<PointT>::reconstruct(PointCloud& points,
                                        std::vector<pcl::Vertices>& polygons)
{
  // The output may be the input, so it is written only after all is read.
  const pcl::PCLHeader header = input_ ? input_->header : pcl::PCLHeader();
  PointCloud vertices;
  polygons.clear();
  performReconstruction(vertices, polygons);
  points.swap(vertices);
  points.header = header;
}

template <typename PointT>
void
MeshReconstruction<PointT>::performReconstruction(pcl::PolygonMesh& output)
{
  run();
  toPolygonMesh(mesh_, output);
}

template <typename PointT>
void
MeshReconstruction<PointT>::performReconstruction(PointCloud& points,
                                                  std::vector<pcl::Vertices>& polygons)
{
  run();
  std::vector<Eigen::Vector3d> normals(mesh_.vertices.size(), Eigen::Vector3d::Zero());
  points.resize(mesh_.vertices.size());
  polygons.resize(mesh_.triangles.size());
  for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
    const Triangle& triangle = mesh_.triangles[t];
    polygons[t].vertices.assign(triangle.begin(), triangle.end());
    for (const auto v : triangle) {
      normals[v] += mesh_.scaledNormal(t);
      if constexpr (pcl::traits::has_field<PointT, pcl::fields::room>::value)
        points[v].room = mesh_.rooms[t];
      if constexpr (pcl::traits::has_field<PointT, pcl::fields::label>::value)
        points[v].label = mesh_.labels.empty() ? 0 : mesh_.labels[t];
    }
  }
  for (std::size_t v = 0; v < mesh_.vertices.size(); ++v) {
    points[v].getVector3fMap() = mesh_.vertices[v].template cast<float>();
    if constexpr (pcl::traits::has_field<PointT, pcl::fields::normal_x>::value)
      points[v].getNormalVector3fMap() = normals[v].normalized().template cast<float>();
  }
}

} // namespace pcl::sedr

#define PCL_INSTANTIATE_MeshReconstruction(T)                                          \
  template class PCL_EXPORTS pcl::sedr::MeshReconstruction<T>;
