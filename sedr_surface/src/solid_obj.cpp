// SPDX-License-Identifier: BSD-3-Clause
#include "decimal_text.h"

#include <pcl/sedr_surface/solid_obj.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <sstream>

namespace pcl {
namespace sedr {

namespace {

/** @brief The triangles in the order of their elements. */
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
           const std::string& material_file)
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
      obj << "g " << e.name << "\nusemtl " << toString(e.label) << '\n';
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
  struct Material {
    StructureLabel label;
    const char* colour; ///< red, green and blue from 0 to 1
  };
  constexpr Material materials[] = {{StructureLabel::Ceiling, "0.93 0.93 0.90"},
                                    {StructureLabel::Floor, "0.72 0.58 0.42"},
                                    {StructureLabel::Wall, "0.82 0.84 0.86"},
                                    {StructureLabel::Detail, "0.42 0.62 0.78"},
                                    {StructureLabel::Column, "0.80 0.45 0.35"}};
  std::ostringstream mtl;
  mtl << "# by label\n";
  for (const Material& m : materials)
    mtl << "newmtl " << toString(m.label) << "\nKa 0 0 0\nKd " << m.colour
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

} // namespace sedr
} // namespace pcl
