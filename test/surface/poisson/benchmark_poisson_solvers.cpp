// SPDX-License-Identifier: BSD-3-Clause
// Makes the mesh of a structure by pcl::Poisson, room by room, with cells of the size
// of StructuralPoisson: depth and scale of the octree are chosen accordingly.
//
//     benchmark_poisson_solvers STRUCTURE.pcd MESH.ply
#include <pcl/io/pcd_io.h>
#include <pcl/sedr_filters/point_types.h>
#include <pcl/sedr_surface/triangle_mesh.h>
#include <pcl/surface/poisson.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>

namespace {

pcl::sedr::TriangleMesh
meshOf(const pcl::PointCloud<pcl::PointNormal>::Ptr& room)
{
  constexpr double cell = 0.04; // metres: 0.8 times the spacing of the points
  Eigen::AlignedBox3f box;
  for (const auto& p : *room)
    box.extend(p.getVector3fMap());
  const double extent = static_cast<double>(box.sizes().maxCoeff());
  const int depth =
      std::clamp(static_cast<int>(std::ceil(std::log2(1.1 * extent / cell))), 3, 9);
  pcl::Poisson<pcl::PointNormal> poisson;
  poisson.setDepth(depth);
  poisson.setScale(
      static_cast<float>(std::max(1.1, cell * std::ldexp(1., depth) / extent)));
  poisson.setSamplesPerNode(1);
  poisson.setInputCloud(room);
  pcl::PolygonMesh polygons;
  poisson.reconstruct(polygons);
  pcl::sedr::TriangleMesh mesh;
  pcl::sedr::fromPolygonMesh(polygons, mesh);
  return mesh;
}

} // namespace

int
main(int argc, char** argv)
{
  pcl::PointCloud<pcl::PointStructure> cloud;
  if (argc != 3 || pcl::io::loadPCDFile(argv[1], cloud) < 0) {
    std::fprintf(stderr, "usage: benchmark_poisson_solvers STRUCTURE.pcd MESH.ply\n");
    return 1;
  }
  std::map<std::uint32_t, pcl::PointCloud<pcl::PointNormal>::Ptr> rooms;
  for (const auto& p : cloud) {
    auto& room = rooms[p.room];
    if (!room)
      room.reset(new pcl::PointCloud<pcl::PointNormal>);
    room->push_back({p.x, p.y, p.z, p.normal_x, p.normal_y, p.normal_z});
  }
  pcl::sedr::TriangleMesh mesh;
  for (const auto& [number, room] : rooms)
    mesh.append(meshOf(room));
  std::ofstream file(argv[2], std::ios::binary);
  return file << pcl::sedr::meshToPly(mesh) ? 0 : 1;
}
