// SPDX-License-Identifier: BSD-3-Clause
#include "meshes.h"
#include "says.h"

#include <pcl/PolygonMesh.h>
#include <pcl/point_types.h>
#include <pcl/sedr_surface/mesh_evaluation.h>

#include <gtest/gtest.h>

#include <limits>
#include <sstream>

using namespace pcl::sedr;
using namespace sedr_test;

namespace {

using MeshPtr = std::shared_ptr<const TriangleMesh>;

MeshPtr
share(TriangleMesh mesh)
{
  return std::make_shared<const TriangleMesh>(std::move(mesh));
}

pcl::PointCloud<pcl::PointXYZ>::Ptr
cloudOf(const std::vector<Eigen::Vector3d>& points)
{
  auto cloud = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (const auto& p : points)
    cloud->push_back(pcl::PointXYZ(static_cast<float>(p.x()), static_cast<float>(p.y()),
                                   static_cast<float>(p.z())));
  return cloud;
}

} // namespace

TEST(MeshEvaluation, a_cube_grown_by_a_centimetre_is_a_centimetre_off)
{
  pcl::MeshEvaluation evaluation;
  evaluation.setInputMesh(share(box({-0.01, -0.01, -0.01}, {1.01, 1.01, 1.01})));
  evaluation.setTruth(share(unitCube()));
  evaluation.setSampleSpacing(0.005);
  MeshEvaluationResult result;
  ASSERT_TRUE(evaluation.compute(result));
  EXPECT_NEAR(result.truth_to_mesh->mean, 0.01, 1e-9); // the faces overhang
  EXPECT_NEAR(result.truth_to_mesh->max, 0.01, 1e-9);
  EXPECT_LE(result.mesh_to_truth->max, 0.01 * std::sqrt(3) + 1e-9);
  EXPECT_GT(result.mesh_to_truth->max, 0.014);
  EXPECT_NEAR(result.mesh.volume, std::pow(1.02, 3), 1e-9);
  EXPECT_NEAR(result.truth->area, 6, 1e-12);
  EXPECT_TRUE(result.mesh.closed);
  EXPECT_NEAR(result.sample_spacing, 0.005, 1e-4);
}

TEST(MeshEvaluation, indices_select_and_points_that_are_not_finite_are_counted)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  auto cloud = cloudOf({{0.5, 0.5, 3}, {0.5, 0.5, 1.5}, {9, 9, 9}});
  cloud->push_back(pcl::PointXYZ(nan, 0, 0));
  pcl::MeshEvaluation evaluation;
  evaluation.setInputMesh(share(unitCube()));
  evaluation.setInputCloud(cloud);
  evaluation.setIndices(std::make_shared<const pcl::Indices>(pcl::Indices{1, 3}));
  MeshEvaluationResult result;
  ASSERT_TRUE(evaluation.compute(result));
  EXPECT_EQ(result.cloud_to_mesh->count, 1u);
  EXPECT_EQ(result.skipped_points, 1u);
  EXPECT_NEAR(result.cloud_to_mesh->mean, 0.5, 1e-7);
  evaluation.setIndices(nullptr);
  ASSERT_TRUE(evaluation.compute(result));
  EXPECT_EQ(result.cloud_to_mesh->count, 3u);
}

TEST(MeshEvaluation, vertices_at_equal_places_count_when_welded)
{
  MeshEvaluationResult result;
  pcl::MeshEvaluation evaluation;
  evaluation.setInputMesh(
      share(sphere({0, 0, 0}, 1, 5))); // a soup that is closed after welding
  ASSERT_TRUE(evaluation.compute(result));
  EXPECT_FALSE(result.mesh.closed);
  EXPECT_TRUE(result.mesh.closed_when_welded);
  evaluation.setInputMesh(share(both(unitCube(), box({1, 1, 0}, {2, 2, 1}))));
  ASSERT_TRUE(evaluation.compute(result));
  EXPECT_TRUE(result.mesh.closed);
  EXPECT_FALSE(result.mesh.closed_when_welded); // they share an edge
}

TEST(MeshEvaluation, self_intersections_are_found_when_asked_for)
{
  MeshEvaluationResult result;
  pcl::MeshEvaluation evaluation;
  const TriangleMesh crossing =
      both(unitCube(), box({0.5, 0.25, 0.25}, {2, 0.75, 0.75}));
  evaluation.setInputMesh(share(crossing));
  ASSERT_TRUE(evaluation.compute(result));
  EXPECT_FALSE(result.mesh.self_intersections.has_value());
  evaluation.setFindSelfIntersections(true);
  ASSERT_TRUE(evaluation.compute(result));
  EXPECT_GT(result.mesh.self_intersections.value(), 0u);
  std::ostringstream json;
  writeJson(json, result);
  EXPECT_TRUE(says(json.str(), "\"self_intersections\": "));
  evaluation.setInputMesh(share(unitCube()));
  ASSERT_TRUE(evaluation.compute(result));
  EXPECT_EQ(result.mesh.self_intersections.value(), 0u);
}

TEST(MeshEvaluation, bad_input_gives_a_reason_and_an_empty_result)
{
  pcl::MeshEvaluation evaluation;
  MeshEvaluationResult result;
  const auto expectReason = [&](const std::string& part) {
    result.sample_spacing = 1;
    EXPECT_FALSE(evaluation.compute(result));
    EXPECT_TRUE(says(evaluation.getErrorMessage(), part));
    EXPECT_EQ(result.sample_spacing, 0);
    EXPECT_FALSE(result.cloud_to_mesh.has_value());
  };
  expectReason("no mesh is set");
  evaluation.setInputMesh(share({}));
  expectReason("the model is no mesh: it has no triangles");
  TriangleMesh flat = unitCube();
  flat.triangles = {{0, 0, 1}};
  evaluation.setInputMesh(share(flat));
  expectReason("have no area");
  evaluation.setInputMesh(share(unitCube()));
  evaluation.setTruth(std::make_shared<const pcl::PolygonMesh>());
  expectReason("the truth is no mesh: the cloud of the mesh has no field x");
  evaluation.setTruth(MeshPtr());
  evaluation.setInputCloud(cloudOf({}));
  expectReason("no point to measure");
  evaluation.setInputCloud(cloudOf({{0, 0, 0}}));
  evaluation.setIndices(std::make_shared<const pcl::Indices>(pcl::Indices{-1}));
  expectReason("index -1 is out of range");
  evaluation.setIndices(nullptr);
  evaluation.setSampleSpacing(0);
  expectReason("the sample spacing must be above 0 m");
  evaluation.setSampleSpacing(0.02);
  EXPECT_TRUE(evaluation.compute(result));
  EXPECT_EQ(evaluation.getErrorMessage(), "");
}
