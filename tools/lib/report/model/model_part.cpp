// SPDX-License-Identifier: BSD-3-Clause
#include "model_part.h"

#include "map_cells.h"
#include "mesh_reduction.h"
#include "report/page/html_text.h"
#include "report/page/page_files.h"
#include "results/distance_colour.h"

#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_surface/mesh_io.h>

#include <fstream>
#include <iterator>
#include <map>
#include <set>

namespace pcl::sedr::tools {

namespace {

/** @brief Writes a mesh without elements as glTF for the page, with one element per
 * room and label. Rooms missing from the plan are put on a separate storey.
 * @param mesh triangles face into the rooms; in glTF they face outwards */
std::string
meshToGlb(TriangleMesh mesh, const Floorplan& plan)
{
  mesh.flip();
  std::vector<SolidElement> elements;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> number_of;
  std::set<std::uint32_t> rooms;
  mesh.elements.clear();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::uint32_t room = mesh.rooms.empty() ? 0 : mesh.rooms[t];
    const std::uint32_t label = mesh.labels.empty() ? 0 : mesh.labels[t];
    const auto next = static_cast<std::uint32_t>(elements.size() + 1);
    const auto [entry, is_new] = number_of.emplace(std::make_pair(room, label), next);
    mesh.elements.push_back(entry->second);
    if (!is_new)
      continue;
    rooms.insert(room);
    SolidElement element;
    element.label = static_cast<StructureLabel>(label);
    element.room = room;
    element.name = "room_" + std::to_string(room) + "_" + toString(element.label);
    elements.push_back(element);
  }
  std::vector<PlanStorey> storeys = storeysOf(plan);
  for (const PlanStorey& storey : storeys)
    for (const std::uint32_t room : storey.rooms)
      rooms.erase(room);
  if (!rooms.empty()) {
    storeys.emplace_back();
    storeys.back().number = 0;
    storeys.back().name = "no storey";
    storeys.back().rooms.assign(rooms.begin(), rooms.end());
  }
  return solidToGlb(mesh, elements, storeys);
}

std::string
textOfFile(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/** @brief Returns the scripts of three.js; empty if one is missing or contains an end
 * tag of its element. */
std::string
threeScripts(const std::string& folder)
{
  std::string scripts = "<!-- three.js: MIT licence, copyright its authors, "
                        "https&#58;//threejs.org -->\n";
  for (const char* name : {"/three.min.js", "/examples/js/controls/OrbitControls.js",
                           "/examples/js/loaders/GLTFLoader.js"}) {
    const std::string text = textOfFile(folder + name);
    if (text.empty() || text.find("</script") != std::string::npos)
      return "";
    scripts += "<script>" + text + "</script>\n";
  }
  return scripts;
}

/** @brief Returns the colours of labels, by name, and of rooms, as JSON. */
std::string
palettes()
{
  constexpr std::uint32_t labels = 6;
  constexpr std::size_t rooms = 12;
  std::string by_label;
  for (std::uint32_t k = 0; k < labels; ++k) {
    const auto label = static_cast<StructureLabel>(k);
    by_label += (k == 0 ? "\"" : ",\"") + std::string(toString(label)) + "\":\"" +
                hexCode(colourOf(label)) + "\"";
  }
  std::string of_rooms;
  for (std::size_t k = 0; k < rooms; ++k)
    of_rooms += (k == 0 ? "\"" : ",\"") + hexCode(colourNumber(k)) + "\"";
  return "{\"labels\":{" + by_label + "},\"rooms\":[" + of_rooms + "]}";
}

/** @brief Embeds a glTF in the page. */
std::string
embedded(const std::string& name, const std::string& glb)
{
  return "<script type=\"model/gltf-binary\" class=\"model\" data-name=\"" + name +
         "\">" + base64(glb) + "</script>\n";
}

std::string
radio(const char* name, const char* value, const char* text, bool is_checked)
{
  return std::string("<label><input type=\"radio\" name=\"") + name + "\" value=\"" +
         value + "\"" + (is_checked ? " checked" : "") + "> " + text + "</label>\n";
}

std::string
controls(bool has_solid, bool has_mesh)
{
  std::string html = "<div class=\"controls\" id=\"view-controls\" hidden>\n";
  if (has_solid && has_mesh)
    html += "<fieldset><legend>model</legend>\n" +
            radio("model", "solid", "sharp solid", true) +
            radio("model", "mesh", "Poisson mesh", false) + "</fieldset>\n";
  html += "<label><input type=\"checkbox\" id=\"ceiling\"> ceilings</label>\n";
  html += "<label>cut off above <input type=\"range\" id=\"clip\" step=\"0.01\"> "
          "<output id=\"clip-text\" for=\"clip\"></output></label>\n";
  html += "<fieldset><legend>colours</legend>\n" +
          radio("colour", "label", "parts", true) +
          radio("colour", "room", "rooms", false) + "</fieldset>\n";
  return html + "<button type=\"button\" id=\"from-above\">from above</button>\n"
                "<button type=\"button\" id=\"aslant\">aslant</button>\n</div>\n";
}

std::string
keyEntry(Colour colour, const std::string& meaning)
{
  return "<span class=\"entry\"><span class=\"swatch\" style=\"background:" +
         hexCode(colour) + "\"></span>" + meaning + "</span> ";
}

} // namespace

std::string
labelKey()
{
  std::string html = "<p class=\"key\">";
  for (const auto label :
       {StructureLabel::Ceiling, StructureLabel::Floor, StructureLabel::Wall,
        StructureLabel::Detail, StructureLabel::Column})
    html += keyEntry(colourOf(label), toString(label));
  return html + "</p>\n";
}

std::string
distanceKey(double range)
{
  constexpr int steps = 5;
  std::string html = "<p class=\"key\">";
  for (int k = 0; k <= steps; ++k) {
    const double distance = range * k / steps;
    html += keyEntry(distanceColour(distance, range),
                     distanceText(distance) + (k == steps ? " or more" : ""));
  }
  return html + "</p>\n";
}

std::string
modelPart(const ResultFolder& folder,
          const TriangleMesh& mesh,
          const TriangleMesh& solid,
          const Floorplan& plan,
          const PageSettings& settings)
{
  if (mesh.empty() && solid.empty())
    return "";
  const std::string three = threeScripts(settings.three);
  if (three.empty())
    return htmlSection(
        "model", "Model",
        "<p class=\"note\">The model cannot be turned on this page: three.js was not "
        "found where the page was written (" +
            escaped(settings.three) +
            "; Debian's package libjs-three). The pictures below show it.</p>\n");
  std::string models;
  std::string note;
  if (!solid.empty())
    models +=
        embedded("solid", folder.has("model.glb") ? textOfFile(folder.file("model.glb"))
                                                  : meshToGlb(solid, plan));
  if (!mesh.empty()) {
    const TriangleMesh reduced = reducedMesh(mesh, settings.max_triangles);
    models += embedded("mesh", meshToGlb(reduced, plan));
    if (reduced.triangles.size() < mesh.triangles.size())
      note = "<p class=\"note\">The mesh is thinned for this page, from " +
             numberText(static_cast<double>(mesh.triangles.size()), 0) + " to " +
             numberText(static_cast<double>(reduced.triangles.size()), 0) +
             " triangles: mesh.ply has them all.</p>\n";
  }
  return htmlSection(
      "model", "Model",
      "<div class=\"interactive\">\n" + controls(!solid.empty(), !mesh.empty()) +
          "<div id=\"view\"></div>\n<p class=\"note\">Turn: left button or one finger. "
          "Shift: right button or two fingers. Nearer: wheel or two fingers.</p>\n" +
          labelKey() + note +
          "</div>\n<p id=\"view-problem\" class=\"note\" hidden></p>\n" +
          "<noscript><p class=\"note\">Scripts are off, so the model cannot be turned; "
          "the pictures below show it.</p></noscript>\n"
          "<script type=\"application/json\" id=\"palettes\">" +
          palettes() + "</script>\n" + models + three + "<script>" + page_script +
          "</script>\n");
}

} // namespace pcl::sedr::tools
