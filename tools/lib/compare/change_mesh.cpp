// SPDX-License-Identifier: BSD-3-Clause
#include "change_mesh.h"

#include "tool_error.h"

#include <pcl/conversions.h>
#include <pcl/io/ply_io.h>
#include <pcl/point_types.h>
#include <pcl/sedr_surface/floorplan_extrusion.h>

#include <cstdint>
#include <map>

namespace pcl::sedr::tools {

namespace {

/** @brief Colours of elements by their names or the beginnings of them: room_1_column_2
 * includes its faces, room_1 the whole room. */
using NamedColours = std::map<std::string, Colour>;

Colour
colourFor(const std::string& name, const NamedColours& colours)
{
  Colour colour = change_colours::unchanged;
  for (const auto& [part, own] : colours) { // in this order longer names come later
    const bool begins = (name + "_").compare(0, part.size() + 1, part + "_") == 0;
    // A step, "_floor_detail_1", is part of its room, but not of the floor around it.
    const std::string step = part + "_detail";
    const bool is_floor = part.size() > 6 && part.substr(part.size() - 6) == "_floor";
    if (begins && !(is_floor && name.compare(0, step.size(), step) == 0))
      colour = own;
  }
  return colour;
}

/** @brief Adds the faces of a plan's solids, each with corners of its own.
 * `keep_others` includes faces without a colour of their own. */
void
addFaces(const Floorplan& plan,
         const NamedColours& colours,
         bool keep_others,
         pcl::PointCloud<pcl::PointXYZRGB>& corners)
{
  if (plan.rooms.empty())
    return;
  pcl::FloorplanExtrusion<pcl::PointXYZ> extrusion;
  extrusion.setFloorplan(plan);
  pcl::PolygonMesh unused;
  extrusion.reconstruct(unused);
  const TriangleMesh& mesh = extrusion.getMesh();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& element = extrusion.getElements()[mesh.elements[t] - 1];
    const Colour colour = colourFor(element.name, colours);
    for (int k = 0; k < 3 && (keep_others || colour != change_colours::unchanged);
         ++k) {
      corners.emplace_back(colour.red, colour.green, colour.blue);
      corners.back().getVector3fMap() = mesh.corner(t, k).cast<float>();
    }
  }
}

} // namespace

void
saveChangeMesh(const std::string& path,
               const Floorplan& before,
               const Floorplan& after,
               const std::vector<Change>& changes)
{
  NamedColours gone;
  NamedColours now;
  for (const auto& change : changes) {
    if (change.kind == ChangeKind::Vanished)
      for (const auto& name : change.before)
        gone[name] = change_colours::vanished;
    const Colour colour = change.kind == ChangeKind::Moved ? change_colours::moved
                                                           : change_colours::appeared;
    for (const auto& name : change.after)
      now[name] = colour;
  }
  pcl::PointCloud<pcl::PointXYZRGB> corners;
  addFaces(after, now, true, corners);
  addFaces(before, gone, false, corners);
  pcl::PolygonMesh mesh;
  pcl::toPCLPointCloud2(corners, mesh.cloud);
  for (std::uint32_t k = 0; k + 2 < corners.size(); k += 3) {
    mesh.polygons.emplace_back();
    for (std::uint32_t corner = k; corner < k + 3; ++corner)
      mesh.polygons.back().vertices.push_back(static_cast<int>(corner));
  }
  if (pcl::io::savePLYFileBinary(path, mesh) != 0)
    throw ToolError("cannot write '" + path + "'");
}

} // namespace pcl::sedr::tools
