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
#include <sstream>
#include <string>

using namespace pcl::sedr::tools;
using pcl::sedr::PlanEditor;

namespace {

constexpr const char* none = "none"; // an option that is not given

struct Edits {
  std::string move = none;
  std::string square = none;
  std::string split = none;
  std::string merge = none;
  std::string drop = none;
  std::string name = none;
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

/** @brief Calls `read` for each edit of an option, which applies it; throws ToolError
 * if it is none. */
template <typename Read>
void
forEachEdit(const std::string& edits, const std::string& wanted, const Read& read)
{
  if (edits == none)
    return;
  std::istringstream list(edits.empty() ? ";" : edits);
  for (std::string edit; std::getline(list, edit, ';');)
    if (!read(edit))
      throw ToolError("'" + edit + "': " + wanted);
}

/** @brief Applies all edits; throws ToolError with the first that fails. */
void
apply(const Edits& edits, PlanEditor& editor)
{
  unsigned a = 0;
  unsigned b = 0;
  std::array<double, 1> out{};
  std::array<double, 4> line{};
  const auto done = [&](bool is_done, const std::string& edit) {
    if (!is_done)
      throw ToolError(edit + ": " + editor.getErrorMessage());
    return true;
  };
  const auto readsRoom = [&a](std::string edit) {
    return takeNumber(edit, "", a) && edit.empty();
  };
  forEachEdit(edits.move, "--move-wall wants ROOM.WALL=METRES, such as 3.12=0.05",
              [&](const std::string& edit) {
                std::string rest = edit;
                return takeNumber(rest, ".", a) && takeNumber(rest, "=", b) &&
                       readLengths(rest, out) &&
                       done(editor.moveWall(a, b, out[0]), "--move-wall " + edit);
              });
  forEachEdit(edits.square, "--square wants a room", [&](const std::string& edit) {
    return readsRoom(edit) && done(editor.square(a), "--square " + edit);
  });
  forEachEdit(edits.split, "--split wants ROOM,X1,Y1,X2,Y2",
              [&](const std::string& edit) {
                std::string rest = edit;
                return takeNumber(rest, ",", a) && readLengths(rest, line) &&
                       done(editor.split(a, {line[0], line[1]}, {line[2], line[3]}),
                            "--split " + edit);
              });
  forEachEdit(edits.merge, "--merge wants ROOM,ROOM", [&](const std::string& edit) {
    std::string rest = edit;
    return takeNumber(rest, ",", a) && takeNumber(rest, "", b) && rest.empty() &&
           done(editor.merge(a, b), "--merge " + edit);
  });
  forEachEdit(edits.drop, "--drop wants a room", [&](const std::string& edit) {
    return readsRoom(edit) && done(editor.drop(a), "--drop " + edit);
  });
  forEachEdit(edits.name, "--name wants ROOM=TEXT, such as 3=Kitchen",
              [&](const std::string& edit) {
                std::string text = edit;
                return takeNumber(text, "=", a) &&
                       done(editor.name(a, text), "--name " + edit);
              });
}

} // namespace

int
main(int argc, char** argv)
{
  std::string plan;
  std::string output;
  Edits edits;
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
  options.text("move-wall", edits.move,
               "ROOM.WALL=METRES: move a straight wall outwards, inwards below 0");
  options.text("square", edits.square, "ROOM: make its nearly square corners square");
  options.text("split", edits.split, "ROOM,X1,Y1,X2,Y2: part a room along a line");
  options.text("merge", edits.merge, "ROOM,ROOM: take out the wall between two rooms");
  options.text("drop", edits.drop, "ROOM: remove a room");
  options.text("name", edits.name, "ROOM=TEXT: name a room");
  return runTool(options, argc, argv, [&] {
    checkOutput(output, "a floor plan", {".json"});
    pcl::sedr::PlanDocument document = loadPlan(plan);
    PlanEditor editor(std::move(document.plan));
    apply(edits, editor);
    if (editor.getFloorplan().rooms.empty())
      throw ToolError("no room is left");
    document.plan = editor.getFloorplan();
    writeWhole(output,
               [&](std::ostream& stream) { stream << documentToJson(document); });
    return Done;
  });
}
