// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulator/mesh/scene_mesh.h"
#include "simulator/scan/scan.h"
#include "simulator/scene/scene.h"

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/sedr_surface/mesh_evaluation.h>

#include <gtest/gtest.h>

#include <memory>
#include <utility>
#include <vector>

namespace pcl::sedr::sim {

/** @brief Returns scan options with the given noise and seed. */
inline ScanOptions
noiseAndSeed(double noise, std::uint64_t seed)
{
  ScanOptions options;
  options.noise = noise;
  options.seed = seed;
  return options;
}

/** @brief Returns a scan of a scene. */
inline pcl::PointCloud<pcl::PointXYZ>::ConstPtr
cloudOf(const Scene& scene, const ScanOptions& options = {})
{
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  for (const auto& p : scan(scene, options).points)
    cloud->emplace_back(p.x, p.y, p.z);
  return cloud;
}

/** @brief Returns faces of a scene in the frame of its scan.
 * @param wanted called with the mesh and the number of a triangle */
template <typename Wanted>
std::shared_ptr<const TriangleMesh>
facesOf(const Scene& scene, const Wanted& wanted)
{
  const SceneMesh all = meshOf(scene);
  std::vector<bool> keep;
  for (std::size_t t = 0; t < all.surfaces.size(); ++t)
    keep.push_back(wanted(all, t));
  auto mesh = std::make_shared<TriangleMesh>(all.mesh);
  mesh->keepTriangles(keep);
  mesh->removeUnusedVertices();
  for (Eigen::Vector3d& vertex : mesh->vertices)
    vertex = placed(scene.placement, vertex);
  return mesh;
}

/** @brief Returns the closed structural mesh of a scene, in the frame of its scan. */
inline std::shared_ptr<const TriangleMesh>
truthInScan(const Scene& scene)
{
  return facesOf(scene, [](const SceneMesh& all, std::size_t t) {
    return all.surfaces[t] == Surface::Structure || all.surfaces[t] == Surface::Gap;
  });
}

/** @brief Returns how far a mesh is from the truth, and the truth from it, at samples
 * every 5 cm. */
inline MeshEvaluationResult
figuresOf(const TriangleMesh& mesh, std::shared_ptr<const TriangleMesh> truth)
{
  pcl::MeshEvaluation evaluation;
  evaluation.setSampleSpacing(0.05);
  evaluation.setInputMesh(std::make_shared<const TriangleMesh>(mesh));
  evaluation.setTruth(std::move(truth));
  MeshEvaluationResult figures;
  EXPECT_TRUE(evaluation.compute(figures)) << evaluation.getErrorMessage();
  return figures;
}

} // namespace pcl::sedr::sim
