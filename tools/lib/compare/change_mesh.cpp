// SPDX-License-Identifier: BSD-3-Clause
#include "change_mesh.h"

#include "tool_error.h"
#include "bytes/whole_file.h"

#include <pcl/sedr_surface/floorplan_extrusion.h>

#include <cstdint>
#include <map>
#include <ostream>

namespace pcl::sedr::tools {

namespace {

struct ColouredTriangle {
  std::array<Eigen::Vector3d, 3> corners;
  Colour colour;
};

/** @brief Colours of elements by prefixes of their names: room_1_column_2 includes its
 * faces, room_1 the whole room. */
using NamedColours = std::map<std::string, Colour>;

const std::string step_name = "_floor_detail";

Colour
colourFor(const std::string& name, const NamedColours& colours, Colour otherwise)
{
  for (std::string part = name; !part.empty();) {
    const auto found = colours.find(part);
    if (found != colours.end())
      return found->second;
    // A step is part of its room, but not of the floor below it.
    const std::size_t step = part.rfind(step_name);
    const bool is_step =
        step != std::string::npos && step + step_name.size() == part.size();
    const std::size_t cut = is_step ? step : part.rfind('_');
    part.erase(cut == std::string::npos ? 0 : cut);
  }
  return otherwise;
}

/** @brief Adds the faces of a plan's solids. `keep_others` includes faces without a
 * colour of their own. */
void
addFaces(const Floorplan& plan,
         const NamedColours& colours,
         bool keep_others,
         std::vector<ColouredTriangle>& triangles)
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
    const Colour colour = colourFor(element.name, colours, change_colours::unchanged);
    if (keep_others || colour != change_colours::unchanged)
      triangles.push_back(
          {{mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)}, colour});
  }
}

template <typename ValueT>
void
put(std::ostream& stream, ValueT value)
{
  stream.write(reinterpret_cast<const char*>(&value), sizeof value);
}

void
writePly(std::ostream& stream, const std::vector<ColouredTriangle>& triangles)
{
  stream << "ply\nformat binary_little_endian 1.0\n"
         << "comment grey unchanged, green appeared, red vanished, orange moved\n"
         << "element vertex " << 3 * triangles.size()
         << "\nproperty double x\nproperty double y\nproperty double z\n"
         << "property uchar red\nproperty uchar green\nproperty uchar blue\n"
         << "element face " << triangles.size()
         << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const auto& triangle : triangles)
    for (const auto& corner : triangle.corners) {
      for (int k = 0; k < 3; ++k)
        put(stream, corner[k]);
      put(stream, triangle.colour.red);
      put(stream, triangle.colour.green);
      put(stream, triangle.colour.blue);
    }
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    put(stream, std::uint8_t{3});
    for (std::size_t k = 0; k < 3; ++k)
      put(stream, static_cast<std::int32_t>(3 * t + k));
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
  std::vector<ColouredTriangle> triangles;
  addFaces(after, now, true, triangles);
  addFaces(before, gone, false, triangles);
  writeWhole(path, [&](std::ostream& stream) { writePly(stream, triangles); });
}

} // namespace pcl::sedr::tools
