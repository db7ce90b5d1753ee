// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/point_types.h>
#include <pcl/sedr_filters/stage_error.h>
#include <pcl/sedr_surface/triangle_mesh.h>
#include <pcl/surface/reconstruction.h>

#include <vector>

namespace pcl {
namespace sedr {

/** @brief Base of the stages that make a mesh of rooms: PCL's two forms of it, whether
 * or not there is an input cloud. A class that derives from it makes mesh_ in run(). */
template <typename PointT>
class MeshReconstruction : public pcl::SurfaceReconstruction<PointT>,
                           public StageError {
public:
  using PointCloud = pcl::PointCloud<PointT>;

  /** @brief Makes the mesh; an empty one and getErrorMessage() if there is none. The
   * vertices are single precision there: getMesh() has them as they are. */
  void reconstruct(pcl::PolygonMesh& output) override;

  /** @brief The same; where the points have such fields, each gets the room and the
   * mean normal of its triangles. */
  void reconstruct(PointCloud& points, std::vector<pcl::Vertices>& polygons) override;

  /** @brief The mesh of the last run, in double precision, with the room of every
   * triangle. */
  const TriangleMesh& getMesh() const { return mesh_; }

protected:
  using pcl::PCLBase<PointT>::input_;

  MeshReconstruction();
  ~MeshReconstruction() override;

  /** @brief Makes mesh_.
   * @return false if there is none, or a room is missing */
  virtual bool run() = 0;

  void performReconstruction(pcl::PolygonMesh& output) override;

  void performReconstruction(PointCloud& points,
                             std::vector<pcl::Vertices>& polygons) override;

  TriangleMesh mesh_;
};

} // namespace sedr
} // namespace pcl
