// SPDX-License-Identifier: BSD-3-Clause
#include "edit_options.h"

#include "run_tool.h"
#include "tool_error.h"

#include <boost/algorithm/string/trim.hpp>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <sstream>

namespace pcl::sedr::tools {

namespace {

constexpr const char* none = "none"; // an option that is not given

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

/** @brief Reads what is told of an opening, such as "width=0.9,kind=door".
 * @param[out] at its place along a wall, if that is told */
bool
readOpening(const std::string& text, OpeningChange& to, std::array<double, 1>& at)
{
  to = {};
  std::array<double, 1> number{};
  const std::map<std::string, std::optional<double>*> lengths{{"width", &to.width},
                                                              {"height", &to.height},
                                                              {"sill", &to.sill}};
  std::istringstream list(text);
  for (std::string one; std::getline(list, one, ',');) {
    const std::size_t equals = std::min(one.find('='), one.size());
    const std::string key = one.substr(0, equals);
    std::string value = one.substr(std::min(equals + 1, one.size()));
    const auto length = lengths.find(key);
    unsigned room = 0;
    if (length != lengths.end() && readLengths(value, number))
      *length->second = number[0];
    else if (key == "at" && readLengths(value, number))
      at = number;
    else if (key == "kind" && kindNamed(value) != OpeningKind::Unknown)
      to.kind = kindNamed(value);
    else if (key == "hinge" && (value == "left" || value == "right" ||
                                value == "double" || value == none))
      to.leaf = value;
    else if (key == "swing" && takeNumber(value, "", room) && value.empty())
      to.swing = room;
    else
      return false;
  }
  return !text.empty();
}

} // namespace

EditOptions::EditOptions()
{
  const auto readRoom = [this](std::string& text) {
    return takeNumber(text, "", a_) && text.empty();
  };
  const auto readWall = [this](std::string& text) {
    return takeNumber(text, ".", a_) && takeNumber(text, "", b_) && text.empty();
  };
  const auto readHeight = [this](std::string& text) {
    return takeNumber(text, "=", a_) && readLengths(text, length_);
  };
  const auto readMark = [this](std::string& text) {
    const std::size_t end = std::min(text.find(','), text.size());
    mark_ = text.substr(0, end);
    text.erase(0, end + 1);
    return text == "kind=none" || readOpening(text, opening_, length_);
  };
  kinds_ = {
      {"move-wall",
       "ROOM.WALL=METRES: move a straight wall outwards, inwards below 0; walls beside "
       "it may vanish",
       "ROOM.WALL=METRES, such as 3.12=0.05",
       [this](std::string& text) {
         return takeNumber(text, ".", a_) && takeNumber(text, "=", b_) &&
                readLengths(text, length_);
       },
       [this](PlanEditor& editor, const std::string&) {
         return editor.moveWall(a_, b_, length_[0]);
       },
       none},
      {"remove-jog",
       "ROOM.WALL: remove the jog that a wall makes, or the notch or bay that it ends",
       "ROOM.WALL, such as 3.12", readWall,
       [this](PlanEditor& editor, const std::string&) {
         return editor.removeJog(a_, b_);
       },
       none},
      {"square", "ROOM: make its nearly square corners square", "a room", readRoom,
       [this](PlanEditor& editor, const std::string&) { return editor.square(a_); },
       none},
      {"add-opening",
       "ROOM.WALL,at=M,width=M,height=M: add an opening whose middle is so many metres "
       "from the wall's first end; sill=0, kind=door and more keys of --opening",
       "ROOM.WALL,at=METRES,width=METRES,height=METRES, perhaps with sill=, kind=, "
       "hinge=, swing=",
       [this](std::string& text) {
         length_[0] = -1;
         return takeNumber(text, ".", a_) && takeNumber(text, ",", b_) &&
                readOpening(text, opening_, length_) && length_[0] >= 0 &&
                opening_.width && opening_.height;
       },
       [this](PlanEditor& editor, const std::string&) {
         return editor.addOpening(a_, b_, length_[0], opening_);
       },
       none},
      {"split", "ROOM,X1,Y1,X2,Y2: part a room along a line", "ROOM,X1,Y1,X2,Y2",
       [this](std::string& text) {
         return takeNumber(text, ",", a_) && readLengths(text, line_);
       },
       [this](PlanEditor& editor, const std::string&) {
         return editor.split(a_, {line_[0], line_[1]}, {line_[2], line_[3]});
       },
       none},
      {"merge", "ROOM,ROOM: join the second room to the first", "ROOM,ROOM",
       [this](std::string& text) {
         return takeNumber(text, ",", a_) && takeNumber(text, "", b_) && text.empty();
       },
       [this](PlanEditor& editor, const std::string&) { return editor.merge(a_, b_); },
       none},
      {"drop", "ROOM: remove a room", "a room", readRoom,
       [this](PlanEditor& editor, const std::string&) { return editor.drop(a_); },
       none},
      {"remove",
       "PART: remove a column, platform (floor_detail), beam or coffer (detail) or "
       "niche, by its name in the solid: room_3_column_1",
       "the name of a part, such as room_3_column_1",
       [](std::string& text) { return text.rfind("room_", 0) == 0; },
       [](PlanEditor& editor, const std::string& part) { return editor.remove(part); },
       none},
      {"floor", "ROOM=Z: set the height of a floor, metres", "ROOM=Z", readHeight,
       [this](PlanEditor& editor, const std::string&) {
         return editor.setFloor(a_, length_[0]);
       },
       none},
      {"ceiling", "ROOM=Z: set the height of a ceiling, metres", "ROOM=Z", readHeight,
       [this](PlanEditor& editor, const std::string&) {
         return editor.setCeiling(a_, length_[0]);
       },
       none},
      {"storey", "STOREY=Z: move all of a storey to where its usual floor is at Z",
       "STOREY=Z", readHeight,
       [this](PlanEditor& editor, const std::string&) {
         return editor.setStorey(a_, length_[0]);
       },
       none},
      {"opening",
       "NUMBER,KEY=VALUE,...: change an opening, such as D3; keys are width, height, "
       "sill (metres), kind, hinge (left, right, double, none), swing (the room it "
       "opens "
       "into); kind=none closes it",
       "NUMBER and some of width=, height=, sill=, kind=, hinge=, swing=, such as "
       "D3,width=0.9",
       readMark,
       [this](PlanEditor& editor, const std::string& change) {
         return change == "kind=none" ? editor.closeOpening(mark_)
                                      : editor.setOpening(mark_, opening_);
       },
       none},
      {"name", "ROOM=TEXT: name a room", "ROOM=TEXT, such as 3=Kitchen",
       [this](std::string& text) { return takeNumber(text, "=", a_); },
       [this](PlanEditor& editor, const std::string& text) {
         return editor.name(a_, text);
       },
       none}};
}

void
EditOptions::declare(Options& options)
{
  for (Kind& kind : kinds_)
    options.text(kind.option, kind.given, kind.help);
}

bool
EditOptions::isGiven() const
{
  return std::any_of(kinds_.begin(), kinds_.end(),
                     [](const Kind& kind) { return kind.given != none; });
}

std::vector<std::string>
EditOptions::apply(PlanEditor& editor)
{
  std::vector<std::string> done;
  std::vector<std::string> warnings; // told if no edit fails
  for (const Kind& kind : kinds_) {
    if (kind.given == none)
      continue;
    const std::string option = "--" + std::string(kind.option) + " ";
    std::istringstream list(kind.given.empty() ? ";" : kind.given);
    for (std::string edit; std::getline(list, edit, ';');) {
      boost::algorithm::trim(edit);
      std::string rest = edit;
      if (!kind.read(rest))
        throw ToolError("'" + edit + "': " + option + "wants " + kind.wanted);
      if (!kind.apply(editor, rest))
        throw ToolError(option + edit + ": " + editor.getErrorMessage());
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

} // namespace pcl::sedr::tools
