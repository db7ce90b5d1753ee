// SPDX-License-Identifier: BSD-3-Clause
#include "point_report.h"

#include "results/distance_colour.h"
#include "scale.h"

#include "sedr_surface/src/mesh/triangle_tree.h"

#include <cmath>
#include <limits>

namespace pcl::sedr::tools {

namespace {

constexpr double farthest = 0.5; // metres; points farther away are ignored

/** @brief Describes label and room; empty if unknown. */
std::string
kindOf(const std::vector<std::uint32_t>& labels,
       const std::vector<std::uint32_t>& rooms,
       std::size_t i)
{
  std::string kind;
  if (!labels.empty())
    kind = toString(static_cast<StructureLabel>(labels[i]));
  if (!rooms.empty() && rooms[i] != 0)
    kind += (kind.empty() ? "room " : ", room ") + std::to_string(rooms[i]);
  return kind;
}

std::string
kindOfNearestPoint(const DisplayCloud& cloud, const Eigen::Vector3d& place)
{
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const double distance = (cloud.points[i].cast<double>() - place).squaredNorm();
    if (distance < least) {
      least = distance;
      nearest = i;
    }
  }
  return least > farthest * farthest ? "" : kindOf(cloud.labels, cloud.rooms, nearest);
}

/** @brief The triangle of a mesh nearest to a point. */
struct NearestTriangle {
  std::size_t triangle = 0;
  double distance = std::numeric_limits<double>::infinity(); ///< metres
};

NearestTriangle
nearestTriangle(const TriangleMesh& mesh, const Eigen::Vector3d& p)
{
  constexpr double same_distance = 1e-6; // metres
  NearestTriangle nearest;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const double distance = std::sqrt(squaredToTriangle(
        mesh.corner(t, 0) - p, mesh.corner(t, 1) - p, mesh.corner(t, 2) - p));
    if (distance < nearest.distance - same_distance)
      nearest = {t, distance};
  }
  return nearest;
}

std::string
kindOfNearestFace(const TriangleMesh& mesh, const Eigen::Vector3d& place)
{
  const auto nearest = nearestTriangle(mesh, place);
  return nearest.distance > farthest
             ? ""
             : kindOf(mesh.labels, mesh.rooms, nearest.triangle);
}

std::string
elementAt(const ViewedResult& result, const Eigen::Vector3d& place)
{
  const auto nearest = nearestTriangle(result.solid, place);
  if (nearest.distance > farthest || result.solid.elements.empty())
    return "";
  const auto name = result.solid_names.find(result.solid.elements[nearest.triangle]);
  return name == result.solid_names.end() ? "" : name->second;
}

} // namespace

std::string
reportPoint(const ViewedResult& result, const Eigen::Vector3d& place)
{
  std::string text = "x " + fixedText(place.x(), 3) + "  y " + fixedText(place.y(), 3) +
                     "  z " + fixedText(place.z(), 3) + " m";
  std::string kind = kindOfNearestPoint(result.structure, place);
  if (kind.empty())
    kind = kindOfNearestFace(result.mesh, place);
  text += ": " + (kind.empty() ? "nothing known" : kind);
  const std::string element = elementAt(result, place);
  if (!element.empty())
    text += ", " + element;
  if (!result.mesh.empty())
    text += ", " + distanceText(nearestTriangle(result.mesh, place).distance) +
            " from the mesh";
  return text;
}

} // namespace pcl::sedr::tools
