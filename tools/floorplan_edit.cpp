// SPDX-License-Identifier: BSD-3-Clause
#include "bytes/whole_file.h"
#include "plan_file.h"
#include "run_tool.h"
#include "tool_error.h"

#include <pcl/sedr_filters/floorplan_io.h>
#include <pcl/sedr_filters/plan_editor.h>

#include <cstdio>
#include <sstream>
#include <string>

using namespace pcl::sedr::tools;
using pcl::sedr::PlanEditor;

namespace {

struct Edits {
  std::string move;
  std::string square;
  std::string split;
  std::string merge;
  std::string drop;
  std::string name;
};

/** @brief Calls `read` for each edit of an option, which applies it; throws ToolError
 * unless the edit begins with the number of a room and is read to its end. */
template <typename Read>
void
forEachEdit(const std::string& edits, const std::string& wanted, const Read& read)
{
  std::istringstream list(edits);
  for (std::string edit; std::getline(list, edit, ';');) {
    int end = 0; // of what was read
    if (edit.empty() || edit[0] < '0' || edit[0] > '9' || !read(edit, end) ||
        static_cast<std::size_t>(end) != edit.size())
      throw ToolError("'" + edit + "': " + wanted);
  }
}

/** @brief Applies all edits; throws ToolError with the first that fails. */
void
apply(const Edits& edits, PlanEditor& editor)
{
  unsigned a = 0;
  unsigned b = 0;
  double x[4];
  const auto done = [&](bool is_done, const std::string& edit) {
    if (!is_done)
      throw ToolError(edit + ": " + editor.getErrorMessage());
    return true;
  };
  const auto readsRoom = [&a](const std::string& edit, int& end) {
    return std::sscanf(edit.c_str(), "%9u%n", &a, &end) == 1;
  };
  forEachEdit(edits.move, "--move-wall wants ROOM.WALL=METRES, such as 3.12=0.05",
              [&](const std::string& edit, int& end) {
                return std::sscanf(edit.c_str(), "%9u.%9u=%lf%n", &a, &b, x, &end) ==
                           3 &&
                       done(editor.moveWall(a, b, x[0]), "--move-wall " + edit);
              });
  forEachEdit(
      edits.square, "--square wants a room", [&](const std::string& edit, int& end) {
        return readsRoom(edit, end) && done(editor.square(a), "--square " + edit);
      });
  forEachEdit(edits.split, "--split wants ROOM,X1,Y1,X2,Y2",
              [&](const std::string& edit, int& end) {
                return std::sscanf(edit.c_str(), "%9u,%lf,%lf,%lf,%lf%n", &a, x, x + 1,
                                   x + 2, x + 3, &end) == 5 &&
                       done(editor.split(a, {x[0], x[1]}, {x[2], x[3]}),
                            "--split " + edit);
              });
  forEachEdit(edits.merge, "--merge wants ROOM,ROOM",
              [&](const std::string& edit, int& end) {
                return std::sscanf(edit.c_str(), "%9u,%9u%n", &a, &b, &end) == 2 &&
                       edit.find('-') == std::string::npos &&
                       done(editor.merge(a, b), "--merge " + edit);
              });
  forEachEdit(edits.drop, "--drop wants a room",
              [&](const std::string& edit, int& end) {
                return readsRoom(edit, end) && done(editor.drop(a), "--drop " + edit);
              });
  forEachEdit(edits.name, "--name wants ROOM=TEXT, such as 3=Kitchen",
              [&](const std::string& edit, int& end) {
                const int read = std::sscanf(edit.c_str(), "%9u=%n", &a, &end);
                const std::string text = edit.substr(static_cast<std::size_t>(end));
                const bool is_read = read == 1 && end > 0;
                end = static_cast<int>(edit.size());
                return is_read && done(editor.name(a, text), "--name " + edit);
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
