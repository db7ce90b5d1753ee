// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contract/sample_structure.h"

#include <pcl/PolygonMesh.h>
#include <pcl/sedr_surface/structural_poisson.h>

namespace contract {

/** The points of the sample room get the normals of its faces. Coarse cells save time.
 * The size is the number of triangles.
 *
 * Not applicable: it makes a mesh, so it removes no points and has no in-place run. */
class StructuralPoissonAdaptor : public AdaptorDefaults {
public:
  static constexpr bool finds_in_one_point = false;
  static constexpr int spoils = 7;

  StructuralPoissonAdaptor() { mend(); }

  void setInput(const Cloud::ConstPtr& cloud)
  {
    cloud_ = cloud;
    setPoints(*between(*cloud, -10.f, 10.f));
  }

  void setIndices(const pcl::IndicesPtr& indices)
  {
    setPoints(*indices);
    poisson_.setIndices(indices);
  }

  void setThreads(unsigned threads) { poisson_.setNumberOfThreads(threads); }

  void mend()
  {
    poisson_.setDepth(9);
    poisson_.setPointWeight(10);
    poisson_.setCellRatio(4);
    poisson_.setMinimumPoints(100);
    poisson_.setSupportDistance(0.3);
    poisson_.setRoomLabels(structure_.rooms);
  }

  void spoil(int which)
  {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    switch (which) {
    case 0:
      return poisson_.setDepth(2);
    case 1:
      return poisson_.setDepth(15);
    case 2:
      return poisson_.setPointWeight(nan);
    case 3:
      return poisson_.setCellRatio(0);
    case 4:
      return poisson_.setMinimumPoints(9);
    case 5:
      return poisson_.setSupportDistance(0);
    default:
      return poisson_.setRoomLabels({1, 1, 1});
    }
  }

  Outcome run()
  {
    pcl::PolygonMesh mesh;
    mesh.polygons.resize(3);
    poisson_.reconstruct(mesh);
    Outcome outcome;
    outcome.size = mesh.polygons.size();
    outcome.error = poisson_.getErrorMessage();
    append(outcome.geometry, mesh.cloud.data);
    for (const auto& polygon : mesh.polygons)
      append(outcome.geometry, polygon.vertices);
    append(outcome.geometry, poisson_.getTriangleRooms());
    append(outcome.geometry, static_cast<int>(poisson_.isClosed()));
    outcome.all = outcome.geometry;
    return outcome;
  }

private:
  void setPoints(const pcl::Indices& indices)
  {
    structure_ = SampleStructure(*cloud_, indices);
    const auto points = std::make_shared<pcl::PointCloud<pcl::PointNormal>>();
    for (std::size_t i = 0; i < cloud_->size(); ++i) {
      pcl::PointNormal p;
      p.getVector3fMap() = (*cloud_)[i].getVector3fMap();
      p.getNormalVector3fMap() = normalOf(i).cast<float>();
      points->push_back(p);
    }
    poisson_.setInputCloud(points);
    poisson_.setRoomLabels(structure_.rooms);
  }

  Eigen::Vector3d normalOf(std::size_t i) const
  {
    if (structure_.labels[i] != 3)
      return {0, 0, structure_.labels[i] == 1 ? -1. : 1.};
    const auto& rooms = structure_.plan->rooms;
    const auto& walls =
        rooms[std::min<std::size_t>(structure_.rooms[i], rooms.size()) - 1].boundary;
    const Eigen::Vector2d place((*cloud_)[i].x, (*cloud_)[i].y);
    if (!place.allFinite())
      return Eigen::Vector3d::UnitX();
    const Eigen::Vector2d n = walls.elements[walls.nearest(place)].normalAt(0);
    return {n.x(), n.y(), 0};
  }

  pcl::StructuralPoisson<pcl::PointNormal> poisson_;
  Cloud::ConstPtr cloud_;
  SampleStructure structure_;
};

} // namespace contract
