// SPDX-License-Identifier: BSD-3-Clause
#include "page_parts.h"
#include "results/display_cloud.h"
#include "scan_file.h"

#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_surface/mesh_evaluation.h>
#include <pcl/sedr_surface/triangle_mesh.h>
#include <vtkBase64Utilities.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkQuadricClustering.h>
#include <vtkUnsignedIntArray.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace pcl::sedr::tools {

namespace {

constexpr std::size_t max_points = 250000;
constexpr double around = 1.0;   // metres of a scan beside the model
constexpr double farthest = 0.5; // in the picture of distances, metres
constexpr std::uint8_t beyond = 255;

/** @brief Orders points: those below the ceilings first. Points outside the box are
 * left out.
 * @param below set to their number */
std::vector<Eigen::Vector3d>
orderedPoints(const DisplayCloud& cloud,
              const PlanRules& rules,
              const Eigen::AlignedBox3d& box,
              std::size_t& below)
{
  std::vector<Eigen::Vector3d> points;
  std::vector<Eigen::Vector3d> ceilings;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d place = cloud.points[i].cast<double>();
    if (box.contains(place))
      (rules.isCeiling(cloud.label(i), cloud.room(i), place) ? ceilings : points)
          .push_back(place);
  }
  below = points.size();
  points.insert(points.end(), ceilings.begin(), ceilings.end());
  return points;
}

std::string
placesText(const std::vector<Eigen::Vector3d>& points, const Eigen::AlignedBox3d& box)
{
  constexpr double most = 65535;
  std::vector<std::uint16_t> places;
  places.reserve(3 * points.size());
  for (const Eigen::Vector3d& p : points)
    for (int axis = 0; axis < 3; ++axis)
      places.push_back(static_cast<std::uint16_t>(std::lround(
          most * (p[axis] - box.min()[axis]) / std::max(1e-9, box.sizes()[axis]))));
  return base64(places.data(), places.size() * sizeof(std::uint16_t));
}

std::string
distancesText(const std::vector<Eigen::Vector3d>& points,
              const TriangleMesh& mesh,
              double range)
{
  std::vector<std::uint8_t> steps;
  steps.reserve(points.size());
  for (const double distance : MeshDistance(mesh).distances(points)) {
    const double step =
        std::min<double>(distance_steps * distance / range, distance_steps);
    steps.push_back(distance > farthest ? beyond
                                        : static_cast<std::uint8_t>(std::lround(step)));
  }
  return base64(steps.data(), steps.size());
}

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
base64(const void* bytes, std::size_t size)
{
  std::vector<unsigned char> text(4 * ((size + 2) / 3) + 4);
  const auto length = vtkBase64Utilities::Encode(
      static_cast<const unsigned char*>(bytes), size, text.data());
  return {text.begin(), text.begin() + static_cast<std::ptrdiff_t>(length)};
}

ResultFolder::Json
pagePoints(const ResultFolder& folder,
           const std::string& path,
           const Floorplan& plan,
           const TriangleMesh& mesh,
           const TriangleMesh& solid,
           double range)
{
  const bool is_scan = !path.empty();
  if (!is_scan && !folder.has("structure.pcd"))
    return nullptr;
  const ScanFile scan(is_scan ? path : folder.file("structure.pcd"),
                      is_scan ? folder.scanSettings() : ScanSettings{});
  const DisplayCloud cloud = thinnedCloudOf(scan, folder.voxelSize() / 2, max_points);
  Eigen::AlignedBox3d box = mesh.empty() ? solid.bounds() : mesh.bounds();
  for (std::size_t i = 0; box.isEmpty() && i < cloud.size(); ++i)
    box.extend(cloud.points[i].cast<double>());
  box = {box.min().array() - around, box.max().array() + around};
  std::size_t below = 0;
  const auto points = orderedPoints(cloud, PlanRules(plan), box, below);
  if (points.empty())
    return nullptr;
  ResultFolder::Json json{{"is_scan", is_scan},
                          {"points", scan.size()},
                          {"count", points.size()},
                          {"below", below},
                          {"spacing", cloud.spacing},
                          {"low", {box.min().x(), box.min().y(), box.min().z()}},
                          {"high", {box.max().x(), box.max().y(), box.max().z()}},
                          {"places", placesText(points, box)}};
  if (!mesh.empty())
    json["distances"] = distancesText(points, mesh, range);
  return json;
}

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
