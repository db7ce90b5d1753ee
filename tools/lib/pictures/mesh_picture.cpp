// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_picture.h"

#include "map_cells.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

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

  Eigen::Vector2d see(const Eigen::Vector3d& p) const
  {
    return {p.dot(right), p.dot(up)};
  }
};

Colour
shaded(Colour colour, const Eigen::Vector3d& normal, const Viewer& viewer)
{
  const Eigen::Vector3d light = (viewer.towards - 0.5 * viewer.right).normalized();
  return darkened(colour, 0.35 * (1 - std::max(0.0, normal.dot(light))));
}

/** @brief Triangles seen by a viewer, to be drawn from the farthest to the nearest
 * (painter's algorithm); large ones in pieces, so that their middles tell the order. */
class SeenTriangles {
public:
  SeenTriangles(const Viewer& viewer, double largest)
      : viewer_(viewer)
      , largest_(largest)
  {}

  /** @param nearer metres that it is drawn nearer than it is */
  void add(const std::array<Eigen::Vector3d, 3>& corners, Colour colour, double nearer)
  {
    std::size_t longest = 0;
    double most = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double length = (corners[(k + 1) % 3] - corners[k]).norm();
      if (length > most) {
        most = length;
        longest = k;
      }
    }
    const Eigen::Vector3d& a = corners[longest];
    const Eigen::Vector3d& b = corners[(longest + 1) % 3];
    const Eigen::Vector3d& c = corners[(longest + 2) % 3];
    if (most > largest_) {
      add({a, (a + b) / 2, c}, colour, nearer);
      add({(a + b) / 2, b, c}, colour, nearer);
      return;
    }
    const double depth = -(a + b + c).dot(viewer_.towards) / 3 - nearer;
    triangles_.push_back(
        {depth, {colour.number(), {viewer_.see(a), viewer_.see(b), viewer_.see(c)}}});
  }

  /** @brief Adds a line in space as a ribbon just in front of its surface. */
  void addLine(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double width)
  {
    const Eigen::Vector3d side = width / 2 * viewer_.towards.cross(b - a).normalized();
    add({a + side, b + side, b - side}, colours::ink, 2 * width);
    add({a + side, b - side, a - side}, colours::ink, 2 * width);
  }

  std::vector<SheetTriangle> farthestFirst()
  {
    std::stable_sort(triangles_.begin(), triangles_.end(),
                     [](const Seen& a, const Seen& b) { return a.depth > b.depth; });
    std::vector<SheetTriangle> sorted;
    for (const Seen& seen : triangles_)
      sorted.push_back(seen.triangle);
    return sorted;
  }

private:
  struct Seen {
    double depth;
    SheetTriangle triangle;
  };

  const Viewer& viewer_;
  double largest_;
  std::vector<Seen> triangles_;
};

/** @brief Draws the triangles that face the viewer, and dark lines at their borders. */
Panel
viewPanel(const std::string& title, const TriangleMesh& mesh, const Viewer& viewer)
{
  const double extent = mesh.empty() ? 1 : mesh.bounds().sizes().maxCoeff();
  SeenTriangles seen(viewer, extent / 40);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Eigen::Vector3d normal = mesh.scaledNormal(t).normalized();
    if (!(normal.dot(viewer.towards) > 0))
      continue;
    const auto label = mesh.labels.empty()
                           ? StructureLabel::Wall
                           : static_cast<StructureLabel>(mesh.labels[t]);
    seen.add({mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)},
             shaded(colourOf(label), normal, viewer), 0);
    for (std::size_t k = 0; k < 3; ++k)
      edges.push_back(
          std::minmax(mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]));
  }
  std::sort(edges.begin(), edges.end());
  for (auto first = edges.begin(); first != edges.end();) {
    const auto last = std::find_if(first, edges.end(),
                                   [&](const auto& other) { return other != *first; });
    if (last - first == 1)
      seen.addLine(mesh.vertices[first->first], mesh.vertices[first->second],
                   extent / 350);
    first = last;
  }
  Panel panel(title);
  panel.addTriangles(seen.farthestFirst());
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
