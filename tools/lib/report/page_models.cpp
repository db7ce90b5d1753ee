// SPDX-License-Identifier: BSD-3-Clause
#include "page_parts.h"

#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_surface/mesh_io.h>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkQuadricClustering.h>
#include <vtkUnsignedIntArray.h>

#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace pcl::sedr::tools {

namespace {

/** @brief Returns the triangles of a room, with their labels as scalars. */
vtkNew<vtkPolyData>
roomSurface(const TriangleMesh& mesh, std::uint32_t room)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkUnsignedIntArray> labels;
  std::map<std::uint32_t, vtkIdType> number_of;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!mesh.rooms.empty() && mesh.rooms[t] != room)
      continue;
    triangles->InsertNextCell(3);
    for (const std::uint32_t v : mesh.triangles[t]) {
      const auto [known, is_new] = number_of.emplace(v, points->GetNumberOfPoints());
      if (is_new)
        points->InsertNextPoint(mesh.vertices[v].data());
      triangles->InsertCellPoint(known->second);
    }
    labels->InsertNextValue(mesh.labels.empty() ? 0 : mesh.labels[t]);
  }
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(points);
  surface->SetPolys(triangles);
  surface->GetCellData()->SetScalars(labels);
  return surface;
}

/** @brief Clusters the vertices of a room's surface in cells of some metres. */
TriangleMesh
clustered(vtkPolyData* surface, std::uint32_t room, double size)
{
  vtkNew<vtkQuadricClustering> clustering;
  clustering->SetInputData(surface);
  clustering->AutoAdjustNumberOfDivisionsOff();
  clustering->SetDivisionOrigin(0, 0, 0);
  clustering->SetDivisionSpacing(size, size, size);
  clustering->UseInputPointsOn();
  clustering->CopyCellDataOn();
  clustering->Update();
  vtkPolyData* coarse = clustering->GetOutput();
  auto* labels = coarse->GetCellData()->GetScalars();
  TriangleMesh mesh;
  for (vtkIdType i = 0; i < coarse->GetNumberOfPoints(); ++i)
    mesh.vertices.emplace_back(Eigen::Vector3d::Map(coarse->GetPoint(i)));
  for (vtkIdType t = 0; t < coarse->GetNumberOfCells(); ++t) {
    vtkIdType size_of_cell = 0;
    const vtkIdType* corners = nullptr;
    coarse->GetPolys()->GetCellAtId(t, size_of_cell, corners);
    if (size_of_cell != 3)
      continue;
    mesh.triangles.push_back({static_cast<std::uint32_t>(corners[0]),
                              static_cast<std::uint32_t>(corners[1]),
                              static_cast<std::uint32_t>(corners[2])});
    mesh.labels.push_back(static_cast<std::uint32_t>(labels->GetTuple1(t)));
    mesh.rooms.push_back(room);
  }
  return mesh;
}

} // namespace

std::string
meshToGlb(TriangleMesh mesh, const Floorplan& plan)
{
  std::vector<SolidElement> elements;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> number_of;
  std::set<std::uint32_t> rooms;
  mesh.labels.resize(mesh.triangles.size(), 0);
  mesh.rooms.resize(mesh.triangles.size(), 0);
  mesh.elements.clear();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto next = static_cast<std::uint32_t>(elements.size() + 1);
    const auto [entry, is_new] =
        number_of.emplace(std::make_pair(mesh.rooms[t], mesh.labels[t]), next);
    mesh.elements.push_back(entry->second);
    if (!is_new)
      continue;
    rooms.insert(mesh.rooms[t]);
    const auto label = static_cast<StructureLabel>(mesh.labels[t]);
    elements.push_back(
        {mesh.rooms[t], label,
         "room_" + std::to_string(mesh.rooms[t]) + "_" + toString(label)});
  }
  std::vector<PlanStorey> storeys = storeysOf(plan);
  for (const PlanStorey& storey : storeys)
    for (const std::uint32_t room : storey.rooms)
      rooms.erase(room);
  if (!rooms.empty()) { // that the plan lacks
    storeys.emplace_back();
    storeys.back().name = "no storey";
    storeys.back().rooms.assign(rooms.begin(), rooms.end());
  }
  return solidToGlb(mesh, elements, storeys);
}

TriangleMesh
reducedMesh(const TriangleMesh& mesh, std::size_t most)
{
  if (mesh.triangles.size() <= most)
    return mesh;
  std::set<std::uint32_t> rooms(mesh.rooms.begin(), mesh.rooms.end());
  if (rooms.empty())
    rooms.insert(0);
  constexpr double growth = 1.2;
  // A plane in cells of size s has two triangles per cell.
  double size = std::sqrt(2 * mesh.area() / static_cast<double>(most));
  for (;; size *= growth) {
    TriangleMesh reduced;
    for (const std::uint32_t room : rooms)
      reduced.append(clustered(roomSurface(mesh, room), room, size));
    if (reduced.triangles.size() <= most)
      return reduced;
  }
}

} // namespace pcl::sedr::tools
