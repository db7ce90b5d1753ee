// SPDX-License-Identifier: BSD-3-Clause
#include "bytes/whole_file.h"
#include "plan_file.h"
#include "run_tool.h"
#include "tool_error.h"

#include <pcl/sedr_filters/floorplan_io.h>
#include <pcl/sedr_filters/plan_editor.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

using namespace pcl::sedr::tools;
using pcl::sedr::OpeningKind;
using pcl::sedr::PlanEditor;

namespace {

constexpr const char* none = "none"; // an option that is not given

/** @brief A kind of edit. */
struct Kind {
  const char* option;
  const char* help;
  const char* wanted;                            ///< form of an edit
  std::function<bool(std::string&)> read;        ///< false: it has another form
  std::function<bool(const std::string&)> apply; ///< what is left of its text
  std::string given = none;                      ///< several, parted by semicolons
};

/** @brief Takes the number of a room or wall and what must follow it off the front of a
 * text. */
bool
takeNumber(std::string& text, const std::string& following, unsigned& number)
{
  constexpr std::size_t most = 9; // digits
  const std::size_t digits =
      std::min(text.find_first_not_of("0123456789"), text.size());
  if (digits == 0 || digits > most ||
      text.compare(digits, following.size(), following) != 0)
    return false;
  number = static_cast<unsigned>(std::stoul(text.substr(0, digits)));
  text.erase(0, digits + following.size());
  return true;
}

/** @brief Reads a text that is a list of lengths. */
template <std::size_t Count>
bool
readLengths(const std::string& text, std::array<double, Count>& lengths)
{
  const char* at = text.c_str();
  for (std::size_t i = 0; i < Count; ++i) {
    char* end = nullptr;
    lengths[i] = std::strtod(at, &end);
    if (end == at || *end != (i + 1 < Count ? ',' : '\0'))
      return false;
    at = end + 1;
  }
  return true;
}

/** @brief Returns the kind of opening that a text names, unknown if none. */
OpeningKind
kindNamed(const std::string& text)
{
  for (const OpeningKind kind :
       {OpeningKind::Door, OpeningKind::Window, OpeningKind::Passage})
    if (text == nameOf(kind))
      return kind;
  return OpeningKind::Unknown;
}

/** @brief Applies all edits of a kind; throws ToolError with the first that fails. */
void
apply(const Kind& kind, const PlanEditor& editor)
{
  const std::string option = "--" + std::string(kind.option) + " ";
  std::istringstream list(kind.given.empty() ? ";" : kind.given);
  for (std::string edit; std::getline(list, edit, ';');) {
    std::string rest = edit;
    if (!kind.read(rest))
      throw ToolError("'" + edit + "': " + option + "wants " + kind.wanted);
    if (!kind.apply(rest))
      throw ToolError(option + edit + ": " + editor.getErrorMessage());
    for (const std::string& warning : editor.getWarnings())
      warn(option + edit + ": " + warning);
  }
}

} // namespace

int
main(int argc, char** argv)
{
  std::string plan;
  std::string output;
  PlanEditor editor{pcl::sedr::Floorplan()};
  unsigned a = 0; // what an edit tells
  unsigned b = 0;
  std::array<double, 1> out{};
  std::array<double, 4> line{};
  std::array<double, 2> place{};
  const auto readRoom = [&](std::string& text) {
    return takeNumber(text, "", a) && text.empty();
  };
  std::vector<Kind> kinds{
      {"move-wall", "ROOM.WALL=METRES: move a straight wall outwards, inwards below 0",
       "ROOM.WALL=METRES, such as 3.12=0.05",
       [&](std::string& text) {
         return takeNumber(text, ".", a) && takeNumber(text, "=", b) &&
                readLengths(text, out);
       },
       [&](const std::string&) { return editor.moveWall(a, b, out[0]); }},
      {"square", "ROOM: make its nearly square corners square", "a room", readRoom,
       [&](const std::string&) { return editor.square(a); }},
      {"split", "ROOM,X1,Y1,X2,Y2: part a room along a line", "ROOM,X1,Y1,X2,Y2",
       [&](std::string& text) {
         return takeNumber(text, ",", a) && readLengths(text, line);
       },
       [&](const std::string&) {
         return editor.split(a, {line[0], line[1]}, {line[2], line[3]});
       }},
      {"merge", "ROOM,ROOM: take out the wall between two rooms", "ROOM,ROOM",
       [&](std::string& text) {
         return takeNumber(text, ",", a) && takeNumber(text, "", b) && text.empty();
       },
       [&](const std::string&) { return editor.merge(a, b); }},
      {"drop", "ROOM: remove a room", "a room", readRoom,
       [&](const std::string&) { return editor.drop(a); }},
      {"opening", "ROOM,X,Y=KIND: what the opening there is; none closes it",
       "ROOM,X,Y=KIND, a kind door, window, passage or none",
       [&](std::string& text) {
         const std::size_t equal = std::min(text.find('='), text.size());
         std::string where = text.substr(0, equal);
         text.erase(0, equal + 1);
         return takeNumber(where, ",", a) && readLengths(where, place) &&
                (text == "none" || kindNamed(text) != OpeningKind::Unknown);
       },
       [&](const std::string& kind) {
         const Eigen::Vector2d at(place[0], place[1]);
         return kind == "none" ? editor.closeOpening(a, at)
                               : editor.setOpening(a, at, kindNamed(kind));
       }},
      {"name", "ROOM=TEXT: name a room", "ROOM=TEXT, such as 3=Kitchen",
       [&](std::string& text) { return takeNumber(text, "=", a); },
       [&](const std::string& text) { return editor.name(a, text); }}};
  Options options(
      "pcl_floorplan_edit",
      "Changes a floor plan by hand; drawings, solid and IFC are made from "
      "the result without the scan.\n"
      "Several edits of a kind are parted by semicolons: --merge \"3,5;7,8\". "
      "Kinds are done in the\n"
      "order below, so numbers of walls are those of PLAN.json.");
  options.file("PLAN.json", plan,
               "floor plan, as pcl_sedr and pcl_floorplan_fitting write it");
  options.file("OUTPUT.json", output, "changed floor plan to write");
  for (Kind& kind : kinds)
    options.text(kind.option, kind.given, kind.help);
  return runTool(options, argc, argv, [&] {
    checkOutput(output, "a floor plan", {".json"});
    pcl::sedr::PlanDocument document = loadPlan(plan);
    editor = PlanEditor(std::move(document.plan));
    bool has_edit = false;
    for (const Kind& kind : kinds)
      if (kind.given != none) {
        apply(kind, editor);
        has_edit = true;
      }
    if (!has_edit)
      throw ToolError("there is no edit to do, such as --name 3=Kitchen; "
                      "pcl_floorplan_edit -h tells all");
    if (editor.getFloorplan().rooms.empty())
      throw ToolError("no room is left");
    document.plan = editor.getFloorplan();
    writeWhole(output, documentToJson(document));
    return Done;
  });
}
