// SPDX-License-Identifier: BSD-3-Clause
#include "contract/sample_structure.h"
#include "contract_suite.h"

#include <pcl/PolygonMesh.h>
#include <pcl/sedr_surface/floorplan_extrusion.h>
#include <pcl/sedr_surface/indoor_structure_reconstruction.h>
#include <pcl/sedr_surface/structural_poisson.h>

namespace contract {

std::string
bytesOf(const pcl::PolygonMesh& mesh)
{
  std::string bytes = bytesOf(mesh.cloud.data);
  for (const auto& polygon : mesh.polygons)
    append(bytes, polygon.vertices);
  return bytes;
}

/** The plan is that of the sample room, or null for fewer than 100 points. The size is
 * the number of triangles. */
class ExtrusionAdaptor : public Adaptor<pcl::FloorplanExtrusion<pcl::PointXYZ>> {
public:
  static constexpr bool uses_indices = false;
  static constexpr bool finds_in_one_point = false;

  ExtrusionAdaptor()
  {
    parameter([this](double v) { stage_.setChordTolerance(v); }, 0.00025, {-1, 5, nan});
  }

  void setInput(const Cloud::ConstPtr& cloud)
  {
    const pcl::IndicesPtr indices = between(*cloud, -10.f, 10.f);
    stage_.setInputCloud(cloud);
    stage_.setFloorplan(indices->size() < 100 ? nullptr
                                              : SampleStructure(*cloud, *indices).plan);
  }

  Outcome run()
  {
    pcl::PolygonMesh mesh;
    mesh.polygons.resize(3);
    stage_.reconstruct(mesh);
    return outcome(mesh.polygons.size(), bytesOf(mesh));
  }
};

/** The size is the number of points of the structure. The mesh is not made, to save
 * time. */
class ReconstructionAdaptor
    : public Adaptor<pcl::IndoorStructureReconstruction<pcl::PointXYZ>> {
public:
  static constexpr bool finds_in_one_point = false;

  ReconstructionAdaptor()
  {
    parameter([this](double v) { stage_.setVoxelSize(static_cast<float>(v)); }, 0.05,
              {0, -0.05});
    parameter([this](double v) { stage_.setPlaneTolerance(v); }, 0.07, {0, 5});
    parameter([this](double v) { stage_.setGridSize(v); }, 0.05, {nan, -1});
    parameter([this](double v) { stage_.setBoundaryEstimation(v, 200); }, M_PI / 3,
              {-1, 60});
    parameter([this](double v) { stage_.setBoundaryTolerance(v); }, 0.05, {0});
  }

  Outcome run()
  {
    stage_.findStructure();
    std::string geometry;
    const auto structure = stage_.getStructure();
    for (const auto& p : *structure)
      geometry +=
          bytesOf(p.x, p.y, p.z, p.normal_x, p.normal_y, p.normal_z, p.label, p.room);
    for (const auto& room : stage_.getFloorplan()->rooms)
      for (const auto& e : room.boundary.elements)
        geometry += bytesOf(e.start.x(), e.start.y());
    return outcome(structure->size(), geometry, stage_.getModel().failed_stage);
  }
};

/** The points of the sample room get the normals of its faces. The size is the number
 * of triangles. */
class PoissonAdaptor : public Adaptor<pcl::StructuralPoisson<pcl::PointStructure>> {
public:
  static constexpr bool finds_in_one_point = false;

  PoissonAdaptor()
  {
    // Coarse cells, to save time.
    parameter([this](double v) { stage_.setDepth(static_cast<int>(v)); }, 6, {2, 15});
  }

  void setInput(const Cloud::ConstPtr& cloud)
  {
    cloud_ = cloud;
    setPoints(*between(*cloud, -10.f, 10.f));
  }

  void setIndices(const pcl::IndicesPtr& indices)
  {
    setPoints(*indices);
    stage_.setIndices(indices);
  }

  Outcome run()
  {
    pcl::PolygonMesh mesh;
    mesh.polygons.resize(3);
    stage_.reconstruct(mesh);
    return outcome(mesh.polygons.size(), bytesOf(mesh));
  }

private:
  void setPoints(const pcl::Indices& indices)
  {
    structure_ = SampleStructure(*cloud_, indices);
    const auto points = std::make_shared<pcl::PointCloud<pcl::PointStructure>>();
    for (std::size_t i = 0; i < cloud_->size(); ++i) {
      pcl::PointStructure p;
      p.getVector3fMap() = (*cloud_)[i].getVector3fMap();
      p.getNormalVector3fMap() = normalOf(i).cast<float>();
      p.room = structure_.rooms[i];
      points->push_back(p);
    }
    stage_.setInputCloud(points);
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

  Cloud::ConstPtr cloud_;
  SampleStructure structure_;
};

using SurfaceAdaptors =
    ::testing::Types<PoissonAdaptor, ExtrusionAdaptor, ReconstructionAdaptor>;
INSTANTIATE_TYPED_TEST_SUITE_P(Surface, Contract, SurfaceAdaptors);

} // namespace contract
