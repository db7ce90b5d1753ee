// SPDX-License-Identifier: BSD-3-Clause
#include "page_parts.h"

#include "results/display_cloud.h"
#include "results/plan_rules.h"
#include "scan_file.h"

#include <pcl/sedr_surface/mesh_evaluation.h>

#include <vtkBase64Utilities.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
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

} // namespace pcl::sedr::tools
