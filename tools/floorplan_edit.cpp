// SPDX-License-Identifier: BSD-3-Clause
#include "bytes/whole_file.h"
#include "plan_file.h"
#include "run_tool.h"
#include "tool_error.h"

#include <pcl/sedr_filters/floorplan_io.h>
#include <pcl/sedr_filters/plan_editor.h>

#include <algorithm>
#include <charconv>
#include <string>
#include <utility>
#include <vector>

using namespace pcl::sedr::tools;
using pcl::sedr::PlanEditor;

namespace {

/** @brief Returns the parts of a text between separators. */
std::vector<std::string>
partsOf(const std::string& text, char separator)
{
  std::vector<std::string> parts;
  for (std::size_t at = 0; !text.empty() && at <= text.size();) {
    const std::size_t end = std::min(text.find(separator, at), text.size());
    parts.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return parts;
}

/** @brief Returns a number; throws ToolError with what was asked for. */
template <typename Number>
Number
numberOf(const std::string& text, const std::string& wanted)
{
  Number number{};
  const auto end = std::from_chars(text.data(), text.data() + text.size(), number);
  if (end.ec != std::errc() || end.ptr != text.data() + text.size())
    throw ToolError("'" + text + "' is no number; " + wanted);
  return number;
}

/** @brief Returns numbers between separators. */
template <typename Number>
std::vector<Number>
numbersOf(const std::string& text,
          char separator,
          std::size_t count,
          const std::string& wanted)
{
  std::vector<Number> numbers;
  for (const std::string& part : partsOf(text, separator))
    numbers.push_back(numberOf<Number>(part, wanted));
  if (numbers.size() != count)
    throw ToolError("'" + text + "' has " + std::to_string(numbers.size()) +
                    " numbers; " + wanted);
  return numbers;
}

std::pair<std::string, std::string>
halvesOf(const std::string& text, const std::string& wanted)
{
  const std::size_t at = text.find('=');
  if (at == std::string::npos)
    throw ToolError("'" + text + "' has no =; " + wanted);
  return {text.substr(0, at), text.substr(at + 1)};
}

struct Edits {
  std::string move;
  std::string square;
  std::string split;
  std::string merge;
  std::string drop;
  std::string name;
};

/** @brief Applies all edits; throws ToolError with the first that fails. */
void
apply(const Edits& edits, PlanEditor& editor)
{
  const auto done = [&](bool is_done, const std::string& edit) {
    if (!is_done)
      throw ToolError(edit + ": " + editor.getErrorMessage());
  };
  for (const std::string& edit : partsOf(edits.move, ';')) {
    const std::string wanted = "--move-wall wants ROOM.WALL=METRES, such as 3.12=0.05";
    const auto [wall, distance] = halvesOf(edit, wanted);
    const auto numbers = numbersOf<std::uint32_t>(wall, '.', 2, wanted);
    done(editor.moveWall(numbers[0], numbers[1], numberOf<double>(distance, wanted)),
         "--move-wall " + edit);
  }
  for (const std::string& edit : partsOf(edits.square, ';'))
    done(editor.square(numberOf<std::uint32_t>(edit, "--square wants a room")),
         "--square " + edit);
  for (const std::string& edit : partsOf(edits.split, ';')) {
    const std::string wanted = "--split wants ROOM,X1,Y1,X2,Y2";
    const std::size_t comma = std::min(edit.find(','), edit.size() - 1);
    const auto n = numbersOf<double>(edit.substr(comma + 1), ',', 4, wanted);
    done(editor.split(numberOf<std::uint32_t>(edit.substr(0, comma), wanted),
                      {n[0], n[1]}, {n[2], n[3]}),
         "--split " + edit);
  }
  for (const std::string& edit : partsOf(edits.merge, ';')) {
    const auto n = numbersOf<std::uint32_t>(edit, ',', 2, "--merge wants ROOM,ROOM");
    done(editor.merge(n[0], n[1]), "--merge " + edit);
  }
  for (const std::string& edit : partsOf(edits.drop, ';'))
    done(editor.drop(numberOf<std::uint32_t>(edit, "--drop wants a room")),
         "--drop " + edit);
  for (const std::string& edit : partsOf(edits.name, ';')) {
    const std::string wanted = "--name wants ROOM=TEXT, such as 3=Kitchen";
    const auto [room, text] = halvesOf(edit, wanted);
    done(editor.name(numberOf<std::uint32_t>(room, wanted), text), "--name " + edit);
  }
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
