// SPDX-License-Identifier: BSD-3-Clause
#include "scene_truth.h"

#include "simulator/truth/truth_mesh.h"

#include <pcl/sedr_filters/point_types.h>

namespace pcl::sedr::benchmark {

namespace {

constexpr double fine_chord_tolerance = 1e-5; ///< metres

/** @brief Returns a truth mesh in the frame of the scan. */
std::shared_ptr<const TriangleMesh>
placedMesh(const sim::Scene& scene, const sim::Mesh& truth)
{
  auto mesh = std::make_shared<TriangleMesh>();
  for (const sim::Vec3& vertex : truth.vertices) {
    const sim::Vec3 p = sim::placed(scene.placement, vertex);
    mesh->vertices.emplace_back(p.x, p.y, p.z);
  }
  for (const sim::Face& face : truth.faces) {
    mesh->triangles.push_back(face.vertices);
    mesh->labels.push_back(static_cast<std::uint32_t>(face.label));
    mesh->rooms.push_back(face.room);
  }
  return mesh;
}

} // namespace

SceneTruth
truthOf(const sim::Scene& scene)
{
  const sim::Mesh truth = sim::truthMesh(scene);
  return {placedMesh(scene, truth), sim::roomTruths(scene, truth),
          placedMesh(scene, sim::truthMesh(scene, fine_chord_tolerance))};
}

TriangleMesh
detailsOf(const TriangleMesh& truth)
{
  TriangleMesh details = truth;
  std::vector<bool> keep;
  for (const std::uint32_t label : truth.labels)
    keep.push_back(label == static_cast<std::uint32_t>(StructureLabel::Detail) ||
                   label == static_cast<std::uint32_t>(StructureLabel::Column));
  keep.resize(truth.triangles.size(), false);
  details.keepTriangles(keep);
  details.removeUnusedVertices();
  return details;
}

} // namespace pcl::sedr::benchmark
