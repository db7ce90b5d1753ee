// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_filters/src/base/field_access.h"
#include <pcl/PolygonMesh.h>
#include <pcl/common/io.h>
#include <pcl/conversions.h>
#include <pcl/point_types.h>
#include <pcl/sedr_surface/triangle_mesh.h>

namespace pcl::sedr {
namespace {

// Newell's normal, which is also correct for concave polygons.
Eigen::Vector3d
polygonNormal(const std::vector<Eigen::Vector3d>& vertices,
              const std::vector<std::uint32_t>& polygon)
{
  const Eigen::Vector3d& origin = vertices[polygon[0]];
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector3d a = vertices[polygon[i]] - origin;
    const Eigen::Vector3d b = vertices[polygon[(i + 1) % polygon.size()]] - origin;
    normal += a.cross(b);
  }
  return normal;
}

// Returns whether corner i of the remaining polygon can be clipped: it is convex and no
// other corner lies inside.
bool
isEar(const std::vector<Eigen::Vector3d>& vertices,
      const std::vector<std::uint32_t>& polygon,
      std::size_t i,
      const Eigen::Vector3d& normal)
{
  const std::size_t n = polygon.size();
  const std::uint32_t ia = polygon[(i + n - 1) % n];
  const std::uint32_t ib = polygon[i];
  const std::uint32_t ic = polygon[(i + 1) % n];
  const Eigen::Vector3d& a = vertices[ia];
  const Eigen::Vector3d& b = vertices[ib];
  const Eigen::Vector3d& c = vertices[ic];
  const auto side = [&normal](const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                              const Eigen::Vector3d& p) {
    return normal.dot((to - from).cross(p - from));
  };
  if (side(a, b, c) <= 0)
    return false;
  for (const auto other : polygon) {
    if (other == ia || other == ib || other == ic)
      continue;
    const Eigen::Vector3d& p = vertices[other];
    if (p == a || p == b || p == c)
      continue; // a bridge from a hole to the outline visits its ends twice
    if (side(a, b, p) >= 0 && side(b, c, p) >= 0 && side(c, a, p) >= 0)
      return false;
  }
  return true;
}

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

std::string
triangulatePolygon(const std::vector<Eigen::Vector3d>& vertices,
                   const std::vector<std::uint32_t>& polygon,
                   std::vector<Triangle>& triangles)
{
  constexpr std::size_t most = 1000;
  std::vector<std::uint32_t> rest = polygon;
  if (rest.size() > most)
    return "has a face of " + std::to_string(rest.size()) + " corners, more than " +
           std::to_string(most);
  if (rest.size() > 3) {
    const Eigen::Vector3d normal = polygonNormal(vertices, polygon);
    for (std::size_t i = 0; rest.size() > 3 && i < rest.size();) {
      if (!isEar(vertices, rest, i, normal)) {
        ++i;
        continue;
      }
      const std::size_t n = rest.size();
      triangles.push_back({rest[(i + n - 1) % n], rest[i], rest[(i + 1) % n]});
      rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
      i = 0;
    }
  }
  for (std::size_t i = 1; i + 1 < rest.size(); ++i)
    triangles.push_back({rest[0], rest[i], rest[i + 1]});
  return {};
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
    reason = triangulatePolygon(vertices, polygon, triangles);
    if (!reason.empty())
      return "the mesh " + reason;
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
