// SPDX-License-Identifier: BSD-3-Clause
#include "stage_pictures.h"

#include <algorithm>
#include <set>
#include <utility>

namespace pcl::sedr::tools {
namespace {

/** @brief Draws the triangles that face a viewer, from the farthest to the nearest
 * (painter's algorithm); large ones in pieces, so that their middles tell the order.
 * @param azimuth,elevation of the viewer, degrees */
Panel
seenFrom(const std::string& title,
         const TriangleMesh& mesh,
         double azimuth,
         double elevation)
{
  const double a = azimuth * M_PI / 180;
  const double e = elevation * M_PI / 180;
  const Eigen::Vector3d towards(std::cos(e) * std::cos(a), std::cos(e) * std::sin(a),
                                std::sin(e));
  const Eigen::Vector3d right = Eigen::Vector3d::UnitZ().cross(towards).normalized();
  const Eigen::Vector3d up = towards.cross(right);
  const Eigen::Vector3d light = (towards - 0.5 * right).normalized();
  const double largest = mesh.empty() ? 1 : mesh.bounds().sizes().maxCoeff() / 40;
  std::vector<std::pair<double, SheetTriangle>> seen; // by nearness
  std::vector<std::pair<std::array<Eigen::Vector3d, 3>, Colour>> pieces;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Eigen::Vector3d normal = mesh.scaledNormal(t).normalized();
    if (!(normal.dot(towards) > 0))
      continue;
    const auto label =
        static_cast<StructureLabel>(mesh.labels.empty() ? 3 // wall
                                                        : mesh.labels[t]);
    pieces.push_back(
        {{mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)},
         darkened(colourOf(label), 0.35 * (1 - std::max(0.0, normal.dot(light))))});
  }
  while (!pieces.empty()) {
    auto [corners, colour] = pieces.back();
    pieces.pop_back();
    const auto length = [&, &corners = corners](std::size_t k) {
      return (corners[(k + 1) % 3] - corners[k]).norm();
    };
    std::size_t longest = length(1) > length(0) ? 1 : 0;
    longest = length(2) > length(longest) ? 2 : longest;
    std::rotate(corners.begin(), corners.begin() + longest, corners.end());
    const auto& [p, q, r] = corners;
    if ((q - p).norm() > largest) {
      pieces.push_back({{p, (p + q) / 2, r}, colour});
      pieces.push_back({{(p + q) / 2, q, r}, colour});
      continue;
    }
    SheetTriangle triangle{colour.number(), {}};
    for (std::size_t k = 0; k < 3; ++k)
      triangle.corners[k] = {corners[k].dot(right), corners[k].dot(up)};
    seen.emplace_back((p + q + r).dot(towards), triangle);
  }
  std::stable_sort(seen.begin(), seen.end(),
                   [](const auto& f, const auto& g) { return f.first < g.first; });
  std::vector<SheetTriangle> farthest_first;
  for (const auto& [nearness, triangle] : seen)
    farthest_first.push_back(triangle);
  Panel panel(title);
  panel.addTriangles(farthest_first);
  return panel;
}

} // namespace

Picture
drawMesh(const TriangleMesh& mesh)
{
  const std::size_t rooms =
      std::set<std::uint32_t>(mesh.rooms.begin(), mesh.rooms.end()).size();
  Picture picture("Mesh of " + counted(std::max<std::size_t>(1, rooms), "room") + ": " +
                  counted(mesh.triangles.size(), "triangle"));
  picture.addMaps({seenFrom("from above, the ceilings left out", mesh, 235, 50),
                   seenFrom("from below, the floors left out", mesh, 235, -40)});
  for (const auto label :
       {StructureLabel::Ceiling, StructureLabel::Floor, StructureLabel::Wall,
        StructureLabel::Detail, StructureLabel::Column})
    picture.addLegend(toString(label), colourOf(label));
  picture.addNote("The bars measure lengths from left to right.");
  return picture;
}

} // namespace pcl::sedr::tools
