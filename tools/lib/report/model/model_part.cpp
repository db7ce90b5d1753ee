// SPDX-License-Identifier: BSD-3-Clause
#include "model_part.h"

#include "map_cells.h"
#include "mesh_reduction.h"
#include "model_data.h"
#include "report/page/html_text.h"
#include "report/page/page_files.h"
#include "results/distance_colour.h"

#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>

namespace pcl {
namespace sedr {
namespace tools {

namespace {

std::string
textOfFile(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/** @brief The scripts of three.js, empty where one is missing or would end its element.
 */
std::string
threeScripts(const std::string& folder)
{
  std::string scripts = "<!-- three.js: MIT licence, copyright its authors, "
                        "https&#58;//threejs.org -->\n";
  for (const char* name : {"/three.min.js", "/examples/js/controls/OrbitControls.js"}) {
    const std::string text = textOfFile(folder + name);
    if (text.empty() || text.find("</script") != std::string::npos)
      return "";
    scripts += "<script>" + text + "</script>\n";
  }
  return scripts;
}

std::string
codeOf(Colour c)
{
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", c.red, c.green, c.blue);
  return text;
}

std::string
codesOf(std::size_t count, Colour (*colour)(std::size_t))
{
  std::string list;
  for (std::size_t k = 0; k < count; ++k)
    list += (k == 0 ? "\"" : ",\"") + codeOf(colour(k)) + "\"";
  return "[" + list + "]";
}

Colour
colourOfLabel(std::size_t label)
{
  return colourOf(static_cast<StructureLabel>(label));
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
         codeOf(colour) + "\"></span>" + meaning + "</span> ";
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
modelPart(const TriangleMesh& mesh,
          const TriangleMesh& solid,
          const CeilingRule& rule,
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
    models += "\"solid\":" + modelData(solid, rule, true);
  if (!mesh.empty()) {
    const TriangleMesh reduced = reducedMesh(mesh, settings.most_triangles);
    models += (models.empty() ? "" : ",") + std::string("\"mesh\":") +
              modelData(reduced, rule, false);
    if (reduced.triangles.size() < mesh.triangles.size())
      note = "<p class=\"note\">The mesh is thinned for this page, from " +
             numberText(static_cast<double>(mesh.triangles.size()), 0) + " to " +
             numberText(static_cast<double>(reduced.triangles.size()), 0) +
             " triangles: mesh.ply has them all.</p>\n";
  }
  constexpr std::size_t label_count = 6;
  constexpr std::size_t room_colours = 12;
  const std::string data = "{\"label_colours\":" + codesOf(label_count, colourOfLabel) +
                           ",\"room_colours\":" + codesOf(room_colours, colourNumber) +
                           ",\"models\":{" + models + "}}";
  return htmlSection(
      "model", "Model",
      "<div class=\"interactive\">\n" + controls(!solid.empty(), !mesh.empty()) +
          "<div id=\"view\"></div>\n<p class=\"note\">Turn: left button or one finger. "
          "Shift: right button or two fingers. Nearer: wheel or two fingers.</p>\n" +
          labelKey() + note +
          "</div>\n<p id=\"view-problem\" class=\"note\" hidden></p>\n" +
          "<noscript><p class=\"note\">Scripts are off, so the model cannot be turned; "
          "the pictures below show it.</p></noscript>\n"
          "<script type=\"application/json\" id=\"model-data\">" +
          data + "</script>\n" + three + "<script>" + page_script + "</script>\n");
}

} // namespace tools
} // namespace sedr
} // namespace pcl
