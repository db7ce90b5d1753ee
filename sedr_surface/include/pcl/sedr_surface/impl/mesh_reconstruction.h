// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/impl/stage_error.h>
#include <pcl/sedr_filters/point_types.h>
#include <pcl/sedr_surface/triangle_mesh.h>
#include <pcl/surface/reconstruction.h>

#include <vector>

namespace pcl::sedr {

/** @brief Base of the stages that make a mesh of rooms. It serves both of PCL's output
 * forms, with or without an input cloud. A derived class makes mesh_ in run(). */
template <typename PointT>
class MeshReconstruction : public pcl::SurfaceReconstruction<PointT>,
                           public StageError {
public:
  using PointCloud = pcl::PointCloud<PointT>;

  /** @brief Makes the mesh; empty, with a reason in getErrorMessage(), if there is
   * none. Its vertices are single precision; getMesh() has double precision. */
  void reconstruct(pcl::PolygonMesh& output) override;

  /** @brief As above. If the point type has such fields, each point gets the room, the
   * label and the mean normal of its triangles. */
  void reconstruct(PointCloud& points, std::vector<pcl::Vertices>& polygons) override;

  /** @brief Returns the mesh of the last run in double precision, with the room of
   * every triangle. */
  const TriangleMesh& getMesh() const { return mesh_; }

protected:
  using pcl::PCLBase<PointT>::input_;

  MeshReconstruction();
  ~MeshReconstruction() override;

  /** @brief Makes mesh_.
   * @return false if there is no mesh, or a room is missing */
  virtual bool run() = 0;

  void performReconstruction(pcl::PolygonMesh& output) override;

  void performReconstruction(PointCloud& points,
                             std::vector<pcl::Vertices>& polygons) override;

  TriangleMesh mesh_;
};

} // namespace pcl::sedr
