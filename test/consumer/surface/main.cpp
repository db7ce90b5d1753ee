// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_surface/mesh_evaluation.h>

#include <pcl/PolygonMesh.h>
#include <pcl/conversions.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cmath>

/** @brief Measures a tetrahedron, normals outwards. */
int
main()
{
  pcl::PointCloud<pcl::PointXYZ> corners;
  corners.push_back({0, 0, 0});
  corners.push_back({1, 0, 0});
  corners.push_back({0, 1, 0});
  corners.push_back({0, 0, 1});
  const auto mesh = pcl::make_shared<pcl::PolygonMesh>();
  pcl::toPCLPointCloud2(corners, mesh->cloud);
  mesh->polygons.resize(4);
  mesh->polygons[0].vertices = {0, 2, 1};
  mesh->polygons[1].vertices = {0, 1, 3};
  mesh->polygons[2].vertices = {0, 3, 2};
  mesh->polygons[3].vertices = {1, 2, 3};

  pcl::MeshEvaluation evaluation;
  evaluation.setInputMesh(mesh);
  pcl::sedr::MeshEvaluationResult result;
  return evaluation.compute(result) && result.mesh.closed &&
                 std::abs(result.mesh.volume - 1.0 / 6) < 1e-6
             ? 0
             : 1;
}
