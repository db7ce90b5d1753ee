// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_filters/src/base/field_access.h"
#include "sedr_filters/src/base/labels.h"
#include "sedr_filters/src/base/number_text.h"

#include <pcl/sedr_surface/triangle_mesh.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
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

namespace {

using Json = nlohmann::ordered_json;

/** @brief Rotates z up to y up. */
Eigen::Vector3d
turned(const Eigen::Vector3d& p)
{
  return {p.x(), p.z(), -p.y()};
}

/** @brief Builds the file's JSON and its binary part. */
class GlbBuilder {
public:
  GlbBuilder(const TriangleMesh& mesh,
             const std::vector<SolidElement>& elements,
             const std::vector<SeenColour>& colours)
      : mesh_(mesh)
      , elements_(elements)
      , colours_(colours)
  {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      if (mesh.elements[t] > 0)
        triangles_of_[mesh.elements[t]].push_back(t);
    for (const auto& entry : triangles_of_)
      elements_of_[elements[entry.first - 1].room].push_back(entry.first);
  }

  std::string build(const std::vector<PlanStorey>& storeys, const Origin& origin)
  {
    json_["asset"] = {{"version", "2.0"}, {"generator", "SEDR"}};
    if (!origin.isZero())
      json_["asset"]["extras"]["origin"] = {origin.place.x(), origin.place.y(),
                                            origin.place.z()};
    json_["scene"] = 0;
    json_["scenes"] = Json::array({Json::object()});
    for (const char* list :
         {"nodes", "meshes", "accessors", "bufferViews", "materials"})
      json_[list] = Json::array();
    Json roots = Json::array();
    for (const PlanStorey& storey : storeys)
      roots.push_back(addStorey(storey));
    if (!roots.empty())
      json_["scenes"][0]["nodes"] = roots;
    for (const char* list :
         {"nodes", "meshes", "accessors", "bufferViews", "materials"})
      if (json_[list].empty()) // the schema forbids empty lists
        json_.erase(list);
    if (!bytes_.empty())
      json_["buffers"] = Json::array({{{"byteLength", bytes_.size()}}});
    return file();
  }

private:
  /** @brief Returns a channel as glTF has it, linear, of one that screens show. */
  static double linear(std::uint8_t channel)
  {
    const double c = channel / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  }

  /** @brief Appends a material that is called as the label.
   * @return its index */
  std::size_t writeMaterial(StructureLabel label, double red, double green, double blue)
  {
    json_["materials"].push_back({{"name", toString(label)},
                                  {"pbrMetallicRoughness",
                                   {{"baseColorFactor", {red, green, blue, 1.0}},
                                    {"metallicFactor", 0.0},
                                    {"roughnessFactor", 0.9}}},
                                  {"doubleSided", true}});
    return json_["materials"].size() - 1;
  }

  /** @brief Adds the index of the material of an element to a primitive: its own if it
   * has a colour, else that of its label, which is written with its first use. */
  void addMaterial(Json& primitive, std::uint32_t element)
  {
    const StructureLabel label = elements_[element - 1].label;
    if (!colours_.empty()) {
      const auto& [rgb, is_seen] = colours_[element - 1];
      primitive["material"] =
          writeMaterial(label, linear(rgb[0]), linear(rgb[1]), linear(rgb[2]));
      json_["materials"].back()["extras"]["seen"] = is_seen;
      return;
    }
    const auto* c =
        std::find_if(std::begin(label_colours), std::end(label_colours),
                     [&](const LabelColour& colour) { return colour.label == label; });
    if (c == std::end(label_colours))
      return;
    const auto known = material_of_.find(static_cast<std::uint32_t>(label));
    primitive["material"] = known != material_of_.end()
                                ? known->second
                                : material_of_[static_cast<std::uint32_t>(label)] =
                                      writeMaterial(label, c->red, c->green, c->blue);
  }

  std::size_t addNode(Json node)
  {
    json_["nodes"].push_back(std::move(node));
    return json_["nodes"].size() - 1;
  }

  std::size_t addStorey(const PlanStorey& storey)
  {
    Json rooms = Json::array();
    for (const std::uint32_t room : storey.rooms) {
      Json parts = Json::array();
      for (const std::uint32_t element : elements_of_[room])
        parts.push_back(addElement(element));
      if (!parts.empty())
        rooms.push_back(
            addNode({{"name", "room_" + std::to_string(room)}, {"children", parts}}));
    }
    Json node{{"name", "storey_" + std::to_string(storey.number)}};
    node["extras"]["name"] = storey.name;
    if (!rooms.empty())
      node["children"] = rooms;
    return addNode(node);
  }

  std::size_t addElement(std::uint32_t element)
  {
    const SolidElement& e = elements_[element - 1];
    const auto& triangles = triangles_of_[element];
    Eigen::AlignedBox3f box;
    std::map<std::uint32_t, std::uint32_t> number_of; // of a vertex within this element
    std::string corners;
    const std::size_t start = bytes_.size();
    for (const std::size_t t : triangles)
      for (const std::uint32_t vertex : mesh_.triangles[t]) {
        const auto number = static_cast<std::uint32_t>(number_of.size());
        const auto [entry, is_new] = number_of.emplace(vertex, number);
        appendBytes(corners, entry->second);
        if (!is_new)
          continue;
        const Eigen::Vector3f p = turned(mesh_.vertices[vertex]).cast<float>();
        box.extend(p);
        appendBytes(bytes_, std::array<float, 3>{p.x(), p.y(), p.z()});
      }
    const std::size_t place = addAccessor(start, number_of.size(), vertices);
    json_["accessors"][place]["min"] = {box.min().x(), box.min().y(), box.min().z()};
    json_["accessors"][place]["max"] = {box.max().x(), box.max().y(), box.max().z()};
    const std::size_t after = bytes_.size();
    bytes_ += corners;
    const std::size_t indices = addAccessor(after, 3 * triangles.size(), triangle_list);
    Json primitive{{"attributes", {{"POSITION", place}}}, {"indices", indices}};
    addMaterial(primitive, element);
    json_["meshes"].push_back(
        {{"name", e.name}, {"primitives", Json::array({primitive})}});
    return addNode({{"name", e.name}, {"mesh", json_["meshes"].size() - 1}});
  }

  struct Kind { ///< number type in glTF
    int target;
    int component;
    const char* type;
  };
  static constexpr Kind vertices{34962, 5126, "VEC3"}; ///< floats
  static constexpr Kind triangle_list{34963, 5125, "SCALAR"};

  /** @brief Adds an accessor for the bytes appended since `start`. */
  std::size_t addAccessor(std::size_t start, std::size_t count, const Kind& kind)
  {
    json_["bufferViews"].push_back({{"buffer", 0},
                                    {"byteOffset", start},
                                    {"byteLength", bytes_.size() - start},
                                    {"target", kind.target}});
    json_["accessors"].push_back({{"bufferView", json_["bufferViews"].size() - 1},
                                  {"componentType", kind.component},
                                  {"count", count},
                                  {"type", kind.type}});
    return json_["accessors"].size() - 1;
  }

  std::string file() const
  {
    constexpr std::uint32_t magic = 0x46546c67; // "glTF"
    constexpr std::uint32_t json_chunk = 0x4e4f534a;
    constexpr std::uint32_t binary_chunk = 0x004e4942;
    std::string text = json_.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const std::size_t binary = bytes_.empty() ? 0 : 8 + bytes_.size();
    std::string glb;
    appendBytes(glb, magic);
    appendBytes(glb, std::uint32_t{2});
    appendBytes(glb, static_cast<std::uint32_t>(12 + 8 + text.size() + binary));
    appendBytes(glb, static_cast<std::uint32_t>(text.size()));
    appendBytes(glb, json_chunk);
    glb += text;
    if (bytes_.empty())
      return glb;
    appendBytes(glb, static_cast<std::uint32_t>(bytes_.size())); // multiple of four
    appendBytes(glb, binary_chunk);
    return glb + bytes_;
  }

  const TriangleMesh& mesh_;
  const std::vector<SolidElement>& elements_;
  const std::vector<SeenColour>& colours_;
  std::map<std::uint32_t, std::vector<std::size_t>> triangles_of_;  ///< by element
  std::map<std::uint32_t, std::vector<std::uint32_t>> elements_of_; ///< by room
  std::map<std::uint32_t, std::size_t> material_of_;                ///< by label
  Json json_;
  std::string bytes_;
};

} // namespace

std::string
solidToGlb(const TriangleMesh& mesh,
           const std::vector<SolidElement>& elements,
           const std::vector<PlanStorey>& storeys,
           const Origin& origin,
           const std::vector<SeenColour>& colours)
{
  return GlbBuilder(mesh, elements, colours).build(storeys, origin);
}

} // namespace pcl::sedr
