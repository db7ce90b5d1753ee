// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_picture.h"

#include "map_cells.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

namespace pcl::sedr::tools {

namespace {

/** @brief An orthographic viewer; horizontal lengths are true. */
struct Viewer {
  Eigen::Vector3d towards; ///< unit, from the mesh to the viewer
  Eigen::Vector3d right;
  Eigen::Vector3d up;

  /** @param azimuth,elevation of the viewer, degrees */
  Viewer(double azimuth, double elevation)
  {
    const double a = azimuth * M_PI / 180;
    const double e = elevation * M_PI / 180;
    towards = {std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)};
    right = Eigen::Vector3d::UnitZ().cross(towards).normalized();
    up = towards.cross(right);
  }

  Eigen::Vector3d see(const Eigen::Vector3d& p) const
  {
    return {p.dot(right), p.dot(up), -p.dot(towards)};
  }
};

Colour
shaded(Colour colour, const Eigen::Vector3d& normal, const Viewer& viewer)
{
  const Eigen::Vector3d light = (viewer.towards - 0.5 * viewer.right).normalized();
  const double brightness = 0.65 + 0.35 * std::max(0.0, normal.dot(light));
  return darkened(colour, 1 - brightness);
}

/** @brief Adds a line in space as a ribbon in the viewer's plane, slightly in front of
 * its surface. */
void
addRibbon(const Eigen::Vector3d& a,
          const Eigen::Vector3d& b,
          double width,
          std::vector<ViewedTriangle>& triangles)
{
  const Eigen::Vector2d way = (b - a).head<2>();
  if (!(way.norm() > 0))
    return;
  Eigen::Vector3d side(-way.y(), way.x(), 0);
  side *= width / 2 / way.norm();
  const Eigen::Vector3d before(0, 0, -width);
  const Eigen::Vector3d corners[] = {a + side + before, b + side + before,
                                     b - side + before, a - side + before};
  triangles.push_back({{corners[0], corners[1], corners[2]}, colours::ink});
  triangles.push_back({{corners[0], corners[2], corners[3]}, colours::ink});
}

/** @brief Returns the triangles that face the viewer, and dark lines at their
 * borders. */
std::vector<ViewedTriangle>
facing(const TriangleMesh& mesh, const Viewer& viewer, double line_width)
{
  std::vector<ViewedTriangle> triangles;
  using Edge = std::tuple<std::uint32_t, std::uint32_t>;
  std::set<Edge> open; // edges of a single visible triangle
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Eigen::Vector3d normal = mesh.scaledNormal(t).normalized();
    if (!(normal.dot(viewer.towards) > 0))
      continue;
    const auto label = mesh.labels.empty()
                           ? StructureLabel::Wall
                           : static_cast<StructureLabel>(mesh.labels[t]);
    ViewedTriangle seen;
    for (int k = 0; k < 3; ++k)
      seen.corners[static_cast<std::size_t>(k)] = viewer.see(mesh.corner(t, k));
    seen.colour = shaded(colourOf(label), normal, viewer);
    triangles.push_back(seen);
    for (std::size_t k = 0; k < 3; ++k) {
      const Edge edge =
          std::minmax(mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]);
      if (!open.insert(edge).second)
        open.erase(edge);
    }
  }
  for (const auto& [a, b] : open)
    addRibbon(viewer.see(mesh.vertices[a]), viewer.see(mesh.vertices[b]), line_width,
              triangles);
  return triangles;
}

Panel
viewPanel(const std::string& title, const TriangleMesh& mesh, const Viewer& viewer)
{
  const double extent = mesh.empty() ? 1 : mesh.bounds().sizes().maxCoeff();
  Panel panel(title);
  panel.addTriangles(facing(mesh, viewer, extent / 350));
  return panel;
}

} // namespace

Picture
drawMesh(const TriangleMesh& mesh)
{
  const std::set<std::uint32_t> rooms(mesh.rooms.begin(), mesh.rooms.end());
  Picture picture("Mesh of " + counted(std::max<std::size_t>(1, rooms.size()), "room") +
                  ": " + counted(mesh.triangles.size(), "triangle"));
  picture.addMaps({viewPanel("from above, the ceilings left out", mesh, {235, 50}),
                   viewPanel("from below, the floors left out", mesh, {235, -40})});
  for (const auto label :
       {StructureLabel::Ceiling, StructureLabel::Floor, StructureLabel::Wall,
        StructureLabel::Detail, StructureLabel::Column})
    picture.addLegend(toString(label), colourOf(label));
  picture.addNote("The bars measure lengths from left to right.");
  return picture;
}

} // namespace pcl::sedr::tools
