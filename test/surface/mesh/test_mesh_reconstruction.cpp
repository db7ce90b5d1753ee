// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_surface/mesh_reconstruction.h>

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr;

/** A stage whose mesh is two triangles of rooms 1 and 2 that share an edge: one in the
 * plane z = 0, one in the plane x = 0. */
template <typename PointT>
class Ridge : public MeshReconstruction<PointT> {
public:
  bool fails = false;

private:
  bool run() override
  {
    this->mesh_ = TriangleMesh();
    if (fails)
      return false;
    this->mesh_.vertices = {{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 0, -1}};
    this->mesh_.triangles = {{0, 1, 2}, {0, 3, 1}};
    this->mesh_.rooms = {1, 2};
    return true;
  }

  std::string getClassName() const override { return "Ridge"; }
};

TEST(MeshReconstruction, WithoutACloudGivesAPolygonMesh)
{
  Ridge<pcl::PointXYZ> ridge;
  pcl::PolygonMesh mesh;
  ridge.reconstruct(mesh);
  ASSERT_EQ(mesh.polygons.size(), 2u);
  EXPECT_EQ(mesh.polygons[1].vertices, (pcl::Indices{0, 3, 1}));
  EXPECT_EQ(mesh.cloud.width * mesh.cloud.height, 4u);
  EXPECT_EQ(ridge.getMesh().vertices[2], Eigen::Vector3d(-1, 0, 0));
  ridge.fails = true;
  ridge.reconstruct(mesh);
  EXPECT_TRUE(mesh.polygons.empty()) << "nothing is left of the last run";
}

TEST(MeshReconstruction, PointsHaveTheRoomAndTheMeanNormalOfTheirTriangles)
{
  Ridge<pcl::PointStructure> ridge;
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointStructure>>();
  cloud->resize(1);
  cloud->header.frame_id = "scanner";
  ridge.setInputCloud(cloud);
  std::vector<pcl::Vertices> polygons;
  ridge.reconstruct(*cloud, polygons); // the output may be the input
  EXPECT_EQ(cloud->header.frame_id, "scanner");
  ASSERT_EQ(cloud->size(), 4u);
  ASSERT_EQ(polygons.size(), 2u);
  const auto normal = [&](std::size_t v) -> Eigen::Vector3f {
    return (*cloud)[v].getNormalVector3fMap();
  };
  EXPECT_TRUE(normal(2).isApprox(Eigen::Vector3f(0, 0, 1)));
  EXPECT_TRUE(normal(3).isApprox(Eigen::Vector3f(1, 0, 0)));
  EXPECT_TRUE(normal(0).isApprox(Eigen::Vector3f(1, 0, 1).normalized()));
  EXPECT_EQ((*cloud)[2].room, 1u);
  EXPECT_EQ((*cloud)[3].room, 2u);
}

} // namespace
