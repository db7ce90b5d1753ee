// SPDX-License-Identifier: BSD-3-Clause
#include "bytes/whole_file.h"
#include "edit/edited_model.h"
#include "plan_file.h"
#include "run_tool.h"
#include "tool_error.h"

#include <pcl/sedr_filters/floorplan_io.h>
#include <pcl/sedr_filters/plan_editor.h>

#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iostream>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

using namespace pcl::sedr::tools;
using pcl::sedr::OpeningChange;
using pcl::sedr::OpeningKind;
using pcl::sedr::PlanEditor;

namespace {

constexpr const char* none = "none"; // an option that is not given

/** @brief Thrown by the text of an edit that has another form. */
struct OtherForm {};

void
require(bool is_so)
{
  if (!is_so)
    throw OtherForm();
}

/** @brief The text of an edit, whose parts are taken off its front. */
class EditText {
public:
  /** @param ends the characters after its parts; the last part has none */
  EditText(std::string text, const char* ends)
      : text_(std::move(text))
      , ends_(ends)
  {}

  /** @brief Takes a part: the number of a room, wall or storey, a length, a place of
   * two parts, or any text. */
  template <typename Part>
  Part take()
  {
    if constexpr (std::is_same_v<Part, std::string>)
      return next();
    else if constexpr (std::is_same_v<Part, double>) {
      const std::string text = next();
      char* rest = nullptr;
      const double length = std::strtod(text.c_str(), &rest);
      require(rest != text.c_str() && *rest == 0 && std::isfinite(length));
      return length;
    }
    else if constexpr (std::is_same_v<Part, Eigen::Vector2d>) {
      const double x = take<double>();
      return {x, take<double>()};
    }
    else {
      constexpr std::size_t most = 9; // digits
      const std::string digits = next();
      require(!digits.empty() && digits.size() <= most &&
              digits.find_first_not_of("0123456789") == std::string::npos);
      return static_cast<Part>(std::stoul(digits));
    }
  }

private:
  std::string next()
  {
    const std::size_t size = *ends_ == 0 ? text_.size() : text_.find(*ends_++);
    require(size != std::string::npos);
    std::string part = text_.substr(0, size);
    text_.erase(0, size + 1);
    return part;
  }

  std::string text_;
  const char* ends_;
};

/** @brief Returns a value by its name. */
template <typename Value>
Value
named(const std::string& name, const std::map<std::string, Value>& values)
{
  const auto value = values.find(name);
  require(value != values.end());
  return value->second;
}

/** @brief Reads what is told of an opening, such as "width=0.9,kind=door".
 * @param lengths by their names, beside those of `to` */
void
readOpening(const std::string& text,
            OpeningChange& to,
            std::map<std::string, std::optional<double>*> lengths = {})
{
  lengths.insert({{"width", &to.width}, {"height", &to.height}, {"sill", &to.sill}});
  std::istringstream list(text);
  for (std::string one; std::getline(list, one, ',');) {
    EditText parts(one, "=");
    const auto key = parts.take<std::string>();
    if (key == "kind")
      to.kind = named<OpeningKind>(parts.take<std::string>(),
                                   {{"door", OpeningKind::Door},
                                    {"window", OpeningKind::Window},
                                    {"passage", OpeningKind::Passage}});
    else if (key == "hinge")
      to.leaf = parts.take<std::string>();
    else if (key == "swing")
      to.swing = parts.take<std::uint32_t>();
    else
      *named(key, lengths) = parts.take<double>();
  }
}

using Edit = std::function<bool(PlanEditor&, const std::string&)>;

/** @brief Returns an edit whose text has the arguments of a method.
 * @param ends the characters after them */
template <typename... Arguments>
Edit
by(bool (PlanEditor::*method)(Arguments...), const char* ends)
{
  return [method, ends](PlanEditor& editor, const std::string& edit) {
    EditText text(edit, ends);
    const std::tuple<std::decay_t<Arguments>...> told{
        text.take<std::decay_t<Arguments>>()...};
    return std::apply([&](const auto&... part) { return (editor.*method)(part...); },
                      told);
  };
}

bool
addOpening(PlanEditor& editor, const std::string& edit)
{
  EditText text(edit, ".,");
  const auto room = text.take<std::uint32_t>();
  const auto wall = text.take<std::size_t>();
  std::optional<double> at;
  OpeningChange size;
  readOpening(text.take<std::string>(), size, {{"at", &at}});
  require(at && size.width && size.height);
  return editor.addOpening(room, wall, *at, size);
}

bool
setOpening(PlanEditor& editor, const std::string& edit)
{
  EditText text(edit, ",");
  const auto mark = text.take<std::string>();
  const auto told = text.take<std::string>();
  if (told == "kind=none")
    return editor.closeOpening(mark);
  OpeningChange change;
  readOpening(told, change);
  return editor.setOpening(mark, change);
}

bool
removePart(PlanEditor& editor, const std::string& part)
{
  require(part.rfind("room_", 0) == 0);
  return editor.remove(part);
}

/** @brief A kind of edit. */
struct Kind {
  const char* option;
  const char* help;
  const char* wanted; ///< form of an edit
  Edit edit;
};

const std::vector<Kind>&
kindsOfEdits()
{
  static const std::vector<Kind> kinds{
      {"move-wall",
       "ROOM.WALL=METRES: move a straight wall outwards, inwards below 0; walls beside "
       "it may vanish",
       "ROOM.WALL=METRES, such as 3.12=0.05", by(&PlanEditor::moveWall, ".=")},
      {"remove-jog",
       "ROOM.WALL: remove the jog that a wall makes, or the notch or bay that it ends",
       "ROOM.WALL, such as 3.12", by(&PlanEditor::removeJog, ".")},
      {"square", "ROOM: make its nearly square corners square", "a room",
       by(&PlanEditor::square, "")},
      {"add-opening",
       "ROOM.WALL,at=M,width=M,height=M: add an opening whose middle is so many metres "
       "from the wall's first end; sill=0, kind=door and more keys of --opening",
       "ROOM.WALL,at=METRES,width=METRES,height=METRES, perhaps with sill=, kind=, "
       "hinge=, swing=",
       addOpening},
      {"split", "ROOM,X1,Y1,X2,Y2: part a room along a line", "ROOM,X1,Y1,X2,Y2",
       by(&PlanEditor::split, ",,,,")},
      {"merge", "ROOM,ROOM: join the second room to the first", "ROOM,ROOM",
       by(&PlanEditor::merge, ",")},
      {"drop", "ROOM: remove a room", "a room", by(&PlanEditor::drop, "")},
      {"remove",
       "PART: remove a column, platform (floor_detail), beam or coffer (detail) or "
       "niche, by its name in the solid: room_3_column_1",
       "the name of a part, such as room_3_column_1", removePart},
      {"floor", "ROOM=Z: set the height of a floor, metres", "ROOM=Z",
       by(&PlanEditor::setFloor, "=")},
      {"ceiling", "ROOM=Z: set the height of a ceiling, metres", "ROOM=Z",
       by(&PlanEditor::setCeiling, "=")},
      {"storey", "STOREY=Z: move all of a storey to where its usual floor is at Z",
       "STOREY=Z", by(&PlanEditor::setStorey, "=")},
      {"opening",
       "NUMBER,KEY=VALUE,...: change an opening, such as D3; keys are width, height, "
       "sill (metres), kind, hinge (left, right, double, none), swing (the room it "
       "opens into); kind=none closes it",
       "NUMBER and some of width=, height=, sill=, kind=, hinge=, swing=, such as "
       "D3,width=0.9",
       setOpening},
      {"confirm",
       "NUMBER: somebody looked at this wall or opening and it is right: it counts as "
       "sure",
       "the number of a wall or opening, such as 3.12 or D3",
       by(&PlanEditor::confirm, "")},
      {"name", "ROOM=TEXT: name a room", "ROOM=TEXT, such as 3=Kitchen",
       by(&PlanEditor::name, "=")}};
  return kinds;
}

/** @brief The options that change a plan, of pcl_floorplan_edit. */
class EditOptions {
public:
  explicit EditOptions(Options& options)
      : given_(kindsOfEdits().size(), none)
  {
    for (std::size_t k = 0; k < given_.size(); ++k)
      options.text(kindsOfEdits()[k].option, given_[k], kindsOfEdits()[k].help);
  }

  /** @brief Returns whether any edit is given. */
  bool isGiven() const
  {
    return std::any_of(given_.begin(), given_.end(),
                       [](const std::string& edits) { return edits != none; });
  }

  /** @brief Makes all edits, kind by kind. Throws ToolError with the first that fails.
   * @return what each did, a sentence with numbers */
  std::vector<std::string> apply(PlanEditor& editor) const
  {
    std::vector<std::string> done;
    std::vector<std::string> warnings; // told if no edit fails
    for (std::size_t k = 0; k < given_.size(); ++k) {
      if (given_[k] == none)
        continue;
      const Kind& kind = kindsOfEdits()[k];
      const std::string option = "--" + std::string(kind.option) + " ";
      std::istringstream list(given_[k].empty() ? ";" : given_[k]);
      for (std::string edit; std::getline(list, edit, ';');) {
        boost::algorithm::trim(edit);
        try {
          if (!kind.edit(editor, edit))
            throw ToolError(option + edit + ": " + editor.getErrorMessage());
        }
        catch (const OtherForm&) {
          throw ToolError("'" + edit + "': " + option + "wants " + kind.wanted);
        }
        done.push_back(editor.getSentence());
        for (const std::string& warning : editor.getWarnings()) {
          done.back() += "; " + warning;
          warnings.push_back(option + edit + ": " + warning);
        }
      }
    }
    if (editor.getFloorplan().rooms.empty())
      throw ToolError("no room is left");
    for (const std::string& warning : warnings)
      warn(warning);
    return done;
  }

private:
  std::vector<std::string> given_; ///< by kind; several, parted by semicolons
};

} // namespace

int
main(int argc, char** argv)
{
  std::string plan;
  std::string output;
  bool undo = false;
  Options options(
      "pcl_floorplan_edit",
      "Changes a floor plan by hand. Of a folder of pcl_sedr, all files that follow "
      "from the plan are written anew.\n"
      "Several edits of a kind are parted by semicolons: --merge \"3,5;7,8\". "
      "Kinds are done in the\n"
      "order below, so numbers of walls are those of the plan.");
  options.file("MODEL", plan,
               "folder of pcl_sedr, or a floor plan, as pcl_sedr and "
               "pcl_floorplan_fitting write it");
  options.optionalFile("OUTPUT.json", output,
                       "changed floor plan to write, if MODEL is one");
  const EditOptions edits(options);
  options.flag("undo", undo, "take back the last edits of a folder instead");
  return runTool(options, argc, argv, [&] {
    const bool is_folder = std::filesystem::is_directory(plan);
    if (!std::filesystem::exists(plan))
      throw ToolError("there is no folder or floor plan '" + plan + "'");
    if (is_folder != output.empty())
      throw ToolError(is_folder
                          ? "the files of a folder are written in it, there is no "
                            "'" +
                                output + "' to write"
                          : "the name of the changed floor plan is missing");
    if (undo && (edits.isGiven() || !is_folder))
      throw ToolError("--undo is for a folder and takes no edits");
    if (!undo && !edits.isGiven())
      throw ToolError("there is no edit to do, such as --name 3=Kitchen; "
                      "pcl_floorplan_edit -h tells all");
    std::vector<std::string> done;
    const auto edit = [&](PlanEditor& editor) { return done = edits.apply(editor); };
    if (is_folder) {
      const auto kept = undo ? undoEdit(plan) : editModel(plan, edit);
      done.push_back((undo ? "the plan is the one before the last edits; " : "") +
                     std::string("all files that follow from the plan are written") +
                     (kept.empty() ? ""
                                   : ", still of the scan: " +
                                         boost::algorithm::join(kept, ", ")));
    }
    else {
      checkOutput(output, "a floor plan", {".json"});
      pcl::sedr::PlanDocument document = loadPlan(plan);
      PlanEditor editor(std::move(document.plan), document.max_wall);
      edit(editor);
      document.plan = editor.getFloorplan();
      writeWhole(output, documentToJson(document));
    }
    for (const std::string& sentence : done)
      std::cout << sentence << '\n';
    std::cout << std::flush;
    return Done;
  });
}
