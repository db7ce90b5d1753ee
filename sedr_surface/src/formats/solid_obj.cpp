// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_filters/src/base/labels.h"
#include "sedr_filters/src/base/number_text.h"

#include <pcl/sedr_surface/mesh_io.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <sstream>

namespace pcl::sedr {

namespace {

/** @brief Returns the triangles sorted by element. */
std::vector<std::size_t>
byElement(const TriangleMesh& mesh)
{
  std::vector<std::size_t> order(mesh.triangles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t t, std::size_t u) {
    return mesh.elements[t] < mesh.elements[u];
  });
  return order;
}

} // namespace

std::string
solidToObj(const TriangleMesh& mesh,
           const std::vector<SolidElement>& elements,
           const std::string& material_file,
           const std::map<std::uint32_t, std::uint32_t>& storey_of)
{
  std::ostringstream obj;
  obj << "# metres, z up, faces outwards\n";
  if (!material_file.empty())
    obj << "mtllib " << material_file << '\n';
  for (const Eigen::Vector3d& v : mesh.vertices)
    obj << "v " << shortDecimalText(v.x(), 7) << ' ' << shortDecimalText(v.y(), 7)
        << ' ' << shortDecimalText(v.z(), 7) << '\n';
  std::uint32_t room = 0;
  std::uint32_t element = 0;
  for (const std::size_t t : byElement(mesh)) {
    if (mesh.rooms[t] != room)
      obj << "o room_" << mesh.rooms[t] << '\n';
    room = mesh.rooms[t];
    if (mesh.elements[t] != element) {
      const SolidElement& e = elements[mesh.elements[t] - 1];
      obj << "g " << e.name << " room_" << e.room;
      const auto storey = storey_of.find(e.room);
      if (storey != storey_of.end())
        obj << " storey_" << storey->second;
      obj << "\nusemtl " << toString(e.label) << '\n';
    }
    element = mesh.elements[t];
    obj << 'f';
    for (const auto v : mesh.triangles[t])
      obj << ' ' << v + 1;
    obj << '\n';
  }
  return obj.str();
}

std::string
solidMaterials()
{
  std::ostringstream mtl;
  mtl << "# by label\n";
  for (const LabelColour& c : label_colours)
    mtl << "newmtl " << toString(c.label) << "\nKa 0 0 0\nKd " << decimalText(c.red, 2)
        << ' ' << decimalText(c.green, 2) << ' ' << decimalText(c.blue, 2)
        << "\nKs 0 0 0\nd 1\nillum 1\n";
  return mtl.str();
}

std::vector<std::string>
elementComments(const TriangleMesh& mesh, const std::vector<SolidElement>& elements)
{
  std::vector<std::string> comments;
  for (const std::uint32_t e :
       std::set<std::uint32_t>(mesh.elements.begin(), mesh.elements.end()))
    if (e > 0)
      comments.push_back("element " + std::to_string(e) + " " + elements[e - 1].name);
  return comments;
}

} // namespace pcl::sedr
