// SPDX-License-Identifier: BSD-3-Clause
#include "../triangulation/triangulation.h"
#include "sedr_filters/src/base/field_access.h"

#include <pcl/PolygonMesh.h>
#include <pcl/common/io.h>
#include <pcl/conversions.h>
#include <pcl/impl/instantiate.hpp>
#include <pcl/point_types.h>
#include <pcl/sedr_filters/point_types.h>
#include <pcl/sedr_surface/impl/mesh_reconstruction.hpp>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <map>
#include <optional>
#include <set>
#include <utility>

namespace pcl::sedr {
namespace {

/** @brief Reads x, y and z of a cloud.
 * @return why they cannot be read, or an empty string */
std::string
readVertices(const pcl::PCLPointCloud2& cloud, std::vector<Eigen::Vector3d>& vertices)
{
  const std::size_t size = static_cast<std::size_t>(cloud.width) * cloud.height;
  if (cloud.data.size() < size * cloud.point_step)
    return "the cloud of the mesh says " + std::to_string(size) +
           " points, but holds " + std::to_string(cloud.data.size()) + " bytes";
  vertices.resize(size);
  for (Eigen::Index k = 0; k < 3; ++k) {
    const std::string name(1, "xyz"[k]);
    const int index = pcl::getFieldIndex(cloud, name);
    if (index < 0)
      return "the cloud of the mesh has no field " + name;
    const pcl::PCLPointField& field = cloud.fields[static_cast<std::size_t>(index)];
    if (field.datatype != pcl::PCLPointField::FLOAT32 &&
        field.datatype != pcl::PCLPointField::FLOAT64)
      return "the field " + name + " of the mesh is neither float nor double";
    if (field.offset + fieldSize(field.datatype) > cloud.point_step)
      return "the field " + name + " of the mesh lies outside its points";
    for (std::size_t i = 0; i < size; ++i)
      vertices[i][k] =
          readField(&cloud.data[i * cloud.point_step + field.offset], field.datatype);
  }
  return {};
}

} // namespace

void
triangulatePolygon(const std::vector<Eigen::Vector3d>& vertices,
                   const std::vector<std::uint32_t>& polygon,
                   std::vector<Triangle>& triangles)
{
  const std::size_t n = polygon.size();
  const auto at = [&](std::size_t i) -> const Eigen::Vector3d& {
    return vertices[polygon[i % n]];
  };
  Eigen::Vector3d normal = Eigen::Vector3d::Zero(); // Newell's
  for (std::size_t i = 0; i < n; ++i)
    normal += (at(i) - at(0)).cross(at(i + 1) - at(0));
  bool is_convex = n > 2;
  for (std::size_t i = 0; i < n; ++i)
    is_convex =
        is_convex && normal.dot((at(i + 1) - at(i)).cross(at(i + 2) - at(i + 1))) > 0;
  std::optional<PlanTriangles> inside;
  std::vector<std::uint32_t> corners; // of the polygon, each place once
  if (!is_convex && normal.norm() > 0) {
    Eigen::Matrix<double, 3, 2> frame;
    frame.col(0) = normal.unitOrthogonal();
    frame.col(1) = normal.normalized().cross(frame.col(0));
    Eigen::AlignedBox2d box;
    for (std::size_t i = 0; i < n; ++i)
      box.extend(Eigen::Vector2d(frame.transpose() * (at(i) - at(0))));
    const PlanGrid grid(box);
    std::vector<GridPoint> points;
    std::map<GridPoint, std::uint32_t> known;
    const auto numberOf = [&](std::size_t i) {
      const GridPoint p = grid.toGrid(frame.transpose() * (at(i) - at(0)));
      const auto [entry, is_new] =
          known.emplace(p, static_cast<std::uint32_t>(points.size()));
      if (is_new) {
        points.push_back(p);
        corners.push_back(polygon[i % n]);
      }
      return entry->second;
    };
    // A bridge from a hole to the outline is passed twice: it is no part of the rim.
    std::set<std::pair<std::uint32_t, std::uint32_t>> rim;
    for (std::size_t i = 0; i < n; ++i) {
      const std::pair<std::uint32_t, std::uint32_t> edge =
          std::minmax({numberOf(i), numberOf(i + 1)});
      if (edge.first != edge.second && !rim.insert(edge).second)
        rim.erase(edge);
    }
    inside = trianglesWithin(points, {rim.begin(), rim.end()});
  }
  if (inside && !inside->empty())
    for (const auto& t : *inside)
      triangles.push_back({corners[t[0]], corners[t[1]], corners[t[2]]});
  else
    for (std::size_t i = 1; i + 1 < n; ++i)
      triangles.push_back({polygon[0], polygon[i], polygon[i + 1]});
}

std::string
fromPolygonMesh(const pcl::PolygonMesh& polygon_mesh, TriangleMesh& mesh)
{
  mesh = TriangleMesh();
  std::vector<Eigen::Vector3d> vertices;
  std::string reason = readVertices(polygon_mesh.cloud, vertices);
  if (!reason.empty())
    return reason;
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> polygon;
  for (std::size_t p = 0; p < polygon_mesh.polygons.size(); ++p) {
    polygon.clear();
    for (const auto index : polygon_mesh.polygons[p].vertices) {
      if (static_cast<std::size_t>(index) >= vertices.size())
        return "polygon " + std::to_string(p) + " uses vertex " +
               std::to_string(index) + ", the mesh has " +
               std::to_string(vertices.size()) + " vertices";
      polygon.push_back(static_cast<std::uint32_t>(index));
    }
    triangulatePolygon(vertices, polygon, triangles);
  }
  mesh.vertices = std::move(vertices);
  mesh.triangles = std::move(triangles);
  reason = mesh.problem();
  if (!reason.empty())
    mesh = TriangleMesh();
  return reason;
}

void
toPolygonMesh(const TriangleMesh& mesh, pcl::PolygonMesh& polygon_mesh)
{
  pcl::PointCloud<pcl::PointXYZ> cloud;
  cloud.reserve(mesh.vertices.size());
  for (const Eigen::Vector3d& v : mesh.vertices)
    cloud.emplace_back(static_cast<float>(v.x()), static_cast<float>(v.y()),
                       static_cast<float>(v.z()));
  pcl::toPCLPointCloud2(cloud, polygon_mesh.cloud);
  polygon_mesh.polygons.resize(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    polygon_mesh.polygons[t].vertices.assign(mesh.triangles[t].begin(),
                                             mesh.triangles[t].end());
}

} // namespace pcl::sedr

PCL_INSTANTIATE(MeshReconstruction, SEDR_POINT_TYPES)
