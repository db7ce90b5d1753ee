// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/impl/pcl_base.hpp>
#include <pcl/kdtree/impl/kdtree_flann.hpp>
#include <pcl/search/impl/kdtree.hpp>
#include <pcl/search/impl/organized.hpp>
#include <pcl/search/impl/search.hpp>
#include <pcl/sedr_surface/floorplan_extrusion.h>
#include <pcl/sedr_surface/mesh_intersection.h>

#include <set>
#include <sstream>
#include <utility>

namespace pcl {

template <typename PointT>
FloorplanExtrusion<PointT>::FloorplanExtrusion()
{
  this->check_tree_ = false;
}

template <typename PointT>
FloorplanExtrusion<PointT>::~FloorplanExtrusion() = default;

template <typename PointT>
void
FloorplanExtrusion<PointT>::reconstruct(pcl::PolygonMesh& output)
{
  output = pcl::PolygonMesh();
  if (input_)
    output.header = input_->header;
  performReconstruction(output);
}

template <typename PointT>
void
FloorplanExtrusion<PointT>::reconstruct(PointCloud& points,
                                        std::vector<pcl::Vertices>& polygons)
{
  // The output may be the input: it is written only when all is read.
  const pcl::PCLHeader header = input_ ? input_->header : pcl::PCLHeader();
  PointCloud corners;
  polygons.clear();
  performReconstruction(corners, polygons);
  points.swap(corners);
  points.header = header;
}

template <typename PointT>
void
FloorplanExtrusion<PointT>::collectWarnings()
{
  for (const sedr::RoomSolidReport& report : reports_)
    for (const std::string& warning : report.warnings)
      warnings_.push_back("room " + std::to_string(report.room) + ": " + warning);
  std::set<std::pair<std::uint32_t, std::uint32_t>> crossing;
  for (const auto& [t, u] : sedr::findSelfIntersections(mesh_))
    crossing.insert({mesh_.rooms[t], mesh_.rooms[u]});
  for (const auto& [room, other] : crossing)
    warnings_.push_back(room == other
                            ? "room " + std::to_string(room) + " meets itself"
                            : "rooms " + std::to_string(room) + " and " +
                                  std::to_string(other) + " run into each other");
}

template <typename PointT>
std::string
FloorplanExtrusion<PointT>::inputProblem() const
{
  const auto check = [](double value, double low, double high, const char* name) {
    std::ostringstream text;
    if (!(value >= low && value <= high))
      text << "the " << name << " tolerance must lie from " << low << " to " << high
           << " m, it is " << value << " m";
    return text.str();
  };
  if (!plan_)
    return "no floor plan is set";
  if (plan_->rooms.empty())
    return "the floor plan has 0 rooms";
  const std::string problem = check(parameters_.chord_tolerance, 1e-6, 1, "chord");
  return problem.empty() ? check(parameters_.snap_tolerance, 0, 0.5, "snap") : problem;
}

template <typename PointT>
bool
FloorplanExtrusion<PointT>::run()
{
  clearError();
  mesh_ = sedr::TriangleMesh();
  elements_.clear();
  reports_.clear();
  warnings_.clear();
  closed_ = false;
  const std::string problem = inputProblem();
  if (!problem.empty())
    return fail("FloorplanExtrusion", problem);
  std::string failures;
  for (const sedr::PlanRoom& room : plan_->rooms) {
    sedr::TriangleMesh solid;
    reports_.push_back(sedr::extrudeRoom(room, parameters_, solid, elements_));
    mesh_.append(solid);
    if (!reports_.back().problem.empty())
      failures += (failures.empty() ? "room " : "; room ") + std::to_string(room.id) +
                  ": " + reports_.back().problem;
  }
  collectWarnings();
  closed_ = failures.empty();
  return closed_ || fail("FloorplanExtrusion", failures);
}

template <typename PointT>
void
FloorplanExtrusion<PointT>::performReconstruction(pcl::PolygonMesh& output)
{
  run();
  sedr::toPolygonMesh(mesh_, output);
}

template <typename PointT>
void
FloorplanExtrusion<PointT>::performReconstruction(PointCloud& points,
                                                  std::vector<pcl::Vertices>& polygons)
{
  run();
  std::vector<Eigen::Vector3d> normals(mesh_.vertices.size(), Eigen::Vector3d::Zero());
  points.resize(mesh_.vertices.size());
  polygons.resize(mesh_.triangles.size());
  for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
    const sedr::Triangle& triangle = mesh_.triangles[t];
    polygons[t].vertices.assign(triangle.begin(), triangle.end());
    for (const auto v : triangle) {
      normals[v] += mesh_.scaledNormal(t);
      if constexpr (pcl::traits::has_field<PointT, pcl::fields::room>::value)
        points[v].room = mesh_.rooms[t];
    }
  }
  for (std::size_t v = 0; v < mesh_.vertices.size(); ++v) {
    points[v].getVector3fMap() = mesh_.vertices[v].template cast<float>();
    if constexpr (pcl::traits::has_field<PointT, pcl::fields::normal_x>::value)
      points[v].getNormalVector3fMap() = normals[v].normalized().template cast<float>();
  }
}

} // namespace pcl
